#pragma once

namespace judging {

/// One-sided binomial tests at 1 %: a diagnoser that is truly at the target fails one bar's run in
/// a hundred.
constexpr double test_level = 0.01;

/// Largest count of n that does not speak against "rate <= target":  P(X >= k) >= 1 %.
int most_allowed(int n, double target);
/// Smallest count of n that does not speak against "rate >= target":  P(X <= k) >= 1 %.
int least_allowed(int n, double target);

} // namespace judging
