#include "coupling/finding/cause_words.hpp"
#include "coupling/finding/page_parts.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace coupling::finding {
namespace {

using Json = nlohmann::ordered_json;

std::string class_of(Finding const& finding) {
  if (finding.verdict == "consistent")
    return "pass";
  return finding.verdict == "unknown" ? "fail" : "found";
}

std::string item(std::string_view strong, std::string_view text) {
  if (text.empty())
    return "";
  return strong.empty() ? fmt::format("<li>{}</li>\n", escape_html(text))
                        : fmt::format("<li><strong>{}</strong> {}</li>\n", escape_html(strong),
                                      escape_html(text));
}

std::string gain_in_words(Finding const& finding) {
  if (!finding.gain || finding.gain->channels.empty())
    return "";
  auto const& all = finding.gain->channels.back();
  auto text =
      fmt::format("On {} run{} that nothing was fitted to, the error falls to {:.0f} % of "
                  "what it was",
                  finding.gain->n_runs, finding.gain->n_runs == 1 ? "" : "s", 100.0 * all.ratio);
  if (finding.placebo && !finding.placebo->channels.empty())
    text += fmt::format("; with the best wrong cause, to {:.0f} %",
                        100.0 * finding.placebo->channels.back().ratio);
  return text + ".";
}

std::string alarm_in_words(Alarm const& alarm) {
  if (!std::isfinite(alarm.level))
    return "";
  // The references are draws, so a p is never smaller than one over their number.
  return fmt::format(
      "So large a departure arises by chance with a probability of at most {:.2g}, one that looks "
      "like a known cause of at most {:.2g}; an alarm is raised {:.2g} % of the time when nothing "
      "is "
      "wrong.",
      alarm.p_omnibus, alarm.p_targeted, 100.0 * alarm.level);
}

/// What to do next, for a verdict that names nothing to be checked.
std::string next_step(Finding const& finding) {
  if (finding.verdict == "consistent")
    return "Nothing needs to be changed. What these data could not have shown is listed below.";
  if (finding.verdict == "unknown")
    return "Look at the runs at the place that is described below; a cause that is not in the list "
           "may be at work.";
  if (finding.verdict != "undecided")
    return "";
  if (finding.measurements.empty())
    return "No measurement of the catalogue was tried.";
  return finding.measurements.front().is_enough
             ? fmt::format("Measure next: {}.", finding.measurements.front().name)
             : "No single measurement of the list tells all of them apart; the first comes "
               "nearest.";
}

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

Json rounded(std::vector<double> const& values) {
  Json list = Json::array();
  for (double const value : values)
    list.push_back(rounded(value));
  return list;
}

} // namespace

std::string card(std::string_view id, std::string_view title, std::string_view note,
                 std::string_view body) {
  if (body.empty())
    return "";
  return fmt::format(
      "<section class=\"card\" id=\"{}\"><h2>{}{}</h2>\n{}</section>\n", id, escape_html(title),
      note.empty() ? "" : fmt::format(" <small>{}</small>", escape_html(note)), body);
}

std::string quiet(std::string_view text) {
  return "<p class=\"quiet\">" + escape_html(text) + "</p>\n";
}

std::string verdict_part(Finding const& finding) {
  return fmt::format("<p class=\"verdict {}\" role=\"status\"><strong>{}</strong></p>",
                     class_of(finding), escape_html(verdict_in_words(finding)));
}

std::string answer_part(Finding const& finding) {
  std::string items;
  auto const named = named_causes(finding);
  for (auto const& cause : named)
    items += item("What it means:", meaning_of(cause.name));
  for (auto const& cause : named)
    items += item("How to check it:", check_of(cause.name));
  items += item("What to do:", next_step(finding));
  items += item("What it is worth:", gain_in_words(finding));
  for (auto const& sentence : finding.sentences)
    items += item("", capitalised(with_words(sentence)) + ".");
  for (auto const& name : finding.not_claimed)
    items +=
        item("", fmt::format("Not claimed: that {}. Data without any fault show as much of it.",
                             words_of(name)));
  items += item("How sure an alarm is:", alarm_in_words(finding.alarm));
  return card("answer", "In short", "", "<ul class=\"answers\">\n" + items + "</ul>\n");
}

std::string reading_part(Finding const& finding) {
  std::string items;
  for (auto const& decision : finding.decisions)
    items += item("", decision);
  return card("reading", "What was decided while reading the measured data", "",
              items.empty() ? quiet("Every row was read as it stands.")
                            : "<ul class=\"answers\">\n" + items + "</ul>\n");
}

std::string origin_part(Finding const& finding) {
  auto const& from = finding.provenance;
  std::vector<ProvenanceEntry> entries{{"Case", from.case_file},
                                       {"Measured data", from.data_folder},
                                       {"Simulation", from.simulation},
                                       {"Version", from.version}};
  if (!from.made.empty())
    entries.push_back({"Made", from.made});
  for (auto const& seed : finding.seeds)
    entries.push_back({"Seed, " + seed.purpose, seed.value});
  return card("provenance", "Provenance", "", provenance_html(entries));
}

std::string curves_json(Finding const& finding) {
  Json curves = Json::array();
  for (auto const& one : finding.curves)
    curves.push_back({{"run", one.run},
                      {"words", channel_in_words(one.channel)},
                      {"unit", one.unit},
                      {"held_out", one.is_held_out},
                      {"time", rounded(one.time)},
                      {"gap", rounded(one.gap)},
                      {"measured", rounded(one.measured)},
                      {"calibrated", rounded(one.calibrated)},
                      {"extended", rounded(one.extended)},
                      {"sd", rounded(one.sd)}});
  auto const extended =
      finding.verdict == "named" ? "simulated with the cause" : "with the most probable cause";
  return Json{{"extended", extended}, {"curves", curves}}.dump(-1, ' ', false,
                                                               Json::error_handler_t::replace);
}

} // namespace coupling::finding
