#pragma once

#include "dem/packing/packing.hpp"

#include <string>

/// Pieces of input that every LIGGGHTS deck here shares. Atom types are the rows of
/// seed_components() counted from 1, then the tools (type 3).
namespace crosscode {

enum class FrictionLimit {
  net,
  elastic
}; ///< mu |F_H + F_C| (release 3.3.1), or mu |F_H| (3.8.0's default)

/// The data file: grains of `packing` in the box |x|, |y| < half_width, z_low < z < z_high [m].
std::string grain_data(dem::Packing const& packing, double half_width, double z_low, double z_high);

/// One triangle in the plane z, facing up, that holds the circle of radius `half_width`: it has no
/// second facet and no edge that a grain could meet.
std::string plate_stl(double z, double half_width);

/// Style, units and grains.data.
std::string open_box();

/// The seed's properties: Poisson's ratios 0.25 and 0.29 (tools), restitution 0.5, friction 0.2, no
/// cohesion at tools.
std::string material_properties(double grain_modulus, double tool_modulus, double cohesion);

/// Hertz-Mindlin with history and SJKR2.
std::string pair_law(FrictionLimit limit);

} // namespace crosscode
