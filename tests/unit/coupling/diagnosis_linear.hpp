#pragma once

#include "coupling/diagnosis/error_model.hpp"
#include "coupling/diagnosis/fit.hpp"
#include "coupling/diagnosis/normal_draws.hpp"
#include "dem/expect.hpp"

#include <cmath>
#include <string>
#include <vector>

/// Linear models, for which every number of a diagnosis has a closed form.
namespace diagnosis_support {

using namespace coupling::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

inline std::string message_of(auto const& act) {
  try {
    act();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "no error";
}

/// f = offset + slopes (theta - mean) + sum a_j v_j + scatter terms.
struct LinearModel : Model {
  VectorXd offset;
  MatrixXd slopes, effects, scattering; ///< n_rows x n of each kind, per unit
  std::vector<CalibratedParameter> parameters;
  std::vector<Mechanism> causes;
  std::vector<Scatter> repeats;
  std::vector<MatrixXd> errors; ///< roots of the signatures' covariances; empty = exact

  std::vector<CalibratedParameter> const& calibrated() const override { return parameters; }
  std::vector<Mechanism> const& mechanisms() const override { return causes; }
  std::vector<Scatter> const& scatters() const override { return repeats; }
  VectorXd predict(Parameters const& at) const override {
    VectorXd f = offset;
    for (Index p = 0; p < slopes.cols(); ++p)
      f += slopes.col(p) * (at.calibrated[p] - parameters[static_cast<std::size_t>(p)].mean);
    if (effects.cols() > 0)
      f += effects * at.sizes;
    if (scattering.cols() > 0)
      f += scattering * at.scatter;
    return f;
  }
  MatrixXd signature_error(int j) const override {
    return errors.empty() ? MatrixXd() : errors[static_cast<std::size_t>(j)];
  }
};

/// Columns of standard normal numbers.
inline MatrixXd normals(std::uint64_t seed, Index rows, Index columns) {
  return normal_draws(seed, rows, static_cast<int>(columns));
}

/// n rows, `p` calibrated parameters with prior sd 2, `m` mechanisms with scale 1.5, all random.
inline LinearModel random_linear(std::uint64_t seed, Index n, Index p, Index m) {
  LinearModel model;
  model.offset = normals(seed, n, 1);
  model.slopes = normals(seed + 1, n, p);
  model.effects = normals(seed + 2, n, m);
  for (Index k = 0; k < p; ++k)
    model.parameters.push_back(
        {.name = "theta" + std::to_string(k), .unit = "", .mean = 0.5, .sd = 2.0});
  for (Index k = 0; k < m; ++k)
    model.causes.push_back({.name = "cause" + std::to_string(k), .unit = "", .scale = 1.5});
  return model;
}

/// A positive definite covariance without structure.
inline MatrixXd random_covariance(std::uint64_t seed, Index n) {
  MatrixXd const root = normals(seed, n, n);
  return root * root.transpose() / static_cast<double>(n) + 0.2 * MatrixXd::Identity(n, n);
}

/// One block of one channel, values given.
inline ChannelBlock block(std::string run, std::string channel, Phase phase, VectorXd values) {
  auto const n = values.size();
  return {.run = std::move(run),
          .channel = std::move(channel),
          .phase = phase,
          .coordinate = n > 1 ? VectorXd(VectorXd::LinSpaced(n, 0.0, 1.0)) : VectorXd::Zero(1),
          .values = std::move(values)};
}

/// Whether a count of `n` trials with probability `p` could be so far from n p once in a million.
inline bool is_within_chance(int count, int n, double p) {
  return std::abs(count - n * p) < 4.9 * std::sqrt(n * p * (1.0 - p)) + 1.0;
}

} // namespace diagnosis_support
