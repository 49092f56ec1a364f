#include "coupling/diagnosis/residual_forms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int n_places = 19;  // of steps and bumps over the range of an input
constexpr int n_periods = 12; // the shortest is a twelfth of the range

MatrixXd column(Index n_rows, std::vector<Index> const& rows, auto const& value) {
  MatrixXd one = MatrixXd::Zero(n_rows, 1);
  for (Index const k : rows)
    one(k, 0) = value(k);
  return one;
}

FormCandidate candidate(std::string form, std::string const& input, double place, double width) {
  return {.form = std::move(form),
          .input = input,
          .place = place,
          .width = width,
          .amplitude = none,
          .share = 0.0};
}

} // namespace

std::vector<FormColumns> forms_in(RowInput const& input, std::vector<Index> const& rows) {
  VectorXd const x = input.values(rows);
  double const low = x.minCoeff(), range = x.maxCoeff() - low;
  auto const n = input.values.size();
  std::vector<FormColumns> forms;
  if (!(range > 0.0))
    return forms;
  auto const& at = input.values;
  for (int k = 1; k <= n_places; ++k) {
    double const place = low + range * k / (n_places + 1.0);
    forms.push_back({candidate("step", input.name, place, none),
                     column(n, rows, [&](Index i) { return at[i] >= place ? 1.0 : 0.0; })});
    for (double const width : {0.05 * range, 0.1 * range, 0.2 * range})
      forms.push_back({candidate("bump", input.name, place, width), column(n, rows, [&](Index i) {
                         return std::exp(-0.5 * std::pow((at[i] - place) / width, 2));
                       })});
  }
  for (int k = 1; k <= n_periods; ++k) {
    double const period = range / k;
    MatrixXd both(n, 2);
    both << column(n, rows,
                   [&](Index i) { return std::sin(2.0 * std::numbers::pi * at[i] / period); }),
        column(n, rows, [&](Index i) { return std::cos(2.0 * std::numbers::pi * at[i] / period); });
    forms.push_back({candidate("periodic", input.name, none, period), both});
  }
  forms.push_back({candidate("linear", input.name, none, none),
                   column(n, rows, [&](Index i) { return (at[i] - low) / range; })});
  return forms;
}

std::vector<FormColumns> power_forms(VectorXd const& predicted, std::vector<Index> const& rows) {
  double const largest = predicted(rows).cwiseAbs().maxCoeff();
  std::vector<FormColumns> forms;
  if (largest > 0.0)
    for (double const power : {0.0, 0.5, 2.0, 3.0})
      forms.push_back({candidate("power", "prediction", power, none),
                       column(predicted.size(), rows, [&](Index i) {
                         return std::pow(std::abs(predicted[i]) / largest, power);
                       })});
  return forms;
}

MatrixXd polynomial_columns(RowInput const& input, std::vector<Index> const& rows) {
  VectorXd const x = input.values(rows);
  double const low = x.minCoeff(), range = x.maxCoeff() - low;
  std::set<double> const distinct(x.begin(), x.end());
  auto const n_columns = static_cast<Index>(std::min<std::size_t>(4, distinct.size()));
  MatrixXd columns(input.values.size(), n_columns);
  for (Index d = 0; d < n_columns; ++d)
    columns.col(d) = column(input.values.size(), rows, [&](Index i) {
      double const centred = range > 0.0 ? 2.0 * (input.values[i] - low) / range - 1.0 : 0.0;
      return d == 0 ? 1.0 : std::pow(centred, static_cast<double>(d));
    });
  return columns;
}

} // namespace coupling::diagnosis
