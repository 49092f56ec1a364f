#pragma once

#include <Eigen/Core>

#include <cmath>

namespace continuum {

/// A number that carries its derivatives by N variables: forward differentiation, exact to
/// rounding. The laws are written once over the number type; with this one the return mapping gets
/// the Jacobian of its equations and the consistent tangent without a formula of its own.
template <int N> struct Dual {
  using Slope = Eigen::Matrix<double, N, 1>;

  double value = 0.0;
  Slope slope = Slope::Zero();

  Dual() = default;
  // A plain number is a constant: formulas mix both freely.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Dual(double constant) : value(constant) {}
  Dual(double v, Slope const& s) : value(v), slope(s) {}

  /// The i-th variable at a value.
  static Dual variable(double v, int i) { return {v, Slope::Unit(i)}; }

  friend Dual operator+(Dual const& a, Dual const& b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend Dual operator-(Dual const& a, Dual const& b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend Dual operator-(Dual const& a) { return {-a.value, -a.slope}; }
  friend Dual operator*(Dual const& a, Dual const& b) {
    return {a.value * b.value, a.slope * b.value + b.slope * a.value};
  }
  friend Dual operator/(Dual const& a, Dual const& b) {
    double const ratio = a.value / b.value;
    return {ratio, (a.slope - ratio * b.slope) / b.value};
  }
  friend Dual sqrt(Dual const& a) {
    double const root = std::sqrt(a.value);
    return {root, a.slope / (2.0 * root)};
  }
  friend Dual exp(Dual const& a) {
    double const power = std::exp(a.value);
    return {power, power * a.slope};
  }
  friend Dual log(Dual const& a) { return {std::log(a.value), a.slope / a.value}; }
  friend Dual cos(Dual const& a) { return {std::cos(a.value), -std::sin(a.value) * a.slope}; }
  friend Dual tan(Dual const& a) {
    double const t = std::tan(a.value);
    return {t, (1.0 + t * t) * a.slope};
  }
};

inline double value_of(double a) {
  return a;
}
template <int N> double value_of(Dual<N> const& a) {
  return a.value;
}

} // namespace continuum
