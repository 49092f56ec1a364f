#pragma once

namespace judging {

/// One-sided binomial tests: at a level of 1 % a diagnoser that is truly at the target fails one
/// bar's run in a hundred. For seeds that nobody has seen, in every run of CI, that is too often.
constexpr double usual_level = 0.01;

/// Largest count of n that does not speak against "rate <= target":  P(X >= k) >= level.
int most_allowed(int n, double target, double level = usual_level);
/// Smallest count of n that does not speak against "rate >= target":  P(X <= k) >= level.
int least_allowed(int n, double target, double level = usual_level);

} // namespace judging
