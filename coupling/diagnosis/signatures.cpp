#include "coupling/diagnosis/signatures.hpp"

#include "coupling/diagnosis/differences.hpp"
#include "coupling/diagnosis/normal_draws.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double detected = 5.0; // standard uncertainties, diagnosis note 2a

MatrixXd variants_of(Model const& model, Parameters const& at, int mechanism, Index n_rows) {
  auto const& one = model.mechanisms()[static_cast<std::size_t>(mechanism)];
  auto const place = static_cast<std::size_t>(mechanism);
  MatrixXd variants(n_rows, 1 + 2 * static_cast<Index>(one.shapes.size()));
  variants.col(0) = size_signature(model, at, mechanism, n_rows);
  for (std::size_t k = 0; k < one.shapes.size(); ++k) {
    auto const& shape = one.shapes[k];
    auto const column = static_cast<Index>(2 * k + 1);
    Parameters other = at;
    other.shapes[place][static_cast<Index>(k)] = std::max(shape.mean - shape.sd, shape.low);
    variants.col(column) = size_signature(model, other, mechanism, n_rows);
    other.shapes[place][static_cast<Index>(k)] = std::min(shape.mean + shape.sd, shape.high);
    variants.col(column + 1) = size_signature(model, other, mechanism, n_rows);
  }
  return one.scale * variants;
}

Signature signature_of(Comparison const& comparison, TangentSpace const& tangent,
                       Parameters const& at, int mechanism) {
  auto const& one = comparison.model->mechanisms()[static_cast<std::size_t>(mechanism)];
  Signature found{.name = one.name,
                  .unit = one.unit,
                  .scale = one.scale,
                  .is_one_sided = one.is_one_sided,
                  .whitened = comparison.whitener.whiten(
                      variants_of(*comparison.model, at, mechanism, comparison.target.size())),
                  .projected = {},
                  .relative_error = 0.0};
  found.projected = tangent.project(found.whitened);
  MatrixXd const root = comparison.model->signature_error(mechanism);
  double const norm = found.whitened.col(0).norm();
  if (root.size() > 0 && norm > 0.0)
    found.relative_error = one.scale * comparison.whitener.whiten(root).norm() / norm;
  return found;
}

} // namespace

double Signature::smallest_detectable() const {
  return detected * scale / detectability();
}

MatrixXd SignatureLibrary::cosines() const {
  auto const n = static_cast<Index>(signatures.size());
  MatrixXd directions(tangent.n_extended(), n);
  for (Index j = 0; j < n; ++j) {
    auto const& one = signatures[static_cast<std::size_t>(j)];
    double const d = one.detectability();
    directions.col(j) = one.projected.col(0) * (d > 0.0 ? 1.0 / d : 0.0);
  }
  return directions.transpose() * directions;
}

SignatureLibrary signature_library(Comparison const& comparison, Fit const& baseline) {
  SignatureLibrary library{TangentSpace(baseline.slopes), {}, {}};
  Parameters off = baseline.at;
  off.sizes.setZero();
  for (int j = 0; j < static_cast<int>(comparison.model->mechanisms().size()); ++j)
    library.signatures.push_back(signature_of(comparison, library.tangent, off, j));
  VectorXd extended(library.tangent.n_extended());
  extended << baseline.residual, -baseline.unknowns;
  library.residual = library.tangent.project_extended(extended);
  return library;
}

Score score_of(Signature const& signature, VectorXd const& projected_residual) {
  Score best{-no_bound, 0.0};
  for (Index v = 0; v < signature.projected.cols(); ++v) {
    double const below = 1.0 + signature.projected.col(v).squaredNorm();
    double const along = signature.projected.col(v).dot(projected_residual);
    double value = along * along / below - std::log(below);
    if (signature.is_one_sided)
      value += 2.0 * (std::log(2.0) + log_normal_cdf(along / std::sqrt(below)));
    double const size = signature.scale * along / below;
    if (value > best.value)
      best = {value, signature.is_one_sided ? std::max(size, 0.0) : size};
  }
  return best;
}

} // namespace coupling::diagnosis
