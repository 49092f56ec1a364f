#include "coupling/finding/finding_of.hpp"

#include "coupling/finding/fitted_curves.hpp"
#include "coupling/finding/ranked_causes.hpp"
#include "coupling/measured/channel_kinds.hpp"
#include <algorithm>

namespace coupling::finding {
namespace {

using diagnosis::Diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

std::vector<double> as_vector(Eigen::Ref<VectorXd const> const& values) {
  return {values.begin(), values.end()};
}

std::string mechanism_name(FindingSources const& sources, int mechanism) {
  return sources.model.mechanisms()[static_cast<std::size_t>(mechanism)].name;
}

Alarm alarm_of(Diagnosis const& found, FindingSources const& sources) {
  auto const& tests = found.tests;
  return {.is_raised = tests.is_alarm,
          .level = sources.settings.misfit.level,
          .p_omnibus = tests.p_omnibus,
          .p_targeted = tests.p_targeted,
          .chi_squared = tests.omnibus,
          .expected = tests.expected,
          .expected_sd = tests.expected_sd,
          .best_cause =
              tests.best_mechanism < 0 ? "" : mechanism_name(sources, tests.best_mechanism)};
}

void add_misfit(Diagnosis const& found, Finding& finding) {
  for (auto const& cell : found.tests.cells)
    finding.misfit.push_back({.channel = cell.channel,
                              .phase = std::string(name_of(cell.phase)),
                              .size = cell.size,
                              .p = cell.p_holm,
                              .sign = cell.size < 0.0 ? "negative" : "positive",
                              .shape = cell.shape,
                              .test = cell.test});
  for (auto const& one : found.tests.offsets)
    finding.levels.push_back(
        {.run = one.run, .channel = one.channel, .size = one.size, .p = one.p_holm});
}

/// What is probable and not named would be taken for named beside causes that are.
void set_unclaimed_apart(Finding& finding, double naming) {
  if (finding.verdict != "named")
    return;
  std::erase_if(finding.causes, [&](FoundCause const& cause) {
    bool const is_apart = !cause.is_named && cause.probability >= naming;
    if (is_apart)
      finding.not_claimed.push_back(cause.name);
    return is_apart;
  });
}

void add_causes(Diagnosis const& found, FindingSources const& sources, Finding& finding) {
  finding.causes = ranked_causes(found, sources);
  finding.group = group_of(found, sources, finding.causes);
  set_unclaimed_apart(finding, sources.settings.rules.naming);
  for (auto const& one : found.detectable)
    finding.detectable.push_back({.cause = one.name, .size = one.size, .unit = one.unit});
  finding.calibrated = calibrated_values(found, sources.model);
  if (finding.verdict != "undecided" || finding.group.size() > 1)
    return;
  finding.verdict = "unknown"; // one cause alone is no group, and it was not named
  finding.sentences.emplace_back("no other known cause can stand beside it");
}

Measurement measurement_of(diagnosis::MeasurementAdvice const& advice,
                           FindingSources const& sources) {
  Measurement one{.name = advice.name,
                  .cost = advice.cost,
                  .before = advice.before,
                  .after = advice.after,
                  .is_enough = advice.is_enough};
  for (auto const& place : advice.readings)
    one.readings.push_back({.channel = place.channel,
                            .unit = place.unit,
                            .phase = std::string(name_of(place.phase)),
                            .gap = place.gap});
  for (auto const& outcome : advice.outcomes)
    one.outcomes.push_back({.cause = mechanism_name(sources, outcome.mechanism),
                            .value = as_vector(outcome.value),
                            .sd = as_vector(outcome.sd)});
  return one;
}

MeasuredGain gain_of(ScoredGain const& scored) {
  MeasuredGain gain{.causes = scored.causes,
                    .elpd_difference = scored.gain.elpd_difference,
                    .elpd_error = scored.gain.elpd_error,
                    .n_runs = scored.n_runs};
  for (auto const& one : scored.gain.channels)
    gain.channels.push_back({.channel = one.channel,
                             .unit = one.channel == "all" ? "1" : unit_of_channel(one.channel),
                             .before = one.before,
                             .after = one.after,
                             .ratio = one.ratio,
                             .low = one.low,
                             .high = one.high,
                             .coverage = one.coverage});
  return gain;
}

Unknown unknown_of(diagnosis::Unexplained const& from) {
  Unknown unknown{.channel = from.channel,
                  .phase = std::string(name_of(from.phase)),
                  .run = from.run,
                  .run_share = from.run_share,
                  .value_low = from.value_low,
                  .value_high = from.value_high,
                  .size = from.size,
                  .unit = unit_of_channel(from.channel),
                  .nearest = from.nearest,
                  .nearest_cosine = from.nearest_cosine};
  for (auto const& one : from.inputs)
    unknown.inputs.push_back({.input = one.input, .share = one.share, .p = one.p});
  for (auto const& one : from.forms)
    unknown.forms.push_back({.form = one.form,
                             .input = one.input,
                             .place = one.place,
                             .width = one.width,
                             .amplitude = one.amplitude,
                             .share = one.share});
  return unknown;
}

/// Assumptions of the error model, what scatters between pressings, then the instruments as the
/// laboratory states them.
std::vector<StatedError> tolerances_of(FindingSources const& sources) {
  auto const& errors = sources.errors;
  std::vector<StatedError> all;
  for (auto const& one : diagnosis::state(errors.tolerances))
    all.push_back({.name = one.name,
                   .value = one.value,
                   .unit = "1",
                   .meaning = one.meaning,
                   .source = one.source});
  for (auto const& one : sources.model.scatters())
    all.push_back({"scatter/" + one.name, one.sd, one.unit,
                   "sd between pressings that are meant to be the same", "coupling/reduced"});
  std::string const sheet = "measured.json, channels";
  for (auto const& one : errors.channels) {
    auto const add = [&](char const* what, double value, std::string unit, char const* meaning) {
      all.push_back({one.channel + what, value, std::move(unit), meaning, sheet});
    };
    add("/sd", one.sd, unit_of_channel(one.channel), "standard uncertainty of one reading");
    if (one.sd_relative > 0.0)
      add("/sd_relative", one.sd_relative, "1", "the same, over the reading");
    if (one.correlation > 0.0)
      add("/correlation", one.correlation, "1", "between neighbouring readings");
    if (one.model_share)
      all.push_back({one.channel + "/model_share", *one.model_share, "1",
                     "sd of the simulator's own error over the prediction",
                     "measured on the simulator"});
  }
  return all;
}

} // namespace

std::string unit_of_channel(std::string const& channel) {
  for (auto const kinds : {measured::channel_kinds(), measured::scalar_kinds()})
    if (auto const* kind = measured::find_kind(kinds, channel)) {
      auto const unit = describe(kind->physical).si;
      return unit.empty() ? "1" : std::string(unit);
    }
  return "1";
}

Finding finding_of(Diagnosis const& found, FindingSources const& sources) {
  Finding finding{.verdict = std::string(name_of(found.verdict.kind)),
                  .is_incomplete = found.verdict.is_incomplete,
                  .explained_share = found.verdict.explained_share,
                  .sentences = found.verdict.statements,
                  .alarm = alarm_of(found, sources)};
  add_misfit(found, finding);
  add_causes(found, sources, finding);
  for (auto const& one : sources.advice)
    finding.measurements.push_back(measurement_of(one, sources));
  if (sources.gain)
    finding.gain = gain_of(*sources.gain);
  if (sources.placebo)
    finding.placebo = gain_of(*sources.placebo);
  finding.tolerances = tolerances_of(sources);
  if (sources.unexplained)
    finding.unknown = unknown_of(*sources.unexplained);
  finding.decisions = sources.decisions;
  finding.curves = fitted_curves(found, sources);
  finding.curves.insert(finding.curves.end(), sources.held_out_curves.begin(),
                        sources.held_out_curves.end());
  finding.seeds = {{"misfit references", std::to_string(sources.settings.misfit.seed)}};
  finding.provenance = sources.provenance;
  if (finding.provenance.version.empty())
    finding.provenance.version = PRESSCHECK_VERSION;
  return finding;
}

} // namespace coupling::finding
