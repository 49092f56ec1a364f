#include "coupling/finding/cause_words.hpp"
#include "coupling/finding/page_parts.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coupling::finding {
namespace {

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.0f} %", 100.0 * share) : "";
}

/// The channel of the placebo, or nullptr.
ChannelGained const* placebo_of(Finding const& finding, std::string const& channel) {
  if (!finding.placebo)
    return nullptr;
  auto const& all = finding.placebo->channels;
  auto const at = std::ranges::find(all, channel, &ChannelGained::channel);
  return at == all.end() ? nullptr : &*at;
}

TableRow gain_row(Finding const& finding, ChannelGained const& one) {
  auto const error = [&](double value) {
    return Cell{one.channel == "all" ? fmt::format("{:.2f} sd", value)
                                     : format_quantity(value, one.unit, 4),
                true};
  };
  auto const* wrong = placebo_of(finding, one.channel);
  std::string const range =
      std::isfinite(one.low) ? percent(one.low) + " to " + percent(one.high) : "fewer than 3 runs";
  return {{{channel_in_words(one.channel)},
           error(one.before),
           error(one.after),
           {percent(one.ratio), true},
           {range, true},
           {percent(one.coverage), true},
           {wrong ? percent(wrong->ratio) : "", true}},
          ""};
}

std::string score_in_words(std::string_view who, MeasuredGain const& gain) {
  if (!std::isfinite(gain.elpd_difference))
    return "";
  return fmt::format(
      "{}: ln of the held-out density rises by {:.4g} (by chance it would scatter by "
      "{:.3g}). ",
      who, gain.elpd_difference, gain.elpd_error);
}

std::string causes_in_words(MeasuredGain const& gain) {
  std::string text;
  for (auto const& name : gain.causes)
    text += (text.empty() ? "" : ", ") + words_of(name);
  return text;
}

std::string calibrated_html(Finding const& finding) {
  std::vector<TableRow> rows;
  for (auto const& one : finding.calibrated) {
    auto const text = [&](double value) { return Cell{format_quantity(value, one.unit, 4), true}; };
    rows.push_back(
        {{{one.name},
          text(one.value),
          text(one.sd),
          text(one.sheet),
          one.is_logarithmic ? Cell{fmt::format("factor {:.2f}", std::exp(one.sheet_sd)), true}
                             : text(one.sheet_sd)},
         ""});
  }
  std::array<std::string, 5> const header{"Calibrated", "Value", "sd", "Sheet", "sd of the sheet"};
  return rows.empty() ? "" : "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n";
}

} // namespace

std::string gain_part(Finding const& finding) {
  if (!finding.gain) {
    return finding.verdict != "named"
               ? ""
               : card("gain", "What the extended simulation is worth", "",
                      quiet("Not measured: no run was held out (\"role\": \"held-out\" in "
                            "measured.json)."));
  }
  std::vector<TableRow> rows;
  for (auto const& one : finding.gain->channels)
    rows.push_back(gain_row(finding, one));
  std::array<std::string, 7> const header{"Channel",         "Error before", "Error after",
                                          "After / before",  "95 %",         "Inside the 95 % band",
                                          "Best wrong cause"};
  auto words = "With: " + causes_in_words(*finding.gain) + ". " +
               score_in_words("This cause", *finding.gain);
  if (finding.placebo)
    words += "Best wrong cause: " + causes_in_words(*finding.placebo) + ". " +
             score_in_words("It", *finding.placebo);
  words += "Errors are root mean squares; the best wrong cause shows what a mere further number "
           "would bring.";
  return card("gain", "What the extended simulation is worth",
              fmt::format("on {} run{} that nothing was fitted to", finding.gain->n_runs,
                          finding.gain->n_runs == 1 ? "" : "s"),
              "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n" + quiet(words));
}

std::string extension_part(Finding const& finding) {
  std::vector<TableRow> rows;
  for (auto const& one : finding.extension)
    rows.push_back({{{one.path}, {one.before, true}, {one.after, true}, {one.because}}, ""});
  std::array<std::string, 4> const header{"Entry", "In the case", "In extended.prm", "Because"};
  std::string html;
  if (!rows.empty())
    html += "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n" +
            quiet("Run it with: presscheck run extended.prm");
  for (auto const& sentence : finding.not_modelled)
    html += quiet(sentence);
  return card("extension", "The extended case", "extended.prm beside this page", html);
}

std::string assumed_part(Finding const& finding) {
  std::vector<TableRow> rows;
  for (auto const& one : finding.tolerances)
    rows.push_back({{{one.name},
                     {one.unit == "1" ? fmt::format("{:.4g}", one.value)
                                      : format_quantity(one.value, one.unit, 4),
                      true},
                     {one.meaning},
                     {one.source}},
                    ""});
  std::array<std::string, 4> const header{"Assumed", "Value", "What it is", "Source"};
  std::string html = calibrated_html(finding);
  if (!rows.empty())
    html += "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n";
  return card("assumed", "What was calibrated, and what was assumed of errors", "", html);
}

} // namespace coupling::finding
