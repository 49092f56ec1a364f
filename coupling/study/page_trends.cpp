#include "coupling/study/page_tables.hpp"

#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"
#include "coupling/study/page_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

Cell number(double value, int digits) {
  return {short_number(value, digits), true};
}

/// What is to be known of a trend that is carried on, in the units shown.
std::vector<std::string> trend_words(StudyPage const& page, ResponseTrend const& part) {
  auto const& study = page.table.study;
  auto const& factor = *study.factor(study.extrapolation.factor);
  auto const [low, high] = std::ranges::minmax(part.sizes);
  double const at = part.trend.size;
  std::vector<std::string> words;
  if (at < low || at > high)
    words.push_back(fmt::format("{} = {} lies {:.3g} times beyond the nearest size that was run "
                                "({} to {}).",
                                factor.name, factor.text(at), at < low ? low / at : at / high,
                                factor.text(low), factor.text(high)));
  auto const unit = shown_unit(
      page.table, *std::ranges::find(study.responses, part.response, &StudyResponse::name));
  if (part.trend.fits.size() > 1)
    words.push_back(
        fmt::format("The choice of the form alone is worth {} {}.",
                    short_number(unit.factor * (part.trend.highest - part.trend.lowest), 2),
                    unit.text == "%" ? "points" : unit.text));
  auto const n_ranked = std::ranges::count_if(
      part.trend.fits, [](TrendFit const& one) { return std::isfinite(one.aicc); });
  if (n_ranked < 2 && part.trend.fits.size() > 1)
    words.push_back(fmt::format("{} points are too few to rank the forms.", part.sizes.size()));
  for (auto const& reason : part.trend.left_out)
    words.push_back("Left out: " + reason + ".");
  return words;
}

} // namespace

std::string trends_html(StudyPage const& page) {
  if (!page.analysis || page.analysis->trends.empty())
    return "";
  std::string out = "<section class=\"card\" id=\"trends\"><h2>A size that was not run</h2>\n";
  int k = 0;
  for (ResponseTrend const& part : page.analysis->trends) {
    auto const& response =
        *std::ranges::find(page.table.study.responses, part.response, &StudyResponse::name);
    auto const unit = shown_unit(page.table, response);
    std::vector<TableRow> rows;
    for (TrendFit const& fit : part.trend.fits)
      rows.push_back({{{fit.form},
                       number(unit.factor * fit.value, 4),
                       number(unit.factor * fit.lower, 4),
                       number(unit.factor * fit.upper, 4),
                       number(unit.factor * std::sqrt(fit.residual_ss /
                                                      static_cast<double>(part.sizes.size())),
                              3),
                       {fmt::format("{}", fit.df), true}},
                      ""});
    std::vector<std::string> const header{
        "Form", unit.head(part.response), "95 % from, if the form were true",
        "to",   "rms of the fit",         "df"};
    out += fmt::format(
        "<div class=\"charts\" id=\"trend-{}\"></div>\n<div class=\"scroll\">{}</div>\n", k++,
        table_html(header, rows));
    for (auto const& one : trend_words(page, part))
      out += "<p class=\"quiet\">" + escape_html(one) + "</p>\n";
  }
  return out + "</section>\n";
}

std::string cost_html(StudyPage const& page) {
  if (!page.analysis || !page.analysis->cost)
    return "";
  CostAnalysis const& cost = *page.analysis->cost;
  auto const& plan = page.table.study.cost;
  std::vector<TableRow> rows;
  for (CostForecast const& one : cost.forecasts)
    rows.push_back(
        {{{fmt::format("{} = {}", cost.factor, plan.text(one.at, page.table.study))},
          {duration_text(one.seconds.value), true},
          {duration_text(one.seconds.run_lower), true},
          {duration_text(one.seconds.run_upper), true},
          {std::isfinite(one.grains.value) ? fmt::format("{:.3g}", one.grains.value) : "-", true},
          number(1e-9 * one.bytes, 3),
          number(1e-9 * one.bytes_upper, 3)},
         ""});
  std::vector<std::string> const header{
      "A run at",           "Processor time",          "95 % from", "to", "Grains",
      "Memory [GB], up to", "at the grains' upper end"};
  std::string out = "<section class=\"card\" id=\"cost\"><h2>What a run costs</h2>\n"
                    "<div class=\"charts\" id=\"cost-plot\"></div>\n";
  if (cost.law)
    out += "<p>" +
           escape_html(
               std::isfinite(cost.law->exponent_lower)
                   ? fmt::format(
                         "Processor time grows as {} to the power {:.3g} (95 %: {:.3g} to {:.3g}).",
                         cost.factor, cost.law->exponent, cost.law->exponent_lower,
                         cost.law->exponent_upper)
                   : fmt::format("Processor time grows as {} to the power {:.3g} (too few runs for "
                                 "an interval).",
                                 cost.factor, cost.law->exponent)) +
           "</p>\n";
  if (cost.law && !rows.empty())
    out += "<div class=\"scroll\">" + table_html(header, rows) +
           "</div>\n<p class=\"quiet\">Memory is what the program is allowed: 200 MB and 1000 B a "
           "grain.</p>\n";
  for (auto const& statement : cost.statements)
    out += "<p class=\"quiet\">" + escape_html(statement) + "</p>\n";
  return out + "</section>\n";
}

} // namespace coupling::study
