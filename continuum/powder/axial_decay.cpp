#include "continuum/powder/axial_decay.hpp"

#include "continuum/expect.hpp"
#include "continuum/tool/quote.hpp"

#include <cmath>
#include <numbers>

namespace continuum {
namespace {

/// (1 - exp(-x))/x, 1 at x = 0.
double mean_of_decay(double x) {
  return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

/// [1 - (1 - exp(-x))/x]/x, 1/2 at x = 0; the series where the difference would cancel.
double mean_of_growth(double x) {
  return x < 1e-3 ? 0.5 - x / 6.0 + x * x / 24.0 : (1.0 - mean_of_decay(x)) / x;
}

} // namespace

void AxialDecay::validate(std::string const& name) const {
  VALIDATE(diameter > 0.0 && height > 0.0, name + ": diameter = " + quote(diameter) +
                                               " m, height = " + quote(height) +
                                               " m (a bed has both). Is a dimension missing?");
  VALIDATE(wall_friction >= 0.0 && std::isfinite(wall_friction),
           name + ": wall friction = " + quote(wall_friction) +
               " (friction resists). Take 0 for a smooth wall?");
  VALIDATE(lateral_ratio >= 0.0 && std::isfinite(lateral_ratio),
           name + ": lateral ratio = " + quote(lateral_ratio) +
               " (a pressed bed pushes outwards). Powders have 0.2 to 0.7?");
  VALIDATE(bulk_density >= 0.0, name + ": bulk density = " + quote(bulk_density) +
                                    " kg/m^3 (mass is positive). Take 0 to leave weight out?");
}

double AxialDecay::exponent() const {
  return 4.0 * wall_friction * lateral_ratio * height / diameter;
}

double AxialDecay::stress_at(double depth, double top_stress) const {
  double const x = exponent() * depth / height;
  return top_stress * std::exp(-x) + bulk_density * gravity * depth * mean_of_decay(x);
}

double AxialDecay::bottom_stress(double top_stress) const {
  return stress_at(height, top_stress);
}

double AxialDecay::transmission() const {
  return std::exp(-exponent());
}

double AxialDecay::mean_stress(double top_stress) const {
  double const x = exponent();
  return top_stress * mean_of_decay(x) + bulk_density * gravity * height * mean_of_growth(x);
}

double AxialDecay::wall_force(double top_stress) const {
  double const area = std::numbers::pi / 4.0 * diameter * diameter;
  return (top_stress - bottom_stress(top_stress) + bulk_density * gravity * height) * area;
}

double wall_friction_of(double diameter, double height, double top_stress, double bottom_stress,
                        double radial_stress, double level) {
  VALIDATE(top_stress >= bottom_stress && bottom_stress > 0.0 && radial_stress > 0.0,
           "wall friction: stresses " + quote(top_stress) + " (moving punch), " +
               quote(bottom_stress) + " (fixed), " + quote(radial_stress) +
               " Pa (compression, and less at the fixed punch). Are the punches interchanged?");
  double const ratio = top_stress / bottom_stress;
  return diameter / (4.0 * height) * bottom_stress / radial_stress *
         std::pow(ratio, level / height) * std::log(ratio);
}

} // namespace continuum
