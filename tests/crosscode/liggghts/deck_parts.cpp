#include "tests/crosscode/liggghts/deck_parts.hpp"

#include "tests/crosscode/liggghts/bed.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crosscode {

std::string grain_data(dem::Packing const& packing, double half_width, double z_low,
                       double z_high) {
  std::string text = fmt::format("grains\n\n{} atoms\n3 atom types\n\n", packing.size());
  for (char const axis : {'x', 'y'})
    text += fmt::format("{} {} {}lo {}hi\n", -half_width, half_width, axis, axis);
  text += fmt::format("{} {} zlo zhi\n\nAtoms\n\n", z_low, z_high);
  std::string rates = "\nVelocities\n\n";
  for (std::size_t i = 0; i < packing.size(); ++i) {
    dem::PackedGrain const& g = packing[i];
    // fmt prints the shortest digits that read back to the same bits.
    text += fmt::format("{} {} {} {} {} {} {}\n", i + 1, g.component + 1, g.diameter,
                        seed_components()[g.component].density, g.position[0], g.position[1],
                        g.position[2]);
    rates += fmt::format("{} {} {} {} {} {} {}\n", i + 1, g.velocity[0], g.velocity[1],
                         g.velocity[2], g.spin[0], g.spin[1], g.spin[2]);
  }
  return text + rates;
}

std::string plate_stl(double z, double half_width) {
  double const reach = 2.0 * half_width; // every side passes the axis at this distance or more
  return fmt::format(
      "solid plate\nfacet normal 0 0 1\nouter loop\nvertex {0} {1} {2}\nvertex {3} {1} {2}\n"
      "vertex 0 {4} {2}\nendloop\nendfacet\nendsolid plate\n",
      -2.0 * reach, -reach, z, 2.0 * reach, 2.0 * reach);
}

std::string open_box() {
  return "atom_style granular\natom_modify map array\nboundary m m m\nnewton off\ncommunicate "
         "single vel yes\n"
         "units si\nread_data grains.data\n";
}

std::string material_properties(double grain_modulus, double tool_modulus, double cohesion) {
  // Moduli outside 5e6 .. 1e9 Pa need the peer's consent, given before the properties.
  std::string const consent = grain_modulus > 1e9   ? "hard_particles yes\n"
                              : grain_modulus < 5e6 ? "soft_particles yes\n"
                                                    : "";
  return consent +
         fmt::format("fix m1 all property/global youngsModulus peratomtype {0} {0} {1}\n"
                     "fix m2 all property/global poissonsRatio peratomtype 0.25 0.25 0.29\n"
                     "fix m3 all property/global coefficientRestitution peratomtypepair 3 "
                     "0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5\n"
                     "fix m4 all property/global coefficientFriction peratomtypepair 3 "
                     "0.2 0.2 0.2 0.2 0.2 0.2 0.2 0.2 0.2\n"
                     "fix m5 all property/global cohesionEnergyDensity peratomtypepair 3 {2} {2} 0 "
                     "{2} {2} 0 0 0 0\n",
                     grain_modulus, tool_modulus, cohesion);
}

std::string pair_law(FrictionLimit limit) {
  // `on` is the net limit, whatever the peer's manual says. Tools have no cohesion and do not know
  // the word.
  return fmt::format(
      "pair_style gran model hertz tangential history cohesion sjkr2 tangential_reduce {}\n"
      "pair_coeff * *\n",
      limit == FrictionLimit::net ? "on" : "off");
}

} // namespace crosscode
