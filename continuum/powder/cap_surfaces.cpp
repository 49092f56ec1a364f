#include "continuum/powder/cap_surfaces.hpp"

#include <algorithm>

namespace continuum {

double CapSurfaces::yield(double p, double q, double compaction) const {
  auto const s = shape(compaction);
  double const cut = s.p_tension - p;
  if (p >= s.p_a)
    return face(PowderSurface::cap, p, q, compaction).yield;
  auto const surface = p < s.p_shear ? PowderSurface::shear : PowderSurface::transition;
  // Inside the arc's square its own distance is no measure of being inside the yield surface.
  double const shear =
      surface == PowderSurface::shear ? face(surface, p, q, compaction).yield : q - height(s, p);
  return std::max(cut, shear);
}

std::array<PowderSurface, 5> CapSurfaces::candidates(double p, double, double compaction) const {
  using enum PowderSurface;
  auto const s = shape(compaction);
  std::array<PowderSurface, 5> order = {cap, transition, shear, edge, tension};
  if (p < s.p_tension)
    order = {tension, edge, shear, transition, cap};
  else if (p < s.p_shear)
    order = {shear, transition, cap, edge, tension};
  else if (p < s.p_a)
    order = {transition, cap, shear, edge, tension};
  if (law.transition == 0.0)
    std::ranges::replace(order, transition, none);
  return order;
}

bool CapSurfaces::admits(PowderSurface surface, double p, double q, double compaction,
                         return_map::PlasticStep const& flow) const {
  auto const s = shape(compaction);
  // Neighbouring surfaces have the same end and the same flow where they meet.
  double const slack = 1e-10 * (s.D_c + s.p_b);
  switch (surface) {
  case PowderSurface::cap:
    return p >= s.p_a - slack;
  case PowderSurface::transition:
    return law.transition > 0.0 && p <= s.p_a + slack && p >= s.p_shear - slack &&
           q >= (1.0 - law.transition / s.cos_b) * s.D_c - slack;
  case PowderSurface::shear:
    return p <= s.p_shear + slack && p >= s.p_tension - slack && q >= -slack;
  case PowderSurface::tension:
    return q <= s.d + s.p_tension * s.tan_b + slack;
  case PowderSurface::edge: {
    auto const [m_p, m_q] = shear_flow(s, p, q);
    // At an apex Abaqus' ellipse flows without shear, so only a trial without shear ends there.
    if (m_q < 1e-9)
      return flow.deviatoric < 1e-12;
    double const shear = flow.deviatoric / m_q;
    return shear >= 0.0 && flow.volumetric - shear * m_p <= 1e-12;
  }
  default:
    return false;
  }
}

} // namespace continuum
