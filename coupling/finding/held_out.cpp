#include "coupling/finding/held_out.hpp"

#include "coupling/finding/row_inputs.hpp"

#include <algorithm>
#include <iterator>

namespace coupling::finding {

using diagnosis::ChannelError;
using diagnosis::HeldOutPrediction;
using diagnosis::HeldOutRun;

HeldOutRuns::HeldOutRuns(measured::MeasuredData const& data, diagnosis::ErrorSources const& sources,
                         reduced::BedFit const& fit, reduced::BedUncertainty const& uncertainty)
    : tolerances_(sources.tolerances), fit_(fit), uncertainty_(uncertainty) {
  for (auto const& run : data.runs) {
    if (run.role != measured::Role::held_out || !run.has_curve())
      continue;
    auto alone = data;
    alone.runs = {run};
    auto rows = reduced::measured_rows(alone, measured::Role::held_out);
    for (auto& channel : rows.channels) {
      auto const known =
          std::ranges::find(sources.channels, channel.channel, &ChannelError::channel);
      if (known != sources.channels.end())
        channel.model_share = known->model_share;
    }
    runs_.push_back({std::move(rows.plan), diagnosis::Observations(std::move(rows.blocks)),
                     std::move(rows.channels)});
  }
}

HeldOutRun HeldOutRuns::compared(Run const& run, FittedPress const& before,
                                 FittedPress const& after) const {
  auto const foretold = [&](FittedPress const& press) {
    auto const model = press.model.with_plan(run.plan);
    diagnosis::ErrorSources const sources{
        .channels = run.channels,
        .numerical = {.bias = {},
                      .covariance = reduced::numerical_covariance(model, fit_, uncertainty_)},
        .tolerances = tolerances_};
    auto const errors = error_model(run.observations, model, sources, press.at, press.active);
    return HeldOutPrediction{.value = model.predict(press.at) + errors.bias,
                             .covariance = errors.covariance};
  };
  HeldOutRun result{.run = run.plan.runs.front().name,
                    .measured = run.observations.values(),
                    .channels = {},
                    .before = foretold(before),
                    .after = foretold(after)};
  for (auto const& block : run.observations.blocks())
    result.channels.insert(result.channels.end(), static_cast<std::size_t>(block.values.size()),
                           block.channel);
  return result;
}

std::vector<HeldOutRun> HeldOutRuns::compared(FittedPress const& before,
                                              FittedPress const& after) const {
  std::vector<HeldOutRun> all;
  for (auto const& run : runs_)
    all.push_back(compared(run, before, after));
  return all;
}

std::vector<RunCurve> HeldOutRuns::curves(FittedPress const& before,
                                          FittedPress const& after) const {
  std::vector<RunCurve> all;
  for (auto const& run : runs_) {
    std::vector<std::string> phases;
    for (auto const& block : run.observations.blocks())
      phases.insert(phases.end(), static_cast<std::size_t>(block.values.size()),
                    std::string(name_of(block.phase)));
    std::ranges::move(curves_of(compared(run, before, after), phases, places_of(run.plan)),
                      std::back_inserter(all));
  }
  return all;
}

} // namespace coupling::finding
