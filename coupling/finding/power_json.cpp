#include "coupling/finding/power_table.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace coupling::finding {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json set_json(PowerColumn const& column) {
  Json runs = Json::array();
  for (auto const& [speed, gap, dwell] : column.set.pressings)
    runs.push_back({{"speed_down", speed}, {"end_gap", gap}, {"dwell", dwell}});
  return {{"name", column.set.name},
          {"words", column.set.words},
          {"channels", column.set.channels},
          {"scalars", column.set.scalars},
          {"runs", runs},
          {"rows", column.n_rows}};
}

Json instruments_json(reduced::Instruments const& with) {
  return {{"force_sd", with.force_sd},
          {"force_relative", with.force_relative},
          {"pressure_sd", with.pressure_sd},
          {"pressure_relative", with.pressure_relative},
          {"height_sd", with.height_sd},
          {"ejection_sd", with.ejection_sd},
          {"reading_rate", with.reading_rate},
          {"repeats", with.n_repeats},
          {"unit", "SI"}};
}

Json causes_json(PowerTable const& table) {
  Json all = Json::array();
  for (std::size_t j = 0; !table.columns.empty() && j < table.columns.front().causes.size(); ++j) {
    auto const& first = table.columns.front().causes[j];
    Json sets = Json::object();
    for (auto const& column : table.columns) {
      auto const& one = column.causes[j];
      sets[column.set.name] = {{"detected", number(one.detected)},
                               {"told", number(one.told)},
                               {"rival", one.rival},
                               {"rival_distance", number(one.rival_distance)}};
    }
    all.push_back(
        {{"name", first.name}, {"unit", first.unit}, {"prior_size", first.scale}, {"sets", sets}});
  }
  return all;
}

} // namespace

std::string power_json(PowerTable const& table) {
  Json sets = Json::array(), calibrated = Json::array(), scatters = Json::array(),
       tolerances = Json::array();
  for (auto const& column : table.columns)
    sets.push_back(set_json(column));
  for (auto const& one : table.calibrated)
    calibrated.push_back({{"name", one.name},
                          {"value", one.mean},
                          {"sd", one.sd},
                          {"logarithmic", one.is_logarithmic},
                          {"unit", one.unit}});
  for (auto const& one : table.scatters)
    scatters.push_back({{"name", one.name}, {"sd", one.sd}, {"unit", one.unit}});
  for (auto const& one : table.tolerances)
    tolerances.push_back({{"name", one.name},
                          {"value", number(one.value)},
                          {"meaning", one.meaning},
                          {"source", one.source}});
  Json const all{{"detected_at", table.settings.detection},
                 {"told_at", table.settings.separation},
                 {"most_prior_sizes", table.settings.most_scales},
                 {"rival_prior_sizes", diagnosis::rival_scales},
                 {"sets", sets},
                 {"instruments", instruments_json(table.instruments)},
                 {"causes", causes_json(table)},
                 {"calibrated", calibrated},
                 {"scatter", scatters},
                 {"tolerances", tolerances},
                 {"emulator", table.emulator},
                 {"provenance",
                  {{"case", table.provenance.case_file},
                   {"simulation", table.provenance.simulation},
                   {"version", table.provenance.version}}}};
  // A name that is no UTF-8 must not cost the whole file.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace coupling::finding
