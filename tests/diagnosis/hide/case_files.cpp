#include "tests/diagnosis/hide/case_files.hpp"

#include "tests/diagnosis/hide/detectability.hpp"
#include "tests/diagnosis/hide/extras.hpp"
#include "tests/diagnosis/hide/readings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace hidden {
namespace {

using Json = nlohmann::ordered_json;

void write(std::filesystem::path const& file, std::string const& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
    throw std::runtime_error(
        fmt::format("{}: cannot be written. Is the disk full?", file.string()));
}

Json quantity(double value, double sd, std::string_view unit) {
  return {{"value", value}, {"sd", sd}, {"unit", unit}};
}

Json channel(std::string_view unit, Sensor const& sensor) {
  Json json = {{"unit", unit}, {"sd", sensor.sd}};
  if (sensor.relative > 0.0)
    json["sd_relative"] = sensor.relative;
  return json;
}

Json described(PlannedRun const& run, Readings const& readings, Observables set) {
  auto const& press = run.protocol;
  Json json = {{"file", run.file},
               {"role", run.is_held_out ? "held-out" : "fit"},
               {"press",
                {{"speed_down", press.speed_down},
                 {"speed_up", press.speed_up},
                 {"end_gap", press.end_gap},
                 {"fill_height", press.fill_height},
                 {"dwell", press.dwell},
                 {"unit", "SI"}}}};
  if (has_compact_height(set))
    json["scalars"]["compact_height"] = quantity(readings.compact_height, height_sd, "m");
  if (has_all_gauges(set))
    json["scalars"]["ejection_force"] = quantity(readings.ejection_force, ejection_sd, "N");
  return json;
}

std::string csv(Readings const& rows, bool all) {
  std::string text = "time [s],punch_gap [m],upper_punch_force [N]";
  text += all ? ",lower_punch_force [N],wall_radial_pressure [Pa]\n" : "\n";
  for (std::size_t k = 0; k < rows.time.size(); ++k) {
    text += fmt::format("{:.5f},{:.8f},{:.3f}", rows.time[k], rows.gap[k], rows.upper[k]);
    text += all ? fmt::format(",{:.3f},{:.1f}\n", rows.lower[k], rows.radial[k]) : "\n";
  }
  return text;
}

/// lambda, and the rivals nearer than 5.
void foretell(Case const& of, Foretold foretold, Json& json) {
  if (foretold == Foretold::nothing || of.hidden.empty())
    return;
  Detector const detector(of);
  json["lambda"] = detector.lambda(of.hidden);
  for (std::size_t k = 0; k < of.hidden.size(); ++k)
    json["effects"][k]["lambda"] = detector.lambda({of.hidden[k]});
  if (foretold != Foretold::separation || of.hidden.size() != 1)
    return;
  auto const rivals = detector.rivals(of.hidden.front());
  json["separation"] = rivals.front().separation;
  json["rivals"] = Json::array();
  for (auto const& [effect, separation] : rivals)
    if (separation < 5.0)
      json["rivals"].push_back({{"name", kind_of(effect).name}, {"separation", separation}});
}

Json truth(Case const& of, Foretold foretold) {
  Json json = {{"seed", of.seed},
               {"class", name_of(of.kind)},
               {"observables", name_of(of.observables)},
               {"powder",
                {{"young_modulus", of.powder.young_modulus},
                 {"cohesion_density", of.powder.cohesion_density}}},
               {"effects", Json::array()}};
  for (std::size_t k = 0; k < of.hidden.size(); ++k) {
    auto const& kind = kind_of(of.hidden[k].effect);
    json["effects"].push_back({{"name", kind.name},
                               {"size", of.hidden[k].size},
                               {"unit", kind.unit},
                               {"prior", kind.prior},
                               {"form", kind.form}});
  }
  foretell(of, foretold, json);
  for (auto const& run : of.runs)
    json["runs"].push_back({{"file", run.file},
                            {"mass", run.repeat.mass},
                            {"packing", run.repeat.packing},
                            {"friction", run.repeat.friction},
                            {"zero", run.repeat.zero},
                            {"cell_zero", run.repeat.cell_zero}});
  return json;
}

Json sheet(Observables set) {
  Json json = {{"sample",
                {{"mass", quantity(stated_mass, 0.003 * stated_mass, "kg")},
                 {"die_diameter", quantity(stated_bore, 5e-6, "m")}}},
               {"channels",
                {{"upper_punch_force", channel("N", force_sensor)},
                 {"punch_gap", channel("m", gap_sensor)}}},
               {"gap_source", "commanded"},
               {"runs", Json::array()}};
  if (has_all_gauges(set)) {
    json["channels"]["lower_punch_force"] = channel("N", force_sensor);
    json["channels"]["wall_radial_pressure"] = channel("Pa", pressure_sensor);
  }
  return json;
}

/// What a simulation of the press would have written: no effect, no scatter, no noise, and a powder
/// that is a little off.
std::string simulated_curves(std::uint64_t seed) {
  Protocol const protocol{.speed_down = 0.2, .speed_up = 0.2, .end_gap = 7.5 * mm, .dwell = 0.0};
  auto const cycle = press_cycle(simulated_powder(seed), {}, protocol, {});
  std::string text = "time [s],stage,punch_gap [m],bed_height [m],upper_punch_force [N],"
                     "lower_punch_force [N],wall_radial_pressure [Pa]\n";
  for (auto const& at : cycle.moments)
    text += fmt::format("{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", at.time,
                        at.time <= protocol.closing_time() ? "loading" : "unloading", at.gap,
                        at.height, at.upper, at.lower, at.radial);
  return text;
}

} // namespace

void write_case(Case const& of, std::filesystem::path const& folder, Foretold foretold) {
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder))
    throw std::runtime_error(fmt::format(
        "{}: is not empty (a case has a folder of its own). Another name?", folder.string()));
  std::filesystem::create_directories(folder / "data");
  std::filesystem::create_directories(folder / "sealed");
  std::filesystem::create_directories(folder / "simulation");
  write(folder / "simulation" / "curves.csv", simulated_curves(of.seed));
  auto json = sheet(of.observables);
  for (std::size_t k = 0; k < of.runs.size(); ++k) {
    auto const& run = of.runs[k];
    auto const cycle = press_cycle(of.powder, of.effects(), run.protocol, run.repeat);
    auto const readings = read_cycle(cycle, run.protocol, of.seed, k);
    json["runs"].push_back(described(run, readings, of.observables));
    if (auto const one = measured_number(of, k, cycle); !one.name.empty() && !run.is_held_out)
      json["runs"].back()["scalars"][one.name] = quantity(one.value, one.sd, one.unit);
    write(folder / "data" / run.file, csv(readings, has_all_gauges(of.observables)));
  }
  write(folder / "data" / "measured.json", json.dump(2) + "\n");
  write(folder / "sealed" / "truth.json", truth(of, foretold).dump(2) + "\n");
}

} // namespace hidden
