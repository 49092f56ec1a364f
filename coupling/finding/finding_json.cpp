#include "coupling/finding/finding_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace coupling::finding {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Readers of an interval take its ends for numbers: an end that is nowhere is the largest one.
double end_of(double value) {
  constexpr double most = std::numeric_limits<double>::max();
  return std::clamp(value, -most, most);
}

template <class Part> Json list(std::vector<Part> const& parts, auto const& as_json) {
  Json all = Json::array();
  for (Part const& part : parts)
    all.push_back(as_json(part));
  return all;
}

Json numbers(std::vector<double> const& values) {
  return list(values, number);
}

Json alarm_json(Alarm const& alarm) {
  return {{"raised", alarm.is_raised},
          {"level", number(alarm.level)},
          {"p_omnibus", number(alarm.p_omnibus)},
          {"p_targeted", number(alarm.p_targeted)},
          {"chi_squared", number(alarm.chi_squared)},
          {"expected", number(alarm.expected)},
          {"expected_sd", number(alarm.expected_sd)},
          {"best_cause", alarm.best_cause}};
}

Json cell_json(MisfitCell const& cell) {
  return {{"channel", cell.channel}, {"phase", cell.phase}, {"size", number(cell.size)},
          {"p", number(cell.p)},     {"sign", cell.sign},   {"shape", cell.shape},
          {"test", cell.test}};
}

Json level_json(RunLevel const& level) {
  return {{"run", level.run},
          {"channel", level.channel},
          {"size", number(level.size)},
          {"p", number(level.p)}};
}

Json parameter_json(CauseParameter const& parameter) {
  return {{"name", parameter.name},
          {"value", end_of(parameter.value)},
          {"low", end_of(parameter.low)},
          {"high", end_of(parameter.high)},
          {"unit", parameter.unit},
          {"open_low", parameter.is_open_low},
          {"open_high", parameter.is_open_high}};
}

Json cause_json(FoundCause const& cause) {
  return {{"name", cause.name},
          {"probability", cause.probability},
          {"parameters", list(cause.parameters, parameter_json)},
          {"log_evidence", number(cause.log_evidence)},
          {"plausibility", cause.plausibility},
          {"named", cause.is_named},
          {"calibrated", cause.is_calibrated}};
}

Json foretold_json(Foretold const& one) {
  return {{"cause", one.cause}, {"value", numbers(one.value)}, {"sd", numbers(one.sd)}};
}

Json reading_json(Reading const& one) {
  return {
      {"channel", one.channel}, {"unit", one.unit}, {"phase", one.phase}, {"gap", number(one.gap)}};
}

Json measurement_json(Measurement const& one) {
  return {{"name", one.name},
          {"cost", number(one.cost)},
          {"separation_before", number(one.before)},
          {"separation_after", number(one.after)},
          {"enough", one.is_enough},
          {"readings", list(one.readings, reading_json)},
          {"predictions", list(one.outcomes, foretold_json)}};
}

Json channel_json(ChannelGained const& one) {
  return {{"channel", one.channel},       {"unit", one.unit},
          {"before", number(one.before)}, {"after", number(one.after)},
          {"ratio", number(one.ratio)},   {"low", number(one.low)},
          {"high", number(one.high)},     {"coverage", number(one.coverage)}};
}

Json gain_of(MeasuredGain const& gain) {
  return {{"causes", gain.causes},
          {"channels", list(gain.channels, channel_json)},
          {"elpd_difference", number(gain.elpd_difference)},
          {"elpd_error", number(gain.elpd_error)},
          {"runs", gain.n_runs}};
}

/// The contract wants the placebo beside the gain.
Json gain_json(Finding const& finding) {
  if (!finding.gain)
    return nullptr;
  Json json = gain_of(*finding.gain);
  json["placebo"] = finding.placebo ? gain_of(*finding.placebo) : Json(nullptr);
  return json;
}

Json unknown_json(std::optional<Unknown> const& unknown) {
  if (!unknown)
    return nullptr;
  auto const input = [](DependsOn const& one) -> Json {
    return {{"input", one.input}, {"share", number(one.share)}, {"p", number(one.p)}};
  };
  auto const form = [](Form const& one) -> Json {
    return {{"form", one.form},
            {"input", one.input},
            {"place", number(one.place)},
            {"width", number(one.width)},
            {"amplitude", number(one.amplitude)},
            {"share", number(one.share)}};
  };
  return {{"channel", unknown->channel},
          {"phase", unknown->phase},
          {"run", unknown->run},
          {"run_share", number(unknown->run_share)},
          {"value_low", number(unknown->value_low)},
          {"value_high", number(unknown->value_high)},
          {"size", number(unknown->size)},
          {"unit", unknown->unit},
          {"depends_on", list(unknown->inputs, input)},
          {"nearest", unknown->nearest},
          {"nearest_cosine", number(unknown->nearest_cosine)},
          {"forms", list(unknown->forms, form)}};
}

Json detectable_json(DetectableSize const& one) {
  return {{"cause", one.cause}, {"size", number(one.size)}, {"unit", one.unit}};
}

Json tolerance_json(StatedError const& one) {
  return {{"name", one.name},
          {"value", number(one.value)},
          {"unit", one.unit},
          {"meaning", one.meaning},
          {"source", one.source}};
}

Json calibrated_json(CalibratedValue const& one) {
  return {{"name", one.name},
          {"value", number(one.value)},
          {"sd", number(one.sd)},
          {"sheet", number(one.sheet)},
          {"sheet_sd", number(one.sheet_sd)},
          {"logarithmic", one.is_logarithmic},
          {"unit", one.unit}};
}

Json change_json(ChangedEntry const& one) {
  return {
      {"entry", one.path}, {"before", one.before}, {"after", one.after}, {"because", one.because}};
}

Json provenance_json(Provenance const& from) {
  Json json{{"case", from.case_file},
            {"data", from.data_folder},
            {"simulation", from.simulation},
            {"version", from.version}};
  if (!from.made.empty())
    json["made"] = from.made;
  return json;
}

} // namespace

std::string diagnosis_json(Finding const& finding) {
  Json seeds = Json::object();
  for (Seed const& seed : finding.seeds)
    seeds[seed.purpose] = seed.value;
  Json const all{{"verdict", finding.verdict},
                 {"incomplete", finding.is_incomplete},
                 {"sentences", finding.sentences},
                 {"explained_share", number(finding.explained_share)},
                 {"alarm", alarm_json(finding.alarm)},
                 {"misfit", list(finding.misfit, cell_json)},
                 {"levels", list(finding.levels, level_json)},
                 {"causes", list(finding.causes, cause_json)},
                 {"not_claimed", finding.not_claimed},
                 {"group", finding.group},
                 {"next_measurement", list(finding.measurements, measurement_json)},
                 {"gain", gain_json(finding)},
                 {"detectable", list(finding.detectable, detectable_json)},
                 {"tolerances", list(finding.tolerances, tolerance_json)},
                 {"unknown", unknown_json(finding.unknown)},
                 {"calibrated", list(finding.calibrated, calibrated_json)},
                 {"extension", list(finding.extension, change_json)},
                 {"not_modelled", finding.not_modelled},
                 {"decisions", finding.decisions},
                 {"seeds", seeds},
                 {"provenance", provenance_json(finding.provenance)}};
  // A name that is no UTF-8 must not cost the whole file.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace coupling::finding
