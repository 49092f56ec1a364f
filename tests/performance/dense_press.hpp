#pragma once

#include "coupling/press.hpp"
#include "dem/packing/packing.hpp"

#include <filesystem>

namespace performance {

/// A bed between an exact bore and exact punches, at rest relative to them.
struct DenseBed {
  std::filesystem::path packing_file;
  double bore_diameter = 22.05e-3; ///< [m]
  double gap = 8e-3;               ///< [m], between the punches
};

/// The seed's powder and laws (E0250_CED5_D500) on the packing, punches standing still.
/// @throws dem::InvalidInput
coupling::Press stand_still(DenseBed const& bed, dem::Precision precision);

/// Presses a bed of 21.6 thousand grains of the seed's sizes to 8 mm, at 1 m/s to save time, lets
/// it come to rest and writes it with its velocities to bed.packing_file. Half a minute.
void press_dense_bed(DenseBed const& bed);

/// The step of the press cycle [s].
double step_of(coupling::Press const& press);

} // namespace performance
