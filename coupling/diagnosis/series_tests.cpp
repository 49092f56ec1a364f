#include "coupling/diagnosis/series_tests.hpp"

#include <algorithm>

namespace coupling::diagnosis {

using Eigen::Index;

RunsCount count_runs(Eigen::VectorXd const& series) {
  double positive = 0.0, runs = series.size() > 0 ? 1.0 : 0.0;
  for (Index k = 0; k < series.size(); ++k) {
    positive += series[k] >= 0.0 ? 1.0 : 0.0;
    if (k > 0 && (series[k] >= 0.0) != (series[k - 1] >= 0.0))
      runs += 1.0;
  }
  auto const n = static_cast<double>(series.size());
  if (n < 2.0)
    return {0.0, 0.0};
  double const expected = 2.0 * positive * (n - positive) / n + 1.0;
  return {runs - expected, std::max(0.0, (expected - 1.0) * (expected - 2.0) / (n - 1.0))};
}

double ljung_box(Eigen::VectorXd const& series, int lags) {
  auto const n = series.size();
  Eigen::VectorXd const centred = series.array() - series.mean();
  double const power = centred.squaredNorm();
  if (power == 0.0)
    return 0.0;
  double sum = 0.0;
  for (Index k = 1; k <= std::min<Index>(lags, n - 1); ++k) {
    double const r = centred.head(n - k).dot(centred.tail(n - k)) / power;
    sum += r * r / static_cast<double>(n - k);
  }
  return static_cast<double>(n) * static_cast<double>(n + 2) * sum;
}

} // namespace coupling::diagnosis
