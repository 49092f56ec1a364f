#include "continuum/powder/compaction_curve.hpp"

#include "continuum/powder/compaction_points.hpp"
#include "continuum/powder/least_squares.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace continuum {
namespace {

// The laws over their number type; pressures in the fits are in units of the largest.
template <class T> T heckel_density(T const& K, T const& A, double P) {
  using std::exp;
  return 1.0 - exp(-(K * P + A));
}

template <class T> T kawakita_density(T const& a, T const& b, double P, double D_0) {
  return D_0 / (1.0 - a * b * P / (1.0 + b * P));
}

/// exp(-k/P), 0 at P = 0.
template <class T> T filled(T const& k, double P) {
  using std::exp;
  return P > 0.0 ? exp(-k / P) : T(0.0);
}

template <class T>
T cooper_eaton_density(T const& a_1, T const& k_1, T const& a_2, T const& k_2, double P,
                       double D_0) {
  T const share = a_1 * filled(k_1, P) + a_2 * filled(k_2, P);
  return 1.0 / (1.0 / D_0 - share * (1.0 / D_0 - 1.0));
}

/// Straight line y = c_0 + c_1 x: where the iteration begins.
Eigen::Vector2d line(Eigen::VectorXd const& x, Eigen::VectorXd const& y) {
  Eigen::MatrixX2d columns(x.size(), 2);
  columns << Eigen::VectorXd::Ones(x.size()), x;
  return columns.colPivHouseholderQr().solve(y);
}

Eigen::VectorXd mapped(std::vector<double> const& values, auto const& function) {
  Eigen::VectorXd result(values.size());
  std::ranges::transform(values, result.begin(), function);
  return result;
}

template <class Curve>
CurveFit<Curve> fitted(Curve const& curve, Curve const& error, double residual,
                       CompactionPoints const& points) {
  return {.curve = curve,
          .standard_error = error,
          .residual = residual,
          .n_points = points.pressure.size(),
          .range = points.range};
}

/// (1/D_0 - 1/D)/(1/D_0 - 1).
double filled_share(double D, double D_0) {
  return (1.0 / D_0 - 1.0 / D) / (1.0 / D_0 - 1.0);
}

/// Best of a grid of (k_1, k_2); for given k the shares follow linearly.
Eigen::Vector4d cooper_eaton_start(CompactionPoints const& points, double D_0) {
  auto const share = mapped(points.density, [&](double D) { return filled_share(D, D_0); });
  Eigen::Vector4d best = {0.5, 0.01, 0.5, 0.5};
  double least = INFINITY;
  constexpr int n = 16; // 10^-3 to 10 times the largest pressure
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      double const k_1 = std::pow(10.0, -3.0 + 4.0 * i / (n - 1));
      double const k_2 = std::pow(10.0, -3.0 + 4.0 * j / (n - 1));
      Eigen::MatrixX2d columns(share.size(), 2);
      columns.col(0) = mapped(points.pressure, [&](double P) { return filled(k_1, P); });
      columns.col(1) = mapped(points.pressure, [&](double P) { return filled(k_2, P); });
      Eigen::Vector2d const a = columns.colPivHouseholderQr().solve(share);
      double const error = (columns * a - share).squaredNorm();
      if (error < least && a.minCoeff() > 0.0) {
        least = error;
        best = {a[0], k_1, a[1], k_2};
      }
    }
  return best;
}

} // namespace

double Heckel::density(double pressure) const {
  return heckel_density(slope, intercept, pressure);
}
double Heckel::pressure(double density) const {
  return (-std::log1p(-density) - intercept) / slope;
}
double Kawakita::density(double pressure) const {
  return kawakita_density(a, b, pressure, initial_density);
}
double Kawakita::pressure(double density) const {
  double const C = 1.0 - initial_density / density;
  return C / (b * (a - C));
}
double CooperEaton::density(double pressure) const {
  return cooper_eaton_density(a_1, k_1, a_2, k_2, pressure, initial_density);
}

CurveFit<Heckel> fit_heckel(std::span<double const> pressure, std::span<double const> density,
                            PressureRange const& range) {
  auto const points = select_points(pressure, density, range, 2, "Heckel");
  auto const start = line(mapped(points.pressure, [](double P) { return P; }),
                          mapped(points.density, [](double D) { return -std::log1p(-D); }));
  auto const model = [](auto const& a, double P) { return heckel_density(a[1], a[0], P); };
  auto const fit = fit_least_squares<2>(model, points.pressure, points.density, start, "Heckel");
  auto const curve = [&](Eigen::Vector2d const& a) {
    return Heckel{.slope = a[1] / points.unit, .intercept = a[0]};
  };
  return fitted(curve(fit.value), curve(fit.standard_error), fit.residual, points);
}

CurveFit<Kawakita> fit_kawakita(std::span<double const> pressure, std::span<double const> density,
                                PressureRange const& range, double initial_density) {
  double const D_0 = initial_density;
  auto const points = select_points(pressure, density, range, 2, "Kawakita");
  validate_initial_density(points, D_0, "Kawakita");
  // P/C = P/a + 1/(a b); noise near D_0 makes C tiny, so it is kept from zero here.
  Eigen::VectorXd const P = mapped(points.pressure, [](double value) { return value; });
  Eigen::VectorXd const C =
      mapped(points.density, [&](double D) { return std::max(1.0 - D_0 / D, 1e-3); });
  auto const guess = line(P, P.cwiseQuotient(C));
  Eigen::Vector2d start(1.0 / guess[1], guess[1] / guess[0]);
  if (!(start[0] > 0.0 && start[0] < 1.0 && start[1] > 0.0))
    start = {1.0 - D_0, 1.0};
  auto const model = [&](auto const& a, double x) { return kawakita_density(a[0], a[1], x, D_0); };
  auto const fit = fit_least_squares<2>(model, points.pressure, points.density, start, "Kawakita");
  auto const curve = [&](Eigen::Vector2d const& a, double at) {
    return Kawakita{.a = a[0], .b = a[1] / points.unit, .initial_density = at};
  };
  return fitted(curve(fit.value, D_0), curve(fit.standard_error, 0.0), fit.residual, points);
}

CurveFit<CooperEaton> fit_cooper_eaton(std::span<double const> pressure,
                                       std::span<double const> density, PressureRange const& range,
                                       double initial_density) {
  double const D_0 = initial_density;
  auto const points = select_points(pressure, density, range, 4, "Cooper-Eaton");
  validate_initial_density(points, D_0, "Cooper-Eaton");
  auto const model = [&](auto const& a, double P) {
    return cooper_eaton_density(a[0], a[1], a[2], a[3], P, D_0);
  };
  auto const fit = fit_least_squares<4>(model, points.pressure, points.density,
                                        cooper_eaton_start(points, D_0), "Cooper-Eaton");
  bool const is_turned = fit.value[1] > fit.value[3]; // the two terms have no order of their own
  auto const curve = [&](Eigen::Vector4d const& a, double at) {
    int const first = is_turned ? 2 : 0, second = 2 - first;
    return CooperEaton{.a_1 = a[first],
                       .k_1 = a[first + 1] * points.unit,
                       .a_2 = a[second],
                       .k_2 = a[second + 1] * points.unit,
                       .initial_density = at};
  };
  return fitted(curve(fit.value, D_0), curve(fit.standard_error, 0.0), fit.residual, points);
}

} // namespace continuum
