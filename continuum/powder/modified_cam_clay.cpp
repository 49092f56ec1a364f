#include "continuum/powder/modified_cam_clay.hpp"

#include "continuum/expect.hpp"
#include "continuum/powder/return_map.hpp"
#include "continuum/tool/quote.hpp"

namespace continuum {
namespace {

/// The law as the return mapping sees it. With m = (p_c - c)/2 and h = (p_c + c)/2 the ellipse is
///     f = sqrt[(p - m)^2 + q^2/M^2] - h = 0:
/// the same zero and the same normal as F, but nearly linear along its normal, which is what
/// Newton's iteration wants.
struct Mapped {
  ModifiedCamClay const& law;

  template <class T> T density_at(T const& compaction) const {
    using std::exp;
    return law.initial_relative_density * exp(compaction);
  }
  double density(double compaction) const { return density_at(compaction); }

  template <class T> StressPair<T> elastic(T const& v, T const& q, T const& compaction) const {
    T const density = density_at(compaction);
    return std::visit([&](auto const& e) { return e(v, q, density); }, law.elasticity);
  }
  template <class T> T consolidation(T const& compaction) const {
    T const density = density_at(compaction);
    return std::visit([&](auto const& h) { return h(compaction, density); }, law.hardening);
  }
  template <class T>
  return_map::Face<T> face(PowderSurface, T const& p, T const& q, T const& compaction) const {
    using std::sqrt;
    T const top = consolidation(compaction);
    T const middle = (top - law.cohesion) / 2.0, half = (top + law.cohesion) / 2.0;
    T const x = p - middle, y = q / law.slope;
    T const radius = sqrt(x * x + y * y);
    return {radius - half, x / radius, y / (law.slope * radius)};
  }
  double yield(double p, double q, double compaction) const {
    double const top = consolidation(compaction);
    return std::hypot(p - (top - law.cohesion) / 2.0, q / law.slope) - (top + law.cohesion) / 2.0;
  }
  template <class T> std::array<T, 2> edge(T const& p, T const& q, T const&) const {
    return {p, q}; // there is none
  }
  std::array<PowderSurface, 5> candidates(double, double, double) const {
    return {PowderSurface::ellipse, PowderSurface::none};
  }
  bool admits(PowderSurface, double, double, double, return_map::PlasticStep const&) const {
    return true; // the whole ellipse
  }
};

} // namespace

void ModifiedCamClay::validate(std::string const& name) const {
  VALIDATE(std::isfinite(slope) && slope > 0.0,
           name + ": M = " + quote(slope) +
               " (the ellipse needs a positive height to be convex). Powders have 0.8 to 1.6?");
  VALIDATE(std::isfinite(cohesion) && cohesion >= 0.0,
           name + ": cohesion = " + quote(cohesion) +
               " Pa (it is an isotropic tension that is borne). Is its sign turned?");
  validate_initial_density(name, initial_relative_density);
  std::visit([&](auto const& e) { e.validate(name); }, elasticity);
  std::visit([&](auto const& h) { h.validate(name, initial_relative_density); }, hardening);
  auto const* pressure = std::get_if<PressureElasticity>(&elasticity);
  auto const* index = std::get_if<IndexHardening>(&hardening);
  VALIDATE(!pressure || !index || pressure->kappa == index->kappa,
           name + ": kappa = " + quote(pressure ? pressure->kappa : 0.0) +
               " of the elasticity is not kappa = " + quote(index ? index->kappa : 0.0) +
               " of the hardening (one recompression line has one slope). Which is meant?");
  VALIDATE(!pressure || pressure->reference_pressure <= consolidation_pressure({}),
           name + ": initial pressure = " + quote(pressure ? pressure->reference_pressure : 0.0) +
               " Pa is above p_c = " + quote(consolidation_pressure({})) +
               " Pa (a stress is on the surface or inside). Raise the preconsolidation?");
}

double ModifiedCamClay::relative_density(PowderState const& state) const {
  return Mapped{*this}.density(state.plastic_compaction);
}

double ModifiedCamClay::consolidation_pressure(PowderState const& state) const {
  return Mapped{*this}.consolidation(state.plastic_compaction);
}

PowderResult ModifiedCamClay::respond(PowderState const& old,
                                      Eigen::Vector3d const& trial_strain) const {
  return return_map::map_back(Mapped{*this}, old, trial_strain);
}

double virgin_stress_ratio(double slope, double plastic_share, double poisson_ratio) {
  double const L = plastic_share, nu = poisson_ratio;
  auto const excess = [&](double eta) {
    return eta * (1.0 + nu) * (1.0 - L) / (3.0 * (1.0 - 2.0 * nu)) +
           3.0 * eta * L / (slope * slope - eta * eta) - 1.0;
  };
  // The left-hand side rises from 0 without bound between eta = 0 and M.
  double low = 0.0, high = slope;
  for (int i = 0; i < 200 && low < high; ++i) {
    double const middle = (low + high) / 2.0;
    if (middle == low || middle == high)
      break;
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return low;
}

double lateral_ratio(double stress_ratio) {
  return (3.0 - stress_ratio) / (3.0 + 2.0 * stress_ratio);
}

} // namespace continuum
