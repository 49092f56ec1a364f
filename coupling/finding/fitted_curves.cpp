#include "coupling/finding/fitted_curves.hpp"

#include "coupling/finding/ranked_causes.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::finding {
namespace {

using diagnosis::Diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

/// Appends the values of a block to the curve of its run and channel.
void append(std::vector<double>& values, VectorXd const& rows, diagnosis::RowRange range) {
  for (Index k = 0; k < range.n && rows.size() > 0; ++k)
    values.push_back(rows[range.first + k]);
}

void check_places(RowPlaces const& places, Index n_rows) {
  for (auto const* one : {&places.time, &places.gap})
    VALIDATE(one->size() == 0 || one->size() == n_rows,
             fmt::format("places of rows: are {} for {} rows (each row has its own). Is a channel "
                         "missing?",
                         one->size(), n_rows));
}

} // namespace

std::vector<RunCurve> fitted_curves(Diagnosis const& found, FindingSources const& sources) {
  check_places(sources.places, sources.observations.size());
  auto const& data = sources.observations;
  auto const& best = best_fit(found);
  VectorXd const sd = found.errors.covariance.diagonal().cwiseSqrt();
  VectorXd const calibrated = found.baseline.predicted + found.errors.bias;
  VectorXd const extended =
      best.active.empty() ? VectorXd() : VectorXd(best.predicted + found.errors.bias);
  std::vector<RunCurve> curves;
  for (std::size_t b = 0; b < data.blocks().size(); ++b) {
    auto const& block = data.blocks()[b];
    auto const range = data.rows()[b];
    auto at = std::ranges::find_if(curves, [&](RunCurve const& one) {
      return one.run == block.run && one.channel == block.channel;
    });
    if (at == curves.end())
      at = curves.insert(
          curves.end(),
          {.run = block.run, .channel = block.channel, .unit = unit_of_channel(block.channel)});
    at->phase.insert(at->phase.end(), static_cast<std::size_t>(range.n),
                     std::string(name_of(block.phase)));
    append(at->time, sources.places.time, range);
    append(at->gap, sources.places.gap, range);
    append(at->measured, data.values(), range);
    append(at->calibrated, calibrated, range);
    append(at->extended, extended, range);
    append(at->sd, sd, range);
  }
  return curves;
}

std::vector<RunCurve> curves_of(diagnosis::HeldOutRun const& run,
                                std::vector<std::string> const& phases, RowPlaces const& places) {
  check_places(places, run.measured.size());
  std::vector<RunCurve> curves;
  for (Index k = 0; k < run.measured.size(); ++k) {
    auto const& channel = run.channels[static_cast<std::size_t>(k)];
    auto at = std::ranges::find(curves, channel, &RunCurve::channel);
    if (at == curves.end())
      at = curves.insert(curves.end(), {.run = run.run,
                                        .channel = channel,
                                        .unit = unit_of_channel(channel),
                                        .is_held_out = true});
    diagnosis::RowRange const row{k, 1};
    at->phase.push_back(phases[static_cast<std::size_t>(k)]);
    append(at->time, places.time, row);
    append(at->gap, places.gap, row);
    append(at->measured, run.measured, row);
    append(at->calibrated, run.before.value, row);
    append(at->extended, run.after.value, row);
    at->sd.push_back(std::sqrt(run.before.covariance(k, k)));
  }
  return curves;
}

} // namespace coupling::finding
