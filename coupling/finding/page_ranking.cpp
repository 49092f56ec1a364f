#include "coupling/finding/cause_words.hpp"
#include "coupling/finding/page_parts.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

namespace coupling::finding {
namespace {

/// `18 µm/kN (17.1 µm/kN to 19.2 µm/kN)`; two tables' cells of the same.
std::string ends_in_words(FoundCause const& cause) {
  auto const& size = cause.parameters.front();
  auto const text = [&](double value) { return size_in_words(cause.name, value, size.unit); };
  return fmt::format("{} to {}", size.is_open_low ? "no lower limit" : text(size.low),
                     size.is_open_high ? "no upper limit" : text(size.high));
}

std::string cause_row(FoundCause const& cause) {
  bool const has_size = !cause.parameters.empty();
  std::string const row = cause.is_named ? "<tr class=\"found\">" : "<tr>";
  std::string further;
  for (std::size_t k = 1; k < cause.parameters.size(); ++k)
    further += fmt::format("; {} = {}", cause.parameters[k].name,
                           format_quantity(cause.parameters[k].value, cause.parameters[k].unit, 4));
  auto const number = [](std::string const& text) {
    return "<td class=\"number\">" + escape_html(text) + "</td>";
  };
  return row +
         fmt::format("<th scope=\"row\">{}<br><code>{}</code></th>",
                     escape_html(words_of(cause.name)), escape_html(cause.name)) +
         number(fmt::format("{:.1f} %", 100.0 * cause.probability)) +
         number(has_size ? size_in_words(cause.name, cause.size(), cause.parameters[0].unit)
                         : "not fitted") +
         number(has_size ? ends_in_words(cause) : "") +
         number(std::isfinite(cause.log_evidence) ? fmt::format("{:+.1f}", cause.log_evidence)
                                                  : "") +
         "<td>" + escape_html(cause.plausibility + further) + "</td></tr>\n";
}

/// `force on the lower punch while opening, at a gap of 8.200 mm`
std::string reading_in_words(Reading const& one) {
  auto const channel = channel_in_words(one.channel);
  return one.phase == "after"
             ? channel
             : fmt::format("{} while {}, at a gap of {}", channel, phase_in_words(one.phase),
                           format_quantity(one.gap, "m", 4));
}

/// `12 ± 9 N`
std::string foretold_in_words(Foretold const& one, std::size_t k, std::string const& unit) {
  if (k >= one.value.size() || k >= one.sd.size())
    return "";
  return fmt::format("{} ± {}", format_quantity(one.value[k], unit, 4),
                     format_quantity(one.sd[k], unit, 2));
}

std::string measurement_html(Measurement const& one, std::size_t rank) {
  std::vector<std::string> header{"It will read"};
  for (auto const& outcome : one.outcomes)
    header.push_back("if " + words_of(outcome.cause));
  std::vector<TableRow> rows;
  for (std::size_t k = 0; k < one.readings.size(); ++k) {
    rows.push_back({{{reading_in_words(one.readings[k])}}, ""});
    for (auto const& outcome : one.outcomes)
      rows.back().cells.push_back({foretold_in_words(outcome, k, one.readings[k].unit), true});
  }
  return fmt::format("<h3>{}. {}<small>{}; now {:.1f} standard uncertainties apart, then {:.1f}; "
                     "cost {:g}</small></h3>\n<div class=\"scroll\">{}</div>\n",
                     rank, escape_html(one.name),
                     one.is_enough ? "tells them apart" : "does not tell all of them apart",
                     one.before, one.after, one.cost, table_html(header, rows));
}

} // namespace

std::string causes_part(Finding const& finding) {
  if (finding.causes.empty())
    return "";
  std::string html = "<div class=\"scroll\"><table><thead><tr><th scope=\"col\">Cause</th>";
  for (auto const* name : {"Probability", "Size", "95 % of it", "ln evidence"})
    html += fmt::format("<th scope=\"col\" class=\"number\">{}</th>", name);
  html += "<th scope=\"col\">Is such a size likely?</th></tr></thead><tbody>\n";
  for (auto const& cause : finding.causes)
    html += cause_row(cause);
  return card("causes", "Causes, the most probable first", "",
              html + "</tbody></table></div>\n" +
                  quiet("Marked: named. ln evidence: against a simulation without any cause; the "
                        "higher, the better."));
}

std::string next_part(Finding const& finding) {
  if (finding.group.empty() && finding.measurements.empty())
    return "";
  std::string html;
  if (!finding.group.empty()) {
    html += "<p>These data look the same whether</p>\n<ul class=\"answers\">\n";
    for (auto const& name : finding.group)
      html +=
          fmt::format("<li><strong>{}</strong>. {} <em>{}</em></li>\n", escape_html(words_of(name)),
                      escape_html(meaning_of(name)), escape_html(check_of(name)));
    html += "</ul>\n";
  }
  std::size_t rank = 0;
  for (auto const& one : finding.measurements)
    html += measurement_html(one, ++rank);
  if (finding.measurements.empty())
    html += quiet("No measurement was looked for that would tell them apart.");
  return card("next", "What to measure next", "", html);
}

std::string unknown_part(Finding const& finding) {
  if (!finding.unknown)
    return "";
  auto const& u = *finding.unknown;
  auto const value = [&](double number) { return format_quantity(number, u.unit, 4); };
  std::string html = fmt::format(
      "<p>It shows in the <strong>{}</strong> while <strong>{}</strong>, most ({:.0f} %) in {}, "
      "between {} and {}; it comes to {}.</p>\n",
      escape_html(channel_in_words(u.channel)), escape_html(phase_in_words(u.phase)),
      100.0 * u.run_share, escape_html(u.run), escape_html(value(u.value_low)),
      escape_html(value(u.value_high)), escape_html(value(u.size)));
  std::vector<TableRow> inputs, forms;
  for (auto const& one : u.inputs)
    inputs.push_back({{{one.input},
                       {fmt::format("{:.0f} %", 100.0 * one.share), true},
                       {fmt::format("{:.2g}", one.p), true}},
                      ""});
  for (auto const& one : u.forms) {
    auto const number = [](double v) {
      return Cell{std::isfinite(v) ? fmt::format("{:.3g}", v) : "", true};
    };
    forms.push_back({{{one.form + " in " + one.input},
                      number(one.place),
                      number(one.width),
                      number(one.amplitude),
                      {fmt::format("{:.0f} %", 100.0 * one.share), true}},
                     ""});
  }
  std::array<std::string, 3> const inputs_head{"It goes with", "Share of the misfit", "Chance"};
  std::array<std::string, 5> const forms_head{"It looks like", "Place", "Width or period", "Height",
                                              "Share of the misfit"};
  html += "<div class=\"scroll\">" + table_html(inputs_head, inputs) + "</div>\n";
  html += "<div class=\"scroll\">" + table_html(forms_head, forms) + "</div>\n";
  if (!u.nearest.empty())
    html += quiet(fmt::format("The known cause that looks most alike: {} (cosine {:+.2f}; 1 would "
                              "be the same). A form is no cause: do not use it outside these data.",
                              words_of(u.nearest), u.nearest_cosine));
  return card("unknown", "What is known of the unexplained part", "SI units", html);
}

std::string detectable_part(Finding const& finding) {
  if (finding.detectable.empty())
    return "";
  std::vector<TableRow> rows;
  for (auto const& one : finding.detectable)
    rows.push_back({{{words_of(one.cause)},
                     {std::isfinite(one.size) ? size_in_words(one.cause, one.size, one.unit)
                                              : "cannot be seen in these data",
                      true}},
                    ""});
  std::array<std::string, 2> const header{"Cause", "Smallest size that would have shown"};
  return card("detectable", "What could not have been seen",
              "smaller than this, a fault would have stayed hidden",
              "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n");
}

} // namespace coupling::finding
