#include "continuum/powder/cap_model.hpp"

#include "continuum/powder/cap_surfaces.hpp"
#include "continuum/powder/return_map.hpp"

#include <cmath>

namespace continuum {

double DruckerPragerCap::relative_density(PowderState const& state) const {
  return initial_relative_density * std::exp(state.plastic_compaction);
}

PowderResult DruckerPragerCap::respond(PowderState const& old,
                                       Eigen::Vector3d const& trial_strain) const {
  return return_map::map_back(CapSurfaces{*this}, old, trial_strain);
}

CapShape<double> cap_shape(DruckerPragerCap const& law, double compaction) {
  return CapSurfaces{law}.shape(compaction);
}

DieStress rigid_plastic_die_stress(CapShape<double> const& shape) {
  double const q = shape.D_c / std::sqrt(1.0 + 9.0 / 4.0 * shape.R * shape.R);
  double const p = shape.p_a + 3.0 / 2.0 * shape.R * shape.R * q;
  return {.p = p, .q = q, .axial = p + 2.0 / 3.0 * q, .radial = p - q / 3.0};
}

double cap_middle(double p, double q, double cohesion, double tan_friction) {
  double const d = cohesion, t = tan_friction;
  double const root =
      std::sqrt(9.0 * q * q + 24.0 * d * q * t + 8.0 * (3.0 * p * q + 2.0 * q * q) * t * t);
  return (root - (3.0 * q + 4.0 * d * t)) / (4.0 * t * t);
}

ShearDissipation dissipation(DruckerPragerCap const& law, double compaction) {
  CapSurfaces const surfaces{law};
  auto const shape = surfaces.shape(compaction);
  constexpr int n = 4000;
  ShearDissipation result{.least = INFINITY, .at_pressure = 0.0};
  bool is_negative = false;
  for (int i = 0; i <= n; ++i) {
    double const p = shape.p_tension + (shape.p_a - shape.p_tension) * i / n;
    double const q = surfaces.height(shape, p);
    auto const surface = p < shape.p_shear ? PowderSurface::shear : PowderSurface::transition;
    auto const flow = surfaces.face(surface, p, q, compaction);
    if (!(flow.flow_q > 0.0))
      continue; // the apex itself
    double const work = (p * flow.flow_p + q * flow.flow_q) / flow.flow_q;
    if (work < result.least) {
      result.least = work;
      result.at_pressure = p;
    }
    if (work < 0.0) {
      result.negative_from = is_negative ? result.negative_from : p;
      result.negative_to = p;
      is_negative = true;
    }
  }
  return result;
}

} // namespace continuum
