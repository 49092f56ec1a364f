#pragma once

#include "continuum/errors.hpp"
#include "continuum/powder/dual.hpp"

#include <Eigen/QR>
#include <unsupported/Eigen/NonLinearOptimization>

#include <array>
#include <cmath>
#include <span>
#include <string>

namespace continuum {

/// Parameters of a curve y(x; a) with their standard errors.
template <int N> struct Estimate {
  Eigen::Matrix<double, N, 1> value, standard_error;
  double residual; ///< sqrt[sum of squares / (n - N)]
};

/// What Eigen's Levenberg-Marquardt wants to see: residuals and their Jacobian, here by Dual.
template <int N, class Model> struct CurveResiduals {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  Model const& model; ///< (std::array<Dual<N>, N> const&, double x) -> Dual<N>
  std::span<double const> x, y;

  int inputs() const { return N; }
  int values() const { return static_cast<int>(x.size()); }

  Dual<N> at(Eigen::VectorXd const& a, std::size_t i) const {
    std::array<Dual<N>, N> parameters;
    for (int k = 0; k < N; ++k)
      parameters[k] = Dual<N>::variable(a[k], k);
    return model(parameters, x[i]) - y[i];
  }
  int operator()(Eigen::VectorXd const& a, Eigen::VectorXd& residual) const {
    for (std::size_t i = 0; i < x.size(); ++i)
      residual[i] = at(a, i).value;
    return 0;
  }
  int df(Eigen::VectorXd const& a, Eigen::MatrixXd& jacobian) const {
    for (std::size_t i = 0; i < x.size(); ++i)
      jacobian.row(i) = at(a, i).slope.transpose();
    return 0;
  }
};

/// Least squares from a start; parameters of order one. Covariance s^2 (J^T J)^-1 at the end.
/// @throws SolverFailure if the data do not tell the parameters apart
template <int N, class Model>
Estimate<N> fit_least_squares(Model const& model, std::span<double const> x,
                              std::span<double const> y, Eigen::Matrix<double, N, 1> const& start,
                              std::string const& name) {
  using Residuals = CurveResiduals<N, Model>;
  Residuals residuals{model, x, y};
  Eigen::LevenbergMarquardt<Residuals> iteration(residuals);
  iteration.parameters.xtol = iteration.parameters.ftol = 1e-14;
  iteration.parameters.maxfev = 2000;
  Eigen::VectorXd a = start;
  iteration.minimize(a);

  Eigen::VectorXd rest(residuals.values());
  Eigen::MatrixXd jacobian(residuals.values(), N);
  residuals(a, rest);
  residuals.df(a, jacobian);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
  qr.setThreshold(1e-9);
  if (!a.allFinite() || !rest.allFinite() || qr.rank() < N)
    throw SolverFailure(name + ": the points do not tell " + std::to_string(N) +
                        " parameters apart (their derivatives depend on each other). Widen the "
                        "range of pressure?");
  Eigen::Matrix<double, N, N> const normal = jacobian.transpose() * jacobian;
  double const variance = rest.squaredNorm() / (residuals.values() - N);
  return {.value = a,
          .standard_error = (variance * normal.inverse().diagonal()).cwiseSqrt(),
          .residual = std::sqrt(variance)};
}

} // namespace continuum
