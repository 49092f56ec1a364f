#include "tests/diagnosis/grains/grain_case.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace hidden {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The seed's height of a compact is that of its highest grain, which differs so much between
/// packings.
constexpr double height_scatter = 1e-4; // [m]

void write(fs::path const& file, std::string const& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
    throw std::runtime_error(
        fmt::format("{}: cannot be written. Is the disk full?", file.string()));
}

Json channel(char const* unit, Sensor const& sensor) {
  return {{"unit", unit}, {"sd", sensor.sd}, {"sd_relative", sensor.relative}};
}

Json quantity(double value, double sd, char const* unit) {
  return {{"value", value}, {"sd", sd}, {"unit", unit}};
}

Json measured(GrainCase const& of, std::vector<Moment> const& moments, Readings const& readings) {
  Gauges const gauges;
  double const mass = stated_mass * of.stated_mass_share;
  double lowest = moments.front().gap;
  for (auto const& at : moments)
    lowest = std::min(lowest, at.gap);
  Json run = {{"file", "run1.csv"},
              {"role", "fit"},
              {"press",
               {{"speed_down", laboratory_speed},
                {"speed_up", laboratory_speed},
                {"end_gap", lowest},
                {"fill_height", moments.front().gap},
                {"dwell", 0.0},
                {"unit", "SI"}}}};
  if (readings.compact_height > 1 * mm)
    run["scalars"]["compact_height"] =
        quantity(readings.compact_height,
                 height_scatter / std::sqrt(static_cast<double>(of.packings.size())), "m");
  return {{"sample",
           {{"mass", quantity(mass, 0.003 * mass, "kg")},
            {"die_diameter", quantity(of.stated_bore, 5e-6, "m")}}},
          {"channels",
           {{"upper_punch_force", channel("N", gauges.force)},
            {"lower_punch_force", channel("N", gauges.force)},
            {"wall_radial_pressure", channel("Pa", gauges.pressure)},
            {"punch_gap", {{"unit", "m"}, {"sd", gauges.gap.sd}}}}},
          {"gap_source", "commanded"},
          {"runs", Json::array({run})}};
}

std::string csv(Readings const& rows) {
  std::string text = "time [s],punch_gap [m],upper_punch_force [N],lower_punch_force [N],"
                     "wall_radial_pressure [Pa]\n";
  for (std::size_t k = 0; k < rows.time.size(); ++k)
    text += fmt::format("{:.5f},{:.8f},{:.3f},{:.3f},{:.1f}\n", rows.time[k], rows.gap[k],
                        rows.upper[k], rows.lower[k], rows.radial[k]);
  return text;
}

Json truth(GrainCase const& of, Code code) {
  Json json = {{"seed", of.seed},
               {"class", of.cause ? "single" : "clean"},
               {"observables", "D"},
               {"code", code == Code::own ? "presscheck" : "liggghts"},
               {"powder",
                {{"young_modulus", of.stiffness * of.press.young_modulus},
                 {"cohesion_density", of.stiffness * of.press.cohesion_density}}},
               {"effects", Json::array()}};
  if (of.cause) {
    auto const& kind = kind_of(*of.cause);
    json["effects"].push_back(
        {{"name", kind.name}, {"size", of.size}, {"unit", kind.unit}, {"prior", kind.prior}});
    if (of.lambda > 0.0)
      json["lambda"] = json["effects"][0]["lambda"] = of.lambda;
  }
  json["entries"] = of.press.more;
  json["friction"] = {of.press.friction, of.press.wall_friction};
  json["packings"] = of.packings;
  json["runs"].push_back({{"file", "run1.csv"},
                          {"mass", 1.0 / of.stated_mass_share - 1.0},
                          {"zero", of.scatter.zero},
                          {"cell_zero", of.scatter.cell_zero}});
  return json;
}

} // namespace

void write_grain_case(GrainCase const& of, Simulations const& simulations, fs::path const& folder) {
  if (fs::exists(folder) && !fs::is_empty(folder))
    throw std::runtime_error(fmt::format(
        "{}: is not empty (a case has a folder of its own). Another name?", folder.string()));
  std::vector<Curve> curves;
  auto press = of.press;
  for (auto const packing : of.packings) {
    press.packing = packing;
    curves.push_back(simulations.curve(press, of.change));
  }
  auto const curve = scaled(mean_of(curves), of.stiffness);
  auto const moments = seen_by_machine(curve, of.effects, of.scatter);
  auto const readings = read_moments(moments, curve.compact_height, {}, of.seed);
  fs::create_directories(folder / "data");
  fs::create_directories(folder / "sealed");
  write(folder / "data" / "run1.csv", csv(readings));
  write(folder / "data" / "measured.json", measured(of, moments, readings).dump(2) + "\n");
  write(folder / "sealed" / "truth.json", truth(of, simulations.code).dump(2) + "\n");
}

} // namespace hidden
