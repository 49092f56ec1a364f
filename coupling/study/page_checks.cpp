#include "coupling/study/page_tables.hpp"

#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"
#include "coupling/study/page_units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::study {
namespace {

/// A response by its name, with the unit in which it is shown.
struct ShownResponse {
  ShownUnit unit;

  ShownResponse(StudyPage const& page, std::string const& name)
      : unit(shown_unit(page.table, *std::ranges::find(page.table.study.responses, name,
                                                       &StudyResponse::name))) {}
  Cell operator()(double value) const { return {short_number(unit.factor * value), true}; }
};

std::string factors_html(StudyPage const& page) {
  auto const& found = page.analysis->calibration->factors;
  std::vector<TableRow> rows;
  for (std::size_t f = 0; f < found.size(); ++f) {
    auto const& one = found[f];
    auto const text = [&](double value) {
      return Cell{one.is_held ? "held" : short_text(page.table.study.factors[f], value), true};
    };
    rows.push_back({{{one.name},
                     {short_text(page.table.study.factors[f], one.value), true},
                     text(one.lower),
                     text(one.upper),
                     text(one.region_lower),
                     text(one.region_upper)},
                    ""});
  }
  std::vector<std::string> const header{"Factor", "Calibrated",        "95 % from",
                                        "to",     "Joint region from", "to"};
  return table_html(header, rows);
}

std::string targets_html(StudyPage const& page) {
  std::vector<TableRow> rows;
  for (auto const& one : page.analysis->calibration->targets) {
    ShownResponse const shown(page, one.response);
    rows.push_back({{{shown.unit.head(one.response)},
                     shown(one.target),
                     shown(one.target_sd),
                     shown(one.value),
                     shown(one.combined_sd),
                     {fmt::format("{:+.2f}", one.residual), true},
                     shown(one.lowest),
                     shown(one.highest),
                     {one.is_reachable ? "within reach" : "OUT OF REACH"}},
                    one.is_reachable ? "pass" : "fail"});
  }
  std::vector<std::string> const header{"Target",  "Value",   "Its sd",
                                        "Surface", "Both sd", "Off by [sd]",
                                        "Least",   "Largest", "Within the bounds"};
  return table_html(header, rows);
}

} // namespace

std::string calibration_html(StudyPage const& page) {
  if (!page.analysis || !page.analysis->calibration)
    return "";
  Calibration const& found = *page.analysis->calibration;
  auto const quality =
      found.df > 0 ? fmt::format("\u03c7\u00b2 = {:.4g} with {} degree{} of freedom, p = {:.2g}.",
                                 found.chi_squared, found.df, found.df == 1 ? "" : "s", found.p)
                   : std::string("As many free factors as targets: nothing is left to "
                                 "judge the agreement by.");
  return "<section class=\"card\" id=\"calibration\"><h2>Calibration</h2>\n<div class=\"scroll\">" +
         factors_html(page) + "</div>\n<div class=\"scroll\">" + targets_html(page) +
         "</div>\n<p class=\"quiet\">" + escape_html(quality) +
         "</p>\n<div class=\"charts\" id=\"calibration-plots\"></div></section>\n";
}

std::string validation_html(StudyPage const& page) {
  if (!page.analysis || page.analysis->validation.empty())
    return "";
  std::vector<TableRow> rows;
  for (auto const& check : page.analysis->validation) {
    ShownResponse const shown(page, check.response);
    rows.push_back({{{check.run},
                     {shown.unit.head(check.response)},
                     shown(check.value),
                     shown(check.foretold.value),
                     shown(check.foretold.run_lower),
                     shown(check.foretold.run_upper),
                     {check.is_inside ? "inside" : "OUTSIDE"}},
                    check.is_inside ? "pass" : "fail"});
  }
  std::vector<std::string> const header{"Run",       "Response", "Value",   "Foretold",
                                        "95 % from", "to",       "Interval"};
  return "<section class=\"card\" id=\"validation\"><h2>Validation runs against their prediction "
         "intervals</h2>\n<div class=\"scroll\">" +
         table_html(header, rows) + "</div></section>\n";
}

} // namespace coupling::study
