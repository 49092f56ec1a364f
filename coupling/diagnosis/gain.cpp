#include "coupling/diagnosis/gain.hpp"

#include "coupling/diagnosis/tolerances.hpp"
#include "coupling/diagnosis/whitening.hpp"
#include "dem/expect.hpp"
#include "dem/packing/random_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_runs = 3; // for an interval by resampling
constexpr double normal_95 = 1.959963984540054;

void validate(HeldOutRun const& run) {
  auto const n = run.measured.size();
  for (auto const* one : {&run.before, &run.after})
    VALIDATE(
        n > 0 && one->value.size() == n && one->covariance.rows() == n &&
            one->covariance.cols() == n && static_cast<Index>(run.channels.size()) == n,
        fmt::format("{}: has {} measured rows, {} channels, {} foretold. Do they stand side by "
                    "side?",
                    run.run, n, run.channels.size(), one->value.size()));
  VALIDATE(
      run.measured.allFinite() && run.before.value.allFinite() && run.after.value.allFinite(),
      fmt::format("{}: holds a value that is no number. Should that row be left out?", run.run));
}

/// ln N(measured | after) - ln N(measured | before), and what it would scatter by were the run
/// pressed again and nothing wrong with the model before.
struct Score {
  double difference, variance;
};

/// With y = f_b + L_b e, e white:  2 D = e' (I - M) e - 2 g' e + constant,  M = N' N,
/// N = L_a^-1 L_b, g = N' L_a^-1 (f_b - f_a);  so  var D = tr (M - I)^2 / 2 + g' g.
Score score_of(HeldOutRun const& run) {
  Whitener const before(run.before.covariance, Tolerances{}.largest_jitter);
  Whitener const after(run.after.covariance, Tolerances{}.largest_jitter);
  auto const n = run.measured.size();
  double const chi_squared = before.whiten(run.measured - run.before.value).squaredNorm() -
                             after.whiten(run.measured - run.after.value).squaredNorm();
  double const difference =
      0.5 * (chi_squared + (before.log_determinant() - after.log_determinant()));
  MatrixXd const N = after.whiten(before.unwhiten(MatrixXd::Identity(n, n)));
  MatrixXd const apart = N.transpose() * N - MatrixXd::Identity(n, n);
  VectorXd const g = N.transpose() * after.whiten(run.before.value - run.after.value);
  return {difference, 0.5 * apart.squaredNorm() + g.squaredNorm()};
}

void add_scores(std::vector<HeldOutRun> const& runs, Gain& gain) {
  double variance = 0.0;
  VectorXd of_runs(static_cast<Index>(runs.size()));
  for (std::size_t k = 0; k < runs.size(); ++k) {
    auto const score = score_of(runs[k]);
    of_runs[static_cast<Index>(k)] = score.difference;
    variance += score.variance;
  }
  auto const n = static_cast<double>(runs.size());
  gain.elpd_difference = of_runs.sum();
  if (runs.size() >= fewest_runs)
    variance =
        std::max(variance, n / (n - 1.0) * (of_runs.array() - of_runs.mean()).square().sum());
  gain.elpd_error = std::sqrt(variance);
}

/// Sums over the rows of one run and channel.
struct RunSums {
  double before = 0.0, after = 0.0, n = 0.0, covered = 0.0;
};

/// @param channel  empty: all, over their standard deviations before
RunSums sums_of(HeldOutRun const& run, std::string const& channel) {
  RunSums sums;
  for (Index k = 0; k < run.measured.size(); ++k) {
    if (!channel.empty() && run.channels[static_cast<std::size_t>(k)] != channel)
      continue;
    double const unit = channel.empty() ? run.before.covariance(k, k) : 1.0;
    double const after = run.measured[k] - run.after.value[k];
    sums.before += std::pow(run.measured[k] - run.before.value[k], 2) / unit;
    sums.after += after * after / unit;
    sums.covered +=
        std::abs(after) <= normal_95 * std::sqrt(run.after.covariance(k, k)) ? 1.0 : 0.0;
    sums.n += 1.0;
  }
  return sums;
}

double ratio_of(std::vector<RunSums> const& runs, auto const& pick) {
  double before = 0.0, after = 0.0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    before += runs[pick(k)].before;
    after += runs[pick(k)].after;
  }
  return std::sqrt(after / before);
}

ChannelGain gain_of(std::vector<HeldOutRun> const& runs, std::string const& channel,
                    GainSettings const& settings) {
  std::vector<RunSums> of_runs;
  RunSums sums;
  for (auto const& run : runs) {
    auto const one = sums_of(run, channel);
    if (one.n == 0.0)
      continue;
    of_runs.push_back(one);
    sums = {sums.before + one.before, sums.after + one.after, sums.n + one.n,
            sums.covered + one.covered};
  }
  ChannelGain gain{.channel = channel.empty() ? "all" : channel,
                   .before = std::sqrt(sums.before / sums.n),
                   .after = std::sqrt(sums.after / sums.n),
                   .ratio = std::sqrt(sums.after / sums.before),
                   .low = not_known,
                   .high = not_known,
                   .coverage = sums.covered / sums.n};
  if (of_runs.size() < fewest_runs)
    return gain;
  dem::RandomStream random(settings.seed);
  std::vector<double> ratios;
  for (int draw = 0; draw < settings.n_draws; ++draw) {
    std::vector<std::size_t> picked(of_runs.size());
    std::ranges::generate(picked, [&] { return random.below(of_runs.size()); });
    ratios.push_back(ratio_of(of_runs, [&](std::size_t k) { return picked[k]; }));
  }
  std::ranges::sort(ratios);
  auto const last = static_cast<double>(ratios.size() - 1);
  gain.low = ratios[static_cast<std::size_t>(0.025 * last)];
  gain.high = ratios[static_cast<std::size_t>(std::ceil(0.975 * last))];
  return gain;
}

} // namespace

Gain measure_gain(std::vector<HeldOutRun> const& runs, GainSettings const& settings) {
  VALIDATE(!runs.empty(), "gain: has no held-out run. Which runs were kept back?");
  VALIDATE(
      settings.n_draws >= 1,
      fmt::format("gain: {} resamplings (at least one). Is the number meant?", settings.n_draws));
  std::vector<std::string> channels;
  Gain gain{};
  for (auto const& run : runs) {
    validate(run);
    for (auto const& channel : run.channels)
      if (std::ranges::count(channels, channel) == 0)
        channels.push_back(channel);
  }
  add_scores(runs, gain);
  channels.emplace_back(); // all
  for (auto const& channel : channels)
    gain.channels.push_back(gain_of(runs, channel, settings));
  return gain;
}

} // namespace coupling::diagnosis
