#include "coupling/study/page_tables.hpp"

#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"
#include "coupling/study/page_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

/// A p-value: what is below a hundredth of a per cent need not be told apart.
Cell probability(double p) {
  if (!std::isfinite(p))
    return {"-", true};
  return {p < 1e-4 ? "< 0.0001" : fmt::format("{:.4f}", p), true};
}

/// As many decimals as the standard errors have meaning.
int decimals_of_errors(std::vector<Coefficient> const& coefficients, double unit) {
  std::vector<double> errors;
  errors.reserve(coefficients.size());
  for (Coefficient const& c : coefficients)
    errors.push_back(unit * c.standard_error);
  double const least = std::ranges::min(errors);
  if (least > 0.0)
    return std::clamp(2 - static_cast<int>(std::floor(std::log10(least))), 0, 9);
  for (std::size_t k = 0; k < errors.size(); ++k)
    errors[k] = unit * coefficients[k].value;
  return decimals_of(errors);
}

std::string coefficients_html(ResponseAnalysis const& part, ShownUnit const& unit) {
  auto const coefficients = part.surface.coefficients();
  int const decimals = decimals_of_errors(coefficients, unit.factor);
  auto const shown = [&](double value) {
    return Cell{fixed_number(unit.factor * value, decimals), true};
  };
  std::vector<TableRow> rows;
  rows.reserve(coefficients.size());
  for (Coefficient const& c : coefficients)
    rows.push_back({{{c.name},
                     shown(c.value),
                     shown(c.standard_error),
                     {fixed_number(c.t, 2), true},
                     probability(c.p),
                     shown(c.lower),
                     shown(c.upper)},
                    ""});
  std::vector<std::string> const header{"Coded term", "Coefficient", "Std. error", "t",
                                        "p",          "95 % from",   "to"};
  return table_html(header, rows);
}

TableRow anova_row(AnovaRow const& row, double unit_squared) {
  return {{{row.name},
           {fmt::format("{}", row.df), true},
           {std::isfinite(row.ss) ? fmt::format("{:.4g}", unit_squared * row.ss) : "-", true},
           {std::isfinite(row.mean_square) ? fmt::format("{:.4g}", unit_squared * row.mean_square)
                                           : "-",
            true},
           {std::isfinite(row.f) ? fmt::format("{:.4g}", row.f) : "-", true},
           probability(row.p)},
          ""};
}

std::string anova_html(Anova const& anova, ShownUnit const& unit) {
  double const squared = unit.factor * unit.factor;
  std::vector<TableRow> rows{anova_row(anova.model, squared)};
  for (auto const* part : {&anova.groups, &anova.terms})
    for (AnovaRow const& row : *part)
      rows.push_back(anova_row(row, squared));
  rows.push_back(anova_row(anova.residual, squared));
  if (anova.pure_error.df > 0) {
    rows.push_back(anova_row(anova.lack_of_fit, squared));
    rows.push_back(anova_row(anova.pure_error, squared));
  }
  rows.push_back(anova_row(anova.total, squared));
  std::vector<std::string> const header{"Source", "df", "Sum of squares", "Mean square", "F", "p"};
  return table_html(header, rows);
}

std::string fit_in_words(ResponseAnalysis const& part) {
  auto const& surface = part.surface;
  auto const& lack = part.anova.lack_of_fit;
  auto text =
      fmt::format("R\u00b2 {:.4f}, adjusted {:.4f}, predicted {:.4f} (each run foretold by "
                  "the others). ",
                  surface.r_squared(), surface.adjusted_r_squared(), surface.predicted_r_squared());
  if (part.anova.pure_error.df == 0)
    return text + "No point was run twice, so lack of fit cannot be told from scatter.";
  return text +
         fmt::format("Lack of fit: F = {:.3g}, p = {:.2g}, so the surface {} the runs within "
                     "the scatter of their packings.",
                     lack.f, lack.p, lack.p < 0.05 ? "does not hold" : "holds");
}

} // namespace

std::string surfaces_html(StudyPage const& page) {
  if (!page.analysis)
    return "";
  std::string out;
  int k = 0;
  for (ResponseAnalysis const& part : page.analysis->responses) {
    auto const unit = shown_unit(page.table, part.response);
    auto quantity = part.response.quantity;
    std::ranges::replace(quantity, '_', ' ');
    std::vector<std::string> words;
    words.reserve(part.influences.size());
    for (FactorInfluence const& influence : part.influences)
      words.push_back(influence.statement);
    out += fmt::format(
        "<section class=\"card response\"><h2>{} <small>{}{}</small></h2>\n<p "
        "class=\"quiet\">{}</p>\n"
        "<div class=\"charts\" id=\"surface-{}\"><div class=\"tables\"><h3>Coefficients</h3>"
        "<div class=\"scroll\">{}</div></div></div>\n"
        "<h3>Analysis of variance</h3><div class=\"scroll small\">{}</div>\n",
        escape_html(part.response.name), escape_html(quantity),
        unit.text.empty() ? "" : ", " + escape_html(unit.text), escape_html(fit_in_words(part)),
        k++, coefficients_html(part, unit), anova_html(part.anova, unit));
    for (auto const& word : words)
      out += "<p class=\"quiet\">" + escape_html(word) + ".</p>\n";
    out += "</section>\n";
  }
  return out;
}

} // namespace coupling::study
