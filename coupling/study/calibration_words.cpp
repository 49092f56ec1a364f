#include "coupling/study/calibration_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::Index;

/// "E = 2250, CED = 7" of the factors that are not held.
std::string place(Calibration const& found, std::vector<double> const& natural) {
  std::string text;
  for (std::size_t f = 0; f < natural.size(); ++f)
    if (!found.factors[f].is_held)
      text +=
          fmt::format("{}{} = {:.6g}", text.empty() ? "" : ", ", found.factors[f].name, natural[f]);
  return text;
}

std::string agreement(Calibration const& found) {
  if (found.df <= 0)
    return fmt::format("As many free factors as targets or more: chi^2 = {:.3g} says nothing about "
                       "whether the targets agree.",
                       found.chi_squared);
  bool const agree = found.p >= 0.05;
  return fmt::format("The targets {} each other: chi^2 = {:.3g} with {} degree{} of freedom, p = "
                     "{:.2g}.",
                     agree ? "agree with" : "contradict", found.chi_squared, found.df,
                     found.df == 1 ? "" : "s", found.p);
}

std::string reach(Calibration const& found, CalibratedTarget const& one) {
  return fmt::format(
      "{} = {:.6g} is out of reach: inside the bounds the surface lies between {:.6g} "
      "and {:.6g}; alone it would stay {:.3g} sd away, at {}.",
      one.response, one.target, one.lowest, one.highest, std::abs(one.residual_alone),
      place(found, one.wanted));
}

std::string pull(Calibration const& found, CalibratedTarget const& one) {
  return fmt::format("{} is {:.6g}, {:.3g} sd {} its target {:.6g}; alone it wants {}.",
                     one.response, one.value, std::abs(one.residual),
                     one.residual < 0.0 ? "below" : "above", one.target, place(found, one.wanted));
}

void add_factors(std::vector<std::string>& all, Calibration const& found) {
  for (auto const& one : found.factors) {
    if (one.is_at_bound)
      all.push_back(fmt::format("{} = {:.6g} is a bound: the targets want to go further.", one.name,
                                one.value));
    if (one.is_open_low && one.is_open_high)
      all.push_back(fmt::format("{} is not determined: its 95 % interval is the whole range {:.6g} "
                                "to {:.6g}.",
                                one.name, one.lower, one.upper));
    else if (one.is_open_low || one.is_open_high)
      all.push_back(fmt::format("{}: the {} end of its 95 % interval is the bound {:.6g}, not the "
                                "targets'.",
                                one.name, one.is_open_low ? "lower" : "upper",
                                one.is_open_low ? one.lower : one.upper));
  }
}

void add_limits_of_surfaces(std::vector<std::string>& all, CalibrationProblem const& problem) {
  for (auto const& [surface, value, sd] : problem.targets)
    if (surface.fit.residual_df == 0)
      all.push_back(fmt::format("The surface of {} has no degree of freedom to see its error: only "
                                "the target's own uncertainty counts.",
                                surface.data.response_name));
  auto const& coded = problem.targets.front().surface.data.coded;
  for (std::size_t f = 0; f < problem.factors.size(); ++f) {
    auto const& [range, lowest, highest, held] = problem.factors[f];
    auto const column = coded.col(static_cast<Index>(f));
    double const low = range.to_natural(column.minCoeff()),
                 high = range.to_natural(column.maxCoeff());
    double const margin = 1e-9 * (high - low);
    if (held.value_or(lowest) < low - margin || held.value_or(highest) > high + margin)
      all.push_back(fmt::format("{} may go from {:.6g} to {:.6g}, beyond the runs of the design "
                                "({:.6g} to {:.6g}): the surfaces are extrapolated there.",
                                range.name, held.value_or(lowest), held.value_or(highest), low,
                                high));
  }
}

} // namespace

std::vector<std::string> statements_on(CalibrationProblem const& problem,
                                       Calibration const& found) {
  std::vector<std::string> all{agreement(found)};
  for (auto const& one : found.targets)
    if (!one.is_reachable)
      all.push_back(reach(found, one));
  if (found.contradicts)
    for (auto const& one : found.targets)
      all.push_back(pull(found, one));
  if (found.contradicts)
    all.push_back(
        "The intervals suppose that the targets agree; as they do not, they say how sharply "
        "the compromise is defined, not where the truth is.");
  add_factors(all, found);
  add_limits_of_surfaces(all, problem);
  return all;
}

} // namespace coupling::study
