#include "coupling/diagnosis/unexplained.hpp"

#include "coupling/diagnosis/normal_draws.hpp"
#include "coupling/diagnosis/residual_forms.hpp"
#include "dem/expect.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double most_of_it = 0.8; // of the squared residuals, in the shortest range of values

void validate(std::vector<RowInput> const& inputs, Index n_rows) {
  VALIDATE(!inputs.empty(),
           "unexplained misfit: has no inputs to hang on. At what was it measured?");
  for (auto const& one : inputs)
    VALIDATE(one.values.size() == n_rows && one.values.allFinite(),
             fmt::format("{}: has {} values for {} rows, or one that is no number. Was it kept for "
                         "every row?",
                         one.name, one.values.size(), n_rows));
}

/// Orthonormal basis of what calibration leaves of some columns.
MatrixXd basis_of(Comparison const& comparison, TangentSpace const& tangent,
                  MatrixXd const& columns) {
  MatrixXd const left = tangent.project(comparison.whitener.whiten(columns));
  Eigen::ColPivHouseholderQR<MatrixXd> const qr(left);
  return qr.householderQ() * MatrixXd::Identity(left.rows(), qr.rank());
}

std::vector<Index> rows_of_channel(Observations const& observations, std::string const& channel) {
  std::vector<Index> rows;
  for (std::size_t b = 0; b < observations.blocks().size(); ++b)
    for (Index k = 0; k < observations.rows()[b].n; ++k)
      if (observations.blocks()[b].channel == channel)
        rows.push_back(observations.rows()[b].first + k);
  return rows;
}

/// Where, in standardised squares of the channel's rows: run and range of the prediction.
void locate(Observations const& observations, VectorXd const& squares, VectorXd const& predicted,
            std::vector<Index> const& rows, Unexplained& found) {
  double const all = squares(rows).sum();
  for (std::size_t b = 0; b < observations.blocks().size(); ++b) {
    auto const& block = observations.blocks()[b];
    double of_run = 0.0;
    for (std::size_t a = 0; a < observations.blocks().size(); ++a)
      if (observations.blocks()[a].run == block.run &&
          observations.blocks()[a].channel == found.channel)
        of_run += squares.segment(observations.rows()[a].first, observations.rows()[a].n).sum();
    if (of_run / all > found.run_share) {
      found.run = block.run;
      found.run_share = of_run / all;
    }
  }
  auto order = rows;
  std::ranges::stable_sort(order, {}, [&](Index k) { return predicted[k]; });
  found.value_low = predicted[order.front()];
  found.value_high = predicted[order.back()];
  for (std::size_t first = 0; first < order.size(); ++first) {
    double inside = 0.0;
    std::size_t last = first;
    for (; last < order.size() && inside < most_of_it * all; ++last)
      inside += squares[order[last]];
    if (inside < most_of_it * all)
      break;
    if (predicted[order[last - 1]] - predicted[order[first]] < found.value_high - found.value_low) {
      found.value_low = predicted[order[first]];
      found.value_high = predicted[order[last - 1]];
    }
  }
}

void find_nearest(SignatureLibrary const& library, Unexplained& found) {
  double const length = library.residual.norm();
  for (auto const& one : library.signatures)
    for (Index v = 0; v < one.projected.cols(); ++v) {
      double const d = one.projected.col(v).norm();
      double const cosine =
          d > 0.0 && length > 0.0 ? one.projected.col(v).dot(library.residual) / (d * length) : 0.0;
      if (std::abs(cosine) > std::abs(found.nearest_cosine)) {
        found.nearest = one.name;
        found.nearest_cosine = cosine;
      }
    }
}

/// What a share is taken of.
struct Misfit {
  Comparison const& comparison;
  SignatureLibrary const& library;
  double excess; ///< |z|^2 - expected

  double share(double reduction, Index n_columns) const {
    return excess > 0.0
               ? std::clamp((reduction - static_cast<double>(n_columns)) / excess, 0.0, 1.0)
               : 0.0;
  }
};

/// What the polynomial of an input takes beyond its constant, which says nothing of the input.
InputDependence dependence_on(RowInput const& input, std::vector<Index> const& rows,
                              Misfit const& misfit, MatrixXd const& draws) {
  MatrixXd const columns = polynomial_columns(input, rows);
  auto const& tangent = misfit.library.tangent;
  MatrixXd const all = basis_of(misfit.comparison, tangent, columns);
  MatrixXd const level = basis_of(misfit.comparison, tangent, columns.leftCols(1));
  auto const taken = [&](MatrixXd const& of) -> VectorXd {
    return (all.transpose() * of).colwise().squaredNorm() -
           (level.transpose() * of).colwise().squaredNorm();
  };
  double const reduction = taken(misfit.library.residual)[0];
  VectorXd const reference = taken(draws);
  return {input.name, misfit.share(reduction, all.cols() - level.cols()),
          all.cols() == level.cols()
              ? 1.0
              : Reference({reference.begin(), reference.end()}).tail_p(reduction)};
}

/// Fits a form and keeps it if it is the best of its kind in its input.
void try_form(FormColumns const& tried, Misfit const& misfit, std::vector<FormCandidate>& best) {
  MatrixXd const left =
      misfit.library.tangent.project(misfit.comparison.whitener.whiten(tried.columns));
  Eigen::ColPivHouseholderQR<MatrixXd> const qr(left);
  if (qr.rank() == 0)
    return;
  VectorXd const coefficients = qr.solve(misfit.library.residual);
  FormCandidate form = tried.form;
  form.share = misfit.share((left * coefficients).squaredNorm(), qr.rank());
  form.amplitude = coefficients.size() == 1 ? coefficients[0] : coefficients.norm();
  auto const same = std::ranges::find_if(best, [&](FormCandidate const& one) {
    return one.form == form.form && one.input == form.input;
  });
  if (same == best.end())
    best.push_back(form);
  else if (form.share > same->share)
    *same = form;
}

} // namespace

Unexplained describe_unexplained(Observations const& observations, Comparison const& comparison,
                                 SignatureLibrary const& library, MisfitTests const& tests,
                                 VectorXd const& predicted, std::vector<RowInput> const& inputs,
                                 MisfitSettings const& settings) {
  auto const n = observations.size();
  validate(inputs, n);
  auto const& worst = *std::ranges::min_element(tests.cells, {}, &CellMisfit::p_holm);
  Unexplained found{};
  found.channel = worst.channel;
  found.phase = worst.phase;
  auto const rows = rows_of_channel(observations, found.channel);

  VectorXd const raw = comparison.whitener.unwhiten(library.residual.head(n));
  // L L' gives the rows' own variances back.
  MatrixXd const L = comparison.whitener.unwhiten(MatrixXd::Identity(n, n));
  VectorXd const squares = raw.array().square() / L.rowwise().squaredNorm().array();
  locate(observations, squares, predicted, rows, found);
  found.size = raw(rows).cwiseAbs().maxCoeff();
  find_nearest(library, found);

  Misfit const misfit{comparison, library, library.residual.head(n).squaredNorm() - tests.expected};
  MatrixXd const draws = library.tangent.project_extended(
      normal_draws(settings.seed, library.tangent.n_extended(), settings.n_draws));
  for (auto const& input : inputs) {
    found.inputs.push_back(dependence_on(input, rows, misfit, draws));
    for (auto const& form : forms_in(input, rows))
      try_form(form, misfit, found.forms);
  }
  for (auto const& form : power_forms(predicted, rows))
    try_form(form, misfit, found.forms);
  std::ranges::stable_sort(found.inputs, std::greater{}, &InputDependence::share);
  std::ranges::stable_sort(found.forms, std::greater{}, &FormCandidate::share);
  return found;
}

} // namespace coupling::diagnosis
