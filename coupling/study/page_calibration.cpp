#include "coupling/study/page_tables.hpp"
#include "coupling/study/page_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

constexpr double far_off = 1.96; // standard deviations

std::string calibrated(StudyPage const& page) {
  Calibration const& found = *page.analysis->calibration;
  std::vector<std::string> free, held, targets;
  for (std::size_t f = 0; f < found.factors.size(); ++f) {
    auto const& one = found.factors[f];
    auto const text = [&](double value) { return short_text(page.table.study.factors[f], value); };
    if (one.is_held)
      held.push_back(fmt::format("{} held at {}", one.name, text(one.value)));
    else
      free.push_back(fmt::format("{} = {} (95 %: {} to {}{})", one.name, text(one.value),
                                 text(one.lower), text(one.upper),
                                 one.is_at_bound ? ", at a bound" : ""));
  }
  for (auto const& one : found.targets)
    targets.push_back(
        fmt::format("{} = {}", one.response, shown_text(page, one.response, one.target)));
  return fmt::format("Calibrated to {}: {}{}.", fmt::join(targets, ", "), fmt::join(free, ", "),
                     held.empty() ? "" : fmt::format(", with {}", fmt::join(held, ", ")));
}

std::string agreement(Calibration const& found) {
  if (found.df <= 0)
    return "There are as many free factors as targets, or more: nothing is left to tell whether "
           "the "
           "targets agree.";
  return fmt::format(
      "The targets {} each other: \u03c7\u00b2 = {:.3g} with {} degree{} of freedom, p "
      "= {:.2g}.{}",
      found.p < 0.05 ? "contradict" : "agree with", found.chi_squared, found.df,
      found.df == 1 ? "" : "s", found.p,
      found.contradicts ? " The intervals say how sharply the compromise is "
                          "defined, not where the truth is."
                        : "");
}

/// `E = 1375 MPa, CED = 7e6 J/m^3`: the free factors where a target alone is met best.
std::string wanted(StudyPage const& page, CalibratedTarget const& one) {
  std::vector<std::string> parts;
  for (std::size_t f = 0; f < one.wanted.size(); ++f)
    if (!page.analysis->calibration->factors[f].is_held)
      parts.push_back(fmt::format("{} = {}", page.table.study.factors[f].name,
                                  short_text(page.table.study.factors[f], one.wanted[f])));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void add_targets(std::vector<std::string>& all, StudyPage const& page) {
  for (CalibratedTarget const& one : page.analysis->calibration->targets) {
    auto const text = [&](double value) { return shown_text(page, one.response, value); };
    if (!one.is_reachable)
      all.push_back(fmt::format("{} = {} is out of reach: inside the bounds its surface lies "
                                "between {} and {}; alone it would stay {:.2g} standard deviations "
                                "away, at {}.",
                                one.response, text(one.target), text(one.lowest), text(one.highest),
                                std::abs(one.residual_alone), wanted(page, one)));
    if (std::abs(one.residual) > far_off)
      all.push_back(fmt::format("At the calibrated factors {} is {}, {:.2g} standard deviations {} "
                                "its target; alone it wants {}.",
                                one.response, text(one.value), std::abs(one.residual),
                                one.residual < 0.0 ? "below" : "above", wanted(page, one)));
  }
}

void add_factors(std::vector<std::string>& all, StudyPage const& page) {
  for (std::size_t f = 0; f < page.table.study.factors.size(); ++f) {
    auto const& one = page.analysis->calibration->factors[f];
    auto const text = [&](double value) { return short_text(page.table.study.factors[f], value); };
    if (one.is_at_bound)
      all.push_back(fmt::format("{} = {} is a bound: the targets want to go further.", one.name,
                                text(one.value)));
    if (one.is_open_low && one.is_open_high)
      all.push_back(
          fmt::format("{} is not determined: its 95 % interval is the whole range.", one.name));
    else if (one.is_open_low || one.is_open_high)
      all.push_back(fmt::format("The {} end of the interval of {} is the bound {}, not the "
                                "targets'.",
                                one.is_open_low ? "lower" : "upper", one.name,
                                text(one.is_open_low ? one.lower : one.upper)));
  }
}

/// Where a single response is met exactly; of one target alone the calibration says it.
void add_roots(std::vector<std::string>& all, StudyPage const& page) {
  auto const& study = page.table.study;
  if (page.analysis->calibration->targets.size() < 2)
    return;
  for (ResponseRoots const& part : page.analysis->roots)
    for (TargetRoot const& root : part.roots)
      for (std::size_t f = 0; f < study.factors.size(); ++f)
        if (!page.analysis->calibration->factors[f].is_held)
          all.push_back(fmt::format(
              "{} alone is met at {} = {} (standard deviation {} {}).", part.response,
              study.factors[f].name, short_text(study.factors[f], root.value),
              short_number(study.factors[f].number(root.sd), 2), study.factors[f].unit));
}

} // namespace

std::string shown_text(StudyPage const& page, std::string const& response, double value) {
  auto const& all = page.table.study.responses;
  auto const unit = shown_unit(page.table, *std::ranges::find(all, response, &StudyResponse::name));
  return short_number(unit.factor * value) + (unit.text.empty() ? "" : " " + unit.text);
}

std::vector<std::string> calibration_answers(StudyPage const& page) {
  std::vector<std::string> all{calibrated(page), agreement(*page.analysis->calibration)};
  add_targets(all, page);
  add_factors(all, page);
  add_roots(all, page);
  return all;
}

} // namespace coupling::study
