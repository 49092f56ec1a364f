#include "coupling/study/page_curves.hpp"
#include "coupling/study/page_units.hpp"
#include "coupling/study/study_page.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace coupling::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int nodes_of_surface = 41; // a side
constexpr int nodes_of_line = 61;

/// Six digits: more than a plot shows.
Json rounded(double value) {
  if (!std::isfinite(value))
    return nullptr;
  std::array<char, 32> text{};
  auto const end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 6);
  double short_value = 0.0;
  std::from_chars(text.begin(), end.ptr, short_value);
  return short_value;
}

Json optional_number(std::optional<double> const& value, double factor) {
  return value ? rounded(factor * *value) : Json(nullptr);
}

/// Values from -1 to 1 in coded units, and as far as the runs reach.
GridAxis reach_of(ResponseSurface const& surface, Eigen::Index f, int n) {
  auto const column = surface.data.coded.col(f);
  return {
      .low = std::min(-1.0, column.minCoeff()), .high = std::max(1.0, column.maxCoeff()), .n = n};
}

Json factor_json(StudyFactor const& factor, ResponseSurface const* surface, Eigen::Index f) {
  Json json{{"name", factor.name},
            {"unit", factor.unit},
            {"centre", rounded(factor.number(factor.natural(0.0)))}};
  if (surface != nullptr) {
    auto const reach = reach_of(*surface, f, 2);
    json["low"] = rounded(factor.number(factor.natural(reach.low)));
    json["high"] = rounded(factor.number(factor.natural(reach.high)));
  }
  return json;
}

/// The surface over two factors, the others at their centre: rows of the second, rising.
Json grid_json(ResponseSurface const& surface, Eigen::Index a, Eigen::Index b, double factor) {
  auto const x = reach_of(surface, a, nodes_of_surface), y = reach_of(surface, b, nodes_of_surface);
  Json values = Json::array();
  Eigen::VectorXd point = Eigen::VectorXd::Zero(surface.n_factors());
  for (int j = 0; j < y.n; ++j)
    for (int i = 0; i < x.n; ++i) {
      point[a] = x.at(i);
      point[b] = y.at(j);
      values.push_back(rounded(factor * surface.value(point)));
    }
  return {{"first", a}, {"second", b}, {"n", nodes_of_surface}, {"values", values}};
}

/// The surface over its one factor with both intervals.
Json line_json(ResponseSurface const& surface, StudyFactor const& factor, double unit) {
  auto const x = reach_of(surface, 0, nodes_of_line);
  Json json;
  for (int k = 0; k < x.n; ++k) {
    auto const one = surface.predict(Eigen::VectorXd::Constant(1, x.at(k)));
    json["x"].push_back(rounded(factor.number(factor.natural(x.at(k)))));
    json["y"].push_back(rounded(unit * one.value));
    json["mean_low"].push_back(rounded(unit * one.mean_lower));
    json["mean_high"].push_back(rounded(unit * one.mean_upper));
    json["run_low"].push_back(rounded(unit * one.run_lower));
    json["run_high"].push_back(rounded(unit * one.run_upper));
  }
  return json;
}

/// Runs of the design, or beside it: where they stand, what came out and what the surface says.
Json runs_json(StudyPage const& page, ResponseAnalysis const& part, bool are_validation,
               double unit) {
  auto const& table = page.table;
  Json runs = Json::array();
  for (std::size_t const r : are_validation ? table.validation() : table.finished()) {
    ResultRow const& row = table.rows[r];
    Eigen::VectorXd coded(static_cast<Eigen::Index>(table.study.factors.size()));
    Json natural = Json::array();
    for (std::size_t f = 0; f < table.study.factors.size(); ++f) {
      coded[static_cast<Eigen::Index>(f)] = table.study.factors[f].coded(row.run.natural[f]);
      natural.push_back(rounded(table.study.factors[f].number(row.run.natural[f])));
    }
    auto const foretold = part.surface.predict(coded);
    runs.push_back({{"run", row.run.id},
                    {"setup", row.run.setup},
                    {"at", natural},
                    {"value", rounded(unit * row.value(part.response.quantity))},
                    {"foretold", rounded(unit * foretold.value)},
                    {"low", rounded(unit * foretold.run_lower)},
                    {"high", rounded(unit * foretold.run_upper)}});
  }
  return runs;
}

Json response_json(StudyPage const& page, ResponseAnalysis const& part) {
  auto const unit = shown_unit(page.table, part.response);
  ResponseSurface const& surface = part.surface;
  Json json{{"name", part.response.name},
            {"quantity", part.response.quantity},
            {"unit", unit.text},
            {"target", optional_number(part.response.target, unit.factor)},
            {"sd", optional_number(part.response.uncertainty, unit.factor)},
            {"observed", optional_number(part.response.observed, unit.factor)},
            {"runs", runs_json(page, part, false, unit.factor)},
            {"validation", runs_json(page, part, true, unit.factor)},
            {"grids", Json::array()}};
  for (Coefficient const& c : surface.coefficients())
    json["coefficients"].push_back({{"term", c.name},
                                    {"value", rounded(unit.factor * c.value)},
                                    {"low", rounded(unit.factor * c.lower)},
                                    {"high", rounded(unit.factor * c.upper)},
                                    {"p", rounded(c.p)}});
  for (Eigen::Index a = 0; a < surface.n_factors(); ++a)
    for (Eigen::Index b = a + 1; b < surface.n_factors(); ++b)
      json["grids"].push_back(grid_json(surface, a, b, unit.factor));
  if (surface.n_factors() == 1)
    json["line"] = line_json(surface, page.table.study.factors[0], unit.factor);
  return json;
}

Json calibration_json(StudyPage const& page) {
  auto const& factors = page.table.study.factors;
  Calibration const& found = *page.analysis->calibration;
  Json json{{"factors", Json::array()}, {"regions", Json::array()}};
  for (std::size_t f = 0; f < factors.size(); ++f)
    json["factors"].push_back({{"value", rounded(factors[f].number(found.factors[f].value))},
                               {"low", rounded(factors[f].number(found.factors[f].lower))},
                               {"high", rounded(factors[f].number(found.factors[f].upper))},
                               {"held", found.factors[f].is_held}});
  for (JointRegion const& region : page.analysis->regions) {
    Json lines = Json::array();
    for (ContourLine const& line : region.lines) {
      lines.push_back(Json::array());
      for (auto const& [x, y] : line)
        lines.back().push_back({factors[static_cast<std::size_t>(region.first)].number(x),
                                factors[static_cast<std::size_t>(region.second)].number(y)});
    }
    json["regions"].push_back(
        {{"first", region.first}, {"second", region.second}, {"lines", lines}});
  }
  return json;
}

/// Sizes from where the trend is carried to, to the other end of the runs, in equal ratios.
std::vector<double> sizes_between(ResponseTrend const& part) {
  auto const [least, most] = std::ranges::minmax(part.sizes);
  double const low = std::min(least, part.trend.size), high = std::max(most, part.trend.size);
  std::vector<double> sizes;
  sizes.reserve(nodes_of_line);
  for (int k = 0; k < nodes_of_line; ++k)
    sizes.push_back(low * std::pow(high / low, static_cast<double>(k) / (nodes_of_line - 1)));
  sizes.back() = high; // to the bit, so that nothing is carried beyond it
  return sizes;
}

Json trend_json(StudyPage const& page, ResponseTrend const& part) {
  auto const& study = page.table.study;
  auto const& factor = *study.factor(study.extrapolation.factor);
  auto const& response = *std::ranges::find(study.responses, part.response, &StudyResponse::name);
  auto const unit = shown_unit(page.table, response);
  Json json{{"response", part.response},
            {"unit", unit.text},
            {"factor", factor.name},
            {"factor_unit", factor.unit},
            {"at", rounded(factor.number(part.trend.size))},
            {"observed", optional_number(response.observed, unit.factor)},
            {"forms", Json::array()}};
  for (std::size_t k = 0; k < part.sizes.size(); ++k) {
    json["sizes"].push_back(rounded(factor.number(part.sizes[k])));
    json["values"].push_back(rounded(unit.factor * part.responses[k]));
  }
  for (TrendFit const& fit : part.trend.fits)
    json["forms"].push_back({{"name", fit.form}});
  for (double const size : sizes_between(part)) {
    auto const here = extrapolate(part.sizes, part.responses, size, part.forms);
    for (std::size_t f = 0; f < here.fits.size(); ++f) {
      auto& form = json["forms"][f];
      form["x"].push_back(rounded(factor.number(size)));
      form["y"].push_back(rounded(unit.factor * here.fits[f].value));
      form["low"].push_back(rounded(unit.factor * here.fits[f].lower));
      form["high"].push_back(rounded(unit.factor * here.fits[f].upper));
    }
  }
  return json;
}

/// Time of one processor against the cost's factor, in hours.
Json cost_json(StudyPage const& page) {
  CostAnalysis const& cost = *page.analysis->cost;
  auto const& study = page.table.study;
  auto const* const factor = study.cost.is_of_grains ? nullptr : study.factor(cost.factor);
  auto const size = [&](double at) { return rounded(factor == nullptr ? at : factor->number(at)); };
  constexpr double hour = 3600.0;
  Json json{{"factor", cost.factor}, {"unit", factor == nullptr ? "" : factor->unit}};
  std::vector<double> all = cost.sizes;
  for (std::size_t k = 0; k < cost.sizes.size(); ++k) {
    json["sizes"].push_back(size(cost.sizes[k]));
    json["hours"].push_back(rounded(cost.seconds[k] / hour));
  }
  for (CostForecast const& one : cost.forecasts) {
    all.push_back(one.at);
    json["at"].push_back(size(one.at));
    json["foretold"].push_back(rounded(one.seconds.value / hour));
    json["foretold_low"].push_back(rounded(one.seconds.run_lower / hour));
    json["foretold_high"].push_back(rounded(one.seconds.run_upper / hour));
  }
  if (!cost.law)
    return json;
  auto const [low, high] = std::ranges::minmax(all);
  for (int k = 0; k < nodes_of_line; ++k) {
    double const x = low * std::pow(high / low, static_cast<double>(k) / (nodes_of_line - 1));
    auto const one = cost.law->predict(x);
    json["x"].push_back(size(x));
    json["y"].push_back(rounded(one.value / hour));
    json["low"].push_back(rounded(one.run_lower / hour));
    json["high"].push_back(rounded(one.run_upper / hour));
  }
  return json;
}

} // namespace

std::string study_page_json(StudyPage const& page) {
  auto const& study = page.table.study;
  bool const is_fitted = page.analysis && !page.analysis->responses.empty();
  Json json{{"factors", Json::array()}, {"responses", Json::array()}, {"trends", Json::array()}};
  for (std::size_t f = 0; f < study.factors.size(); ++f)
    json["factors"].push_back(
        factor_json(study.factors[f], is_fitted ? &page.analysis->responses[0].surface : nullptr,
                    static_cast<Eigen::Index>(f)));
  if (is_fitted) {
    for (ResponseAnalysis const& part : page.analysis->responses)
      json["responses"].push_back(response_json(page, part));
    if (page.analysis->calibration)
      json["calibration"] = calibration_json(page);
    for (ResponseTrend const& part : page.analysis->trends)
      json["trends"].push_back(trend_json(page, part));
    if (page.analysis->cost && !page.analysis->cost->sizes.empty())
      json["cost"] = cost_json(page);
  }
  // Less of each run where they are many: the page shall open.
  std::size_t const n_runs = std::max<std::size_t>(1, page.table.rows.size());
  json["curves"] =
      Json::parse(curves_json(page.table, std::clamp<std::size_t>(24000 / n_runs, 60, 240)));
  json["shapes"] = Json::parse(shapes_json(page.table, n_runs > 100 ? 60 : 120));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace coupling::study
