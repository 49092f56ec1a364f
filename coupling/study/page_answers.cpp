#include "coupling/study/page_tables.hpp"
#include "coupling/study/page_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

std::string screened(Analysis const& analysis) {
  std::vector<std::string> parts;
  for (OverallInfluence const& one : analysis.influences)
    parts.push_back(fmt::format("{} ({:.0f} %, influential on {} of {})", one.factor,
                                100.0 * one.mean_share, one.n_influential,
                                analysis.responses.size()));
  return fmt::format("By their mean share of the responses' variation the factors rank: {}.",
                     fmt::join(parts, ", "));
}

void add_doubts(std::vector<std::string>& all, Analysis const& analysis) {
  for (ResponseAnalysis const& part : analysis.responses) {
    if (part.anova.lack_of_fit.p < 0.05)
      all.push_back(fmt::format("{} does not lie on its surface: lack of fit has p = {:.2g}.",
                                part.response.name, part.anova.lack_of_fit.p));
    if (part.surface.predicted_r_squared() < 0.5)
      all.push_back(fmt::format(
          "The surface of {} foretells little: predicted R\u00b2 is {:.2f} (1 is best).",
          part.response.name, part.surface.predicted_r_squared()));
  }
}

std::string extrapolated(StudyPage const& page, ResponseTrend const& part) {
  auto const& study = page.table.study;
  auto const text = [&](double value) { return shown_text(page, part.response, value); };
  auto words =
      fmt::format("{} at {} = {}, which was not run: ", part.response, study.extrapolation.factor,
                  study.factor(study.extrapolation.factor)->text(part.trend.size));
  words += part.trend.fits.size() == 1
               ? text(part.trend.fits[0].value)
               : fmt::format("{} to {} over {} forms ({} by the {} one)", text(part.trend.lowest),
                             text(part.trend.highest), part.trend.fits.size(),
                             text(part.trend.fits[0].value), part.trend.fits[0].form);
  auto const& one = *std::ranges::find(study.responses, part.response, &StudyResponse::name);
  return words + (one.observed ? fmt::format("; measured {}.", text(*one.observed)) : ".");
}

std::string foretold(StudyPage const& page, CostForecast const& one) {
  auto const& cost = page.table.study.cost;
  bool const has_interval = std::isfinite(one.seconds.run_upper);
  return fmt::format(
      "A run at {} = {} would take {} of processor time ({}){}.", cost.factor,
      cost.text(one.at, page.table.study), duration_text(one.seconds.value),
      has_interval ? fmt::format("95 %: {} to {}", duration_text(one.seconds.run_lower),
                                 duration_text(one.seconds.run_upper))
                   : "too few runs for an interval",
      std::isfinite(one.bytes) ? fmt::format(" and at most {:.2g} GB", 1e-9 * one.bytes) : "");
}

std::string validated(Analysis const& analysis) {
  auto const n = std::ranges::count_if(analysis.validation, &ValidationCheck::is_inside);
  return fmt::format("{} of {} values of validation runs lie inside their 95 % prediction "
                     "intervals.",
                     n, analysis.validation.size());
}

} // namespace

std::vector<std::string> answers(StudyPage const& page) {
  std::vector<std::string> all;
  if (!page.analysis)
    return all;
  Analysis const& analysis = *page.analysis;
  if (analysis.calibration)
    all = calibration_answers(page);
  if (!analysis.validation.empty())
    all.push_back(validated(analysis));
  if (analysis.influences.size() > 1)
    all.push_back(screened(analysis));
  add_doubts(all, analysis);
  for (ResponseTrend const& part : analysis.trends)
    all.push_back(extrapolated(page, part));
  if (analysis.cost && analysis.cost->law)
    for (CostForecast const& one : analysis.cost->forecasts)
      all.push_back(foretold(page, one));
  return all;
}

} // namespace coupling::study
