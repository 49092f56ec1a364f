#include "coupling/diagnosis/error_model.hpp"

#include "coupling/diagnosis/differences.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd sd_of(MatrixXd const& covariance) {
  return covariance.diagonal().cwiseSqrt();
}

void validate_null(VectorXd const& sizes, Model const& model) {
  VALIDATE(sizes.size() == 0 || (sizes.size() == static_cast<Index>(model.mechanisms().size()) &&
                                 sizes.allFinite() && sizes.minCoeff() >= 0.0),
           fmt::format("sizes on clean data: are {} numbers for {} mechanisms, or negative. Were "
                       "they found with the same list of mechanisms?",
                       sizes.size(), model.mechanisms().size()));
}

MatrixXd form_covariance(Observations const& observations, Model const& model,
                         Tolerances const& tolerances, Parameters const& at,
                         std::vector<int> const& active) {
  MatrixXd sum = MatrixXd::Zero(observations.size(), observations.size());
  for (int const j : active)
    sum += smooth_covariance(observations,
                             tolerances.form_share *
                                 change_by(model, at, j, observations.size()).cwiseAbs(),
                             tolerances);
  return sum;
}

MatrixXd signature_covariance(Model const& model, Parameters const& at,
                              std::vector<int> const& active, Index n_rows) {
  MatrixXd sum = MatrixXd::Zero(n_rows, n_rows);
  for (int const j : active) {
    MatrixXd const root = at.sizes[j] * model.signature_error(j);
    if (root.size() > 0)
      sum += root * root.transpose();
  }
  return sum;
}

MatrixXd null_covariance(Model const& model, Parameters const& at, VectorXd const& sizes,
                         Index n_rows) {
  MatrixXd sum = MatrixXd::Zero(n_rows, n_rows);
  Parameters off = at;
  off.sizes.setZero();
  for (Index j = 0; j < sizes.size(); ++j) {
    if (sizes[j] == 0.0)
      continue;
    VectorXd const v = sizes[j] * size_signature(model, off, static_cast<int>(j), n_rows);
    sum += v * v.transpose();
  }
  return sum;
}

} // namespace

ErrorModel error_model(Observations const& observations, Model const& model,
                       ErrorSources const& sources, Parameters const& at,
                       std::vector<int> const& active) {
  auto const& tolerances = sources.tolerances;
  validate(tolerances);
  validate_null(sources.null_sizes, model);
  auto const n = observations.size();
  auto const of_blocks = errors_of_blocks(observations, sources.channels);
  VectorXd const f = predict_rows(model, at, n);

  MatrixXd const sensor = sensor_covariance(observations, of_blocks, f);
  MatrixXd const repeatability =
      repeatability_covariance(observations, scatter_changes(model, at, n));
  MatrixXd const numerical = numerical_covariance(sources.numerical, tolerances.bias_share, n);
  MatrixXd const tolerance = smooth_covariance(
      observations, tolerance_sd(observations, of_blocks, f, tolerances), tolerances);
  VectorXd const kink = kink_sd(observations, of_blocks, f, tolerances);
  MatrixXd const form = form_covariance(observations, model, tolerances, at, active);
  MatrixXd const signature = signature_covariance(model, at, active, n);
  MatrixXd const null = null_covariance(model, at, sources.null_sizes, n);

  ErrorModel errors;
  errors.covariance = sensor + repeatability + numerical + tolerance + form + signature + null;
  errors.covariance.diagonal() += kink.cwiseAbs2();
  errors.bias = sources.numerical.bias.size() > 0 ? sources.numerical.bias : VectorXd::Zero(n);
  errors.shares = {sd_of(sensor),    sd_of(repeatability), sd_of(numerical),
                   sd_of(tolerance), sd_of(form),          kink,
                   sd_of(signature), sd_of(null)};
  return errors;
}

} // namespace coupling::diagnosis
