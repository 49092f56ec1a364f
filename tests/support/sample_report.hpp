#pragma once

#include "coupling/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

/// A made-up run that looks like one: for the tests of the report, and for looking at it.
namespace sample {

inline constexpr double start_gap = 20e-3;       // [m]
inline constexpr double smallest_gap = 8e-3;     // [m]
inline constexpr double peak_force = 1471.0;     // [N]
inline constexpr double bore_radius = 11.025e-3; // [m]

/// Down at 0.2 m/s for 60 ms, back up for 40 ms; the bed answers below 13 mm and lets go at 9.4 mm.
inline coupling::PressRecord record(int n_rows = 400) {
  coupling::PressRecord record({{"time", "s"},
                                {"punch_gap", "m"},
                                {"bed_height", "m"},
                                {"upper_punch_force", "N"},
                                {"lower_punch_force", "N"},
                                {"wall_axial_force", "N"},
                                {"wall_radial_pressure", "Pa"},
                                {"compact_height", "m"},
                                {"mean_overlap", "m"},
                                {"max_relative_overlap", "1"},
                                {"kinetic_energy", "J"},
                                {"punch_work", "J"},
                                {"elastic_energy", "J"},
                                {"friction_loss", "J"},
                                {"damping_loss", "J"}});
  double work = 0.0;
  for (int k = 0; k < n_rows; ++k) {
    double const t = 0.1 * k / (n_rows - 1);
    bool const loads = t <= 0.06;
    double const gap = loads ? start_gap - 0.2 * t : smallest_gap + 0.2 * (t - 0.06);
    double const reach = loads ? std::clamp((13e-3 - gap) / 5e-3, 0.0, 1.0)
                               : std::clamp((9.4e-3 - gap) / 1.4e-3, 0.0, 1.0);
    double const force =
        peak_force * std::pow(reach, loads ? 2.6 : 1.5) * (1.0 + 0.004 * std::sin(900.0 * t));
    double const height = loads ? std::min(gap, 13.2e-3 + 6.8e-3 * std::exp(-t / 0.01))
                                : std::min(gap, 9.55e-3 - 0.1e-3 * (t - 0.06) / 0.04);
    work += force * (loads ? 1.0 : -1.0) * 0.2 * 0.1 / (n_rows - 1);
    double const stored = 2.4 * std::pow(force / peak_force, 5.0 / 3.0);
    record.add_row(loads ? "loading" : "unloading",
                   {t, gap, gap, force, 0.93 * force, 0.07 * force, 0.31 * force / 3.82e-4, height,
                    1e-6 * (2.0 + 46.0 * std::pow(force / peak_force, 0.7) + (loads ? 0.0 : 9.0)),
                    0.16 * std::sqrt(force / peak_force),
                    4e-4 * std::exp(-std::pow((t - 0.012) / 0.006, 2)), work, stored,
                    0.7 * (work - stored), 0.3 * (work - stored)});
  }
  return record;
}

/// Grains of the seed's four sieve classes, thrown into a cylinder without a thought for overlaps.
inline std::vector<coupling::PicturedGrain> grains(int n = 3000) {
  std::mt19937_64 draw(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<coupling::PicturedGrain> grains;
  for (int k = 0; k < n; ++k) {
    double const pick = uniform(draw);
    double const radius = pick < 0.004  ? 1.5e-3
                          : pick < 0.02 ? 1e-3
                          : pick < 0.15 ? 0.5e-3
                                        : 0.25e-3;
    double const r = (bore_radius - radius) * std::sqrt(uniform(draw));
    double const angle = 2.0 * dem::pi * uniform(draw);
    double const z = radius + (9.4e-3 - 2.0 * radius) * uniform(draw);
    double const stress =
        1e6 * (0.4 + 2.2 * z / 9.4e-3 + 0.5 * uniform(draw) - 0.8 * r / bore_radius);
    grains.push_back(
        {.position = dem::Vec3(r * std::cos(angle), r * std::sin(angle), z),
         .radius = radius,
         .component = radius > 0.3e-3 ? std::uint8_t{0} : std::uint8_t(uniform(draw) < 0.5),
         .mean_overlap = 1e-5 * (1.0 + 0.3 * stress / 1e6),
         .stress = stress});
  }
  return grains;
}

/// A tetrahedron over the bed as a stressed tool.
inline coupling::StressPicture stress_picture() {
  coupling::PicturedTool const tool{
      .name = "upper_punch",
      .vertices = {dem::Vec3(-8e-3, -8e-3, 10e-3), dem::Vec3(8e-3, -8e-3, 10e-3),
                   dem::Vec3(0.0, 9e-3, 10e-3), dem::Vec3(0.0, 0.0, 20e-3)},
      .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
      .von_mises = {10e6, 20e6, 30e6, 40e6}};
  return {.grains = grains(500), .tools = {tool}, .time = 0.06};
}

inline coupling::ReportData report_data() {
  coupling::ReportData data;
  data.title = "E0250_CED5_D500: MgO and alumina, rigid tools";
  data.summary = {.max_force = peak_force,
                  .porosity = 0.4123,
                  .porosity_core = 0.3871,
                  .compact_height = 9.45e-3,
                  .springback = 0.181,
                  .shape_quality = 4,
                  .shape_similarity = 0.9873,
                  .grains = 3000,
                  .steps = 412345,
                  .time_step = 2.42e-7,
                  .wall_seconds = 843.0,
                  .particle_steps_per_second = 4.1e6,
                  .version = "0.1.0",
                  .checks = {{"energy_ledger", 0.0031, 0.01, true},
                             {"axial_force_balance", 0.0042, 0.01, true},
                             {"max_relative_overlap", 0.161, 0.9, true},
                             {"grains_inside", 0.0, 0.0, true}},
                  .tools = {}};
  data.record = record();
  data.grains = grains();
  data.components = {"MgO", "Al2O3"};
  data.grains_moment = "at the end of unloading";
  data.tools = {{"die", bore_radius, 0.0, 20e-3}, {"upper_punch", bore_radius, 16e-3, 16e-3}};
  data.observed = {{"max_force", 1618.0, "N", 40.0, "Ramirez-Aragon 2020, Table 7"}};
  data.comparison = {
      {"max_force", "N", peak_force, 1618.0, "Ramirez-Aragon 2020, Table 7, LIGGGHTS"},
      {"porosity", "1", 0.4123, 0.4201, "Ramirez-Aragon 2020, Table 7, LIGGGHTS"}};
  data.provenance = {{"program", "presscheck 0.1.0"},
                     {"seed", "1"},
                     {"threads", "2"},
                     {"precision", "double"},
                     {"compiler", "GCC 12.2"},
                     {"finished", "2024-05-14 10:31 UTC"}};
  data.resolved_case = "subsection Powder\n  set Total mass = 9.13 g  # <of the paper>\nend\n";
  return data;
}

} // namespace sample
