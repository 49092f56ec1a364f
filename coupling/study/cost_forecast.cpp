#include "coupling/study/cost_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int few_degrees = 3; // Student's factor is 3.2 and more up to here

struct Points {
  std::vector<double> sizes, values;
};

/// Grains of a run: as its table of results or its estimate tells; 0 where neither does.
double grains_of(ResultRow const& row) {
  double const told = row.value("grains");
  return std::isfinite(told) ? told : row.estimate.grains;
}

std::size_t factor_index(ResultsTable const& table) {
  auto const& factors = table.study.factors;
  return static_cast<std::size_t>(
      std::ranges::find(factors, table.study.cost.factor, &StudyFactor::name) - factors.begin());
}

/// A value of each finished run against its size; without those that do not have both.
template <class Value> Points points_of(ResultsTable const& table, Value value) {
  Points points;
  for (std::size_t const r : table.finished()) {
    ResultRow const& row = table.rows[r];
    double const size =
        table.study.cost.is_of_grains ? grains_of(row) : row.run.natural[factor_index(table)];
    double const y = value(row);
    if (!(size > 0.0) || !(y > 0.0) || !std::isfinite(y))
      continue;
    points.sizes.push_back(size);
    points.values.push_back(y);
  }
  return points;
}

std::optional<PowerLaw> law_of(Points const& points) {
  if (std::set<double>(points.sizes.begin(), points.sizes.end()).size() < 2)
    return std::nullopt;
  return fit_power_law(points.sizes, points.values);
}

CostPrediction exactly(double value) {
  return {value, value, value, value, value};
}

CostForecast forecast(CostAnalysis const& cost, bool is_of_grains, double at) {
  CostForecast one{.at = at,
                   .seconds = cost.law ? cost.law->predict(at) : exactly(unknown),
                   .grains = is_of_grains  ? exactly(at)
                             : cost.grains ? cost.grains->predict(at)
                                           : exactly(unknown),
                   .bytes = unknown,
                   .bytes_upper = unknown};
  one.bytes = bytes_of_run(one.grains.value);
  one.bytes_upper = bytes_of_run(one.grains.run_upper);
  return one;
}

std::string how_sure(CostAnalysis const& cost) {
  int const df = cost.law->fit.residual_df;
  if (df == 0)
    return "Two runs fix a power law and leave nothing to judge it by: no interval can be stated.";
  if (df <= few_degrees)
    return fmt::format("{} runs leave {} degree{} of freedom: the intervals are wide because the "
                       "runs are few.",
                       cost.sizes.size(), df, df == 1 ? "" : "s");
  return {};
}

std::string how_far(ResultsTable const& table, CostAnalysis const& cost, double at) {
  auto const [low, high] = std::ranges::minmax(cost.sizes);
  if (at >= low && at <= high)
    return {};
  auto const text = [&](double value) { return table.study.cost.text(value, table.study); };
  return fmt::format("{} = {} lies outside the runs ({} to {}), {:.3g} times beyond the nearest: "
                     "the interval holds if the power law does.",
                     cost.factor, text(at), text(low), text(high), at < low ? low / at : at / high);
}

void add_statements(CostAnalysis& cost, ResultsTable const& table) {
  auto const add = [&](std::string text) {
    if (!text.empty())
      cost.statements.push_back(std::move(text));
  };
  auto const n_runs = table.finished().size();
  if (cost.sizes.size() < n_runs)
    add(fmt::format("{} of {} runs tell their {}.", cost.sizes.size(), n_runs,
                    table.study.cost.is_of_grains ? "processor time and their grains"
                                                  : "processor time"));
  if (!cost.law)
    return add(fmt::format("Processor time is no power law of {} yet: the runs that tell it have "
                           "fewer than two different values of {}.",
                           cost.factor, cost.factor));
  add(how_sure(cost));
  for (CostForecast const& one : cost.forecasts)
    add(how_far(table, cost, one.at));
}

} // namespace

CostAnalysis analyse_cost(ResultsTable const& table) {
  auto const& wanted = table.study.cost;
  auto const times = points_of(table, [](ResultRow const& row) { return row.cpu_seconds; });
  CostAnalysis cost{.factor = wanted.factor,
                    .sizes = times.sizes,
                    .seconds = times.values,
                    .law = law_of(times),
                    .grains =
                        wanted.is_of_grains ? std::nullopt : law_of(points_of(table, grains_of)),
                    .forecasts = {},
                    .statements = {}};
  for (double const at : wanted.predict_at)
    cost.forecasts.push_back(forecast(cost, wanted.is_of_grains, at));
  add_statements(cost, table);
  return cost;
}

} // namespace coupling::study
