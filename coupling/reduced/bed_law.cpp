#include "coupling/reduced/bed_law.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {

double BedLaw::loading(double solid_fraction) const {
  double const beyond = solid_fraction - onset;
  if (beyond <= 0.0)
    return 0.0;
  return std::max(stiffness * std::pow(beyond, exponent) - cohesion * beyond, 0.0);
}

double BedLaw::unloading_stress(double solid_fraction, double most) const {
  double const way = recovery * (most - onset); // phi_m - phi_u
  if (way <= 0.0)
    return 0.0;
  double const x = 1.0 - (most - solid_fraction) / way;
  return x > 0.0 ? loading(most) * std::pow(x, unloading) : 0.0;
}

void validate(BedLaw const& law) {
  auto const refuse = [](char const* name, double value, char const* reason) {
    throw dem::InvalidInput(fmt::format("bed law: {} = {}: {}", name, value, reason));
  };
  if (!(law.stiffness > 0.0))
    refuse("stiffness", law.stiffness, "must be positive. Is it in Pa?");
  if (!(law.cohesion >= 0.0))
    refuse("cohesion", law.cohesion, "must not be negative. Is its sign turned?");
  if (!(law.onset > 0.0 && law.onset < 1.0))
    refuse("onset", law.onset, "is no solid fraction (0 to 1). Is it in percent?");
  if (!(law.exponent >= 1.0))
    refuse("exponent", law.exponent, "must be at least 1. A bed stiffens as it closes?");
  if (!(law.recovery > 0.0 && law.recovery <= 1.0))
    refuse("recovery", law.recovery, "must be above 0 and at most 1. A bed gives back no more?");
  if (!(law.unloading >= 1.0))
    refuse("unloading", law.unloading, "must be at least 1. A bed softens as it opens?");
  if (!(law.wall_friction >= 0.0))
    refuse("wall_friction", law.wall_friction, "must not be negative. Is its sign turned?");
  if (!(law.radial_ratio >= 0.0))
    refuse("radial_ratio", law.radial_ratio, "must not be negative. Is its sign turned?");
  if (!(law.reversal > 0.0))
    refuse("reversal", law.reversal, "must be positive. Is it in metres?");
}

BedForces bed_forces(BedLaw const& law, Bed const& bed, double height, double smallest_height) {
  double const phi = bed.solid_area / height, most = bed.solid_area / smallest_height;
  bool const closes = height <= smallest_height;
  double const stress = closes ? law.loading(phi) : law.unloading_stress(phi, most);
  double const turn =
      closes ? 1.0 : -1.0 + 2.0 * std::exp(-(height - smallest_height) / law.reversal);
  double const wall = std::exp(turn * law.wall_friction * height / bed.bore);
  double const area = 0.25 * dem::pi * bed.bore * bed.bore;
  return {.upper = area * stress * wall,
          .lower = area * stress / wall,
          .radial_pressure = law.radial_ratio * stress};
}

} // namespace coupling::reduced
