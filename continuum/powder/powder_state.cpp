#include "continuum/powder/powder_state.hpp"

#include "continuum/tool/quote.hpp"

#include <cmath>

namespace continuum {

std::string name_of(PowderSurface surface) {
  switch (surface) {
  case PowderSurface::none:
    return "none";
  case PowderSurface::ellipse:
    return "ellipse";
  case PowderSurface::cap:
    return "cap";
  case PowderSurface::transition:
    return "transition";
  case PowderSurface::shear:
    return "shear";
  case PowderSurface::tension:
    return "tension";
  case PowderSurface::edge:
    return "edge";
  }
  return "unknown";
}

std::string PowderFailure::message() const {
  std::string const at = "powder law at relative density " + quote(relative_density) + ": ";
  if (reason == Reason::density_above_one)
    return at + "the step compacts beyond the solid (a relative density stays below 1). Is the "
                "step, or the pressing, too large?";
  if (reason == Reason::inverted)
    return at + "the step turns the body inside out (its volume stays positive). Cut the step?";
  return at + "no stress found in " + std::to_string(n_iterations) + " iterations, residual " +
         quote(least_residual) + " (a stress is on a surface or inside). Cut the step?";
}

Invariants invariants(Eigen::Vector3d const& principal_stress) {
  double const mean = principal_stress.mean();
  return {.p = -mean, .q = std::sqrt(1.5) * (principal_stress.array() - mean).matrix().norm()};
}

} // namespace continuum
