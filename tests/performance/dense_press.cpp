#include "tests/performance/dense_press.hpp"

#include "tests/crosscode/liggghts/bed.hpp"

#include "coupling/case_file.hpp"
#include "coupling/press_set_up.hpp"
#include "dem/packing/packing_file.hpp"
#include "dem/step/advance.hpp"

#include <fmt/format.h>

#include <cmath>

namespace performance {

coupling::Press stand_still(DenseBed const& bed, dem::Precision precision) {
  std::string const file = std::filesystem::absolute(bed.packing_file).string();
  std::string const entries[] = {"Powder/Fill method=file",
                                 "Powder/Fill file=" + file,
                                 fmt::format("Powder/Fill height={} m", bed.gap),
                                 fmt::format("Tooling/Bore diameter={} m", bed.bore_diameter),
                                 "Tooling/Walls=analytic",
                                 precision == dem::Precision::full ? "Contact/Precision=double"
                                                                   : "Contact/Precision=mixed",
                                 "Press programme/Stage 1/Kind=free",
                                 "Press programme/Stage 1/Duration=1 s",
                                 "Press programme/Stage 2/Kind=none",
                                 "Press programme/Stage 3/Kind=none",
                                 "Press programme/Stage 4/Kind=none"};
  return coupling::set_up_press(
      coupling::parse_case("set Title = Dense bed\n", "dense bed", entries));
}

double step_of(coupling::Press const& press) {
  return press.setup.time_stepping.rayleigh_fraction * dem::rayleigh_time(press.world);
}

void press_dense_bed(DenseBed const& bed) {
  constexpr double loose_gap = 13e-3; // [m]
  constexpr double speed = 1.0;       // [m/s]
  constexpr int n_resting_steps = 3000;
  DenseBed const loose{bed.packing_file, bed.bore_diameter, loose_gap};
  dem::write_packing(
      loose.packing_file,
      crosscode::dense_bed({.bore_diameter = bed.bore_diameter,
                            .height = loose_gap,
                            .total_mass = 9.13e-3 * std::pow(bed.bore_diameter / 22.05e-3, 2),
                            .seed = 1}),
      crosscode::seed_components());
  coupling::Press press = stand_still(loose, dem::Precision::mixed);
  dem::Tool& punch = coupling::tool_named(press.world, "upper_punch");
  auto const n_steps = static_cast<int>(std::ceil((loose_gap - bed.gap) / speed / step_of(press)));
  punch.velocity = {0.0, 0.0, -speed};
  for (int n = 0; n < n_steps; ++n)
    dem::advance(press.world, (loose_gap - bed.gap) / speed / n_steps);
  punch.velocity.setZero();
  for (int n = 0; n < n_resting_steps; ++n)
    dem::advance(press.world, step_of(press));
  dem::write_packing(bed.packing_file,
                     dem::make_packing(press.world.grains, crosscode::seed_components()),
                     crosscode::seed_components());
}

} // namespace performance
