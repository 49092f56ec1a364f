#include "continuum/verification/problems.hpp"

namespace continuum::verification {

Checks check_elasticity() {
  Checks all;
  for (auto const check : {check_tube_in_plane_strain, check_tube_with_free_ends,
                           check_thick_elliptic_plate, check_manufactured_solution, check_beams,
                           check_discs, check_hertz_pressure, check_column}) {
    Checks const rows = check();
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

} // namespace continuum::verification
