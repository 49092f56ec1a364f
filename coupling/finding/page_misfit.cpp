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

constexpr double much = 8.0; ///< standard uncertainties from which a cell is coloured deeper

/// A p as people say it.
std::string chance(double p) {
  if (!std::isfinite(p))
    return "not known";
  return p < 1e-4 ? "p < 0.0001" : fmt::format("p = {:.2g}", p);
}

std::string cell_html(MisfitCell const& cell) {
  bool const is_marked = cell.p < marked_p;
  char const* colour = !is_marked                   ? ""
                       : std::abs(cell.size) < much ? " class=\"some\""
                                                    : " class=\"much\"";
  return fmt::format("<td{}><strong>{:+.1f}</strong>{}<br><small>{}, {}</small></td>", colour,
                     cell.size, is_marked ? escape_html(cell.shape) : "agrees",
                     escape_html(cell.test), chance(cell.p));
}

/// Rows are channels, columns are phases, both in the order in which they come.
std::string map_html(std::vector<MisfitCell> const& cells) {
  std::vector<std::string> channels, phases;
  auto const add = [](std::vector<std::string>& list, std::string const& name) {
    if (std::ranges::count(list, name) == 0)
      list.push_back(name);
  };
  for (auto const* phase : {"loading", "dwell", "unloading", "after"})
    if (std::ranges::count(cells, phase, &MisfitCell::phase) > 0)
      add(phases, phase);
  for (auto const& cell : cells) {
    add(channels, cell.channel);
    add(phases, cell.phase);
  }
  std::string html = "<div class=\"scroll\"><table class=\"map\"><thead><tr><th></th>";
  for (auto const& phase : phases)
    html += "<th scope=\"col\">" + escape_html(phase_in_words(phase)) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (auto const& channel : channels) {
    html += "<tr><th scope=\"row\">" + escape_html(channel_in_words(channel)) + "</th>";
    for (auto const& phase : phases) {
      auto const cell = std::ranges::find_if(cells, [&](MisfitCell const& one) {
        return one.channel == channel && one.phase == phase;
      });
      html += cell == cells.end() ? "<td class=\"nothing\"></td>" : cell_html(*cell);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string levels_html(std::vector<RunLevel> const& levels) {
  if (levels.empty())
    return "";
  std::vector<TableRow> rows;
  for (auto const& one : levels)
    rows.push_back({{{one.run},
                     {channel_in_words(one.channel)},
                     {fmt::format("{:+.1f}", one.size), true},
                     {chance(one.p), true},
                     {one.p < marked_p ? "departs" : "agrees"}},
                    one.p < marked_p ? "fail" : ""});
  std::array<std::string, 5> const header{"Run", "Channel", "Mean departure", "Chance", ""};
  return "<details><summary>Run by run</summary><div class=\"scroll\">" + table_html(header, rows) +
         "</div></details>\n";
}

} // namespace

std::string misfit_part(Finding const& finding) {
  if (finding.misfit.empty())
    return "";
  return card("misfit", "Where measurement and simulation differ",
              "the simulation with calibrated grains, before any cause",
              map_html(finding.misfit) +
                  quiet("Numbers: how far the measurement departs, in standard uncertainties; the "
                        "sign is that of measured less simulated. Coloured where chance would do "
                        "it less than once in a hundred maps (Holm).") +
                  levels_html(finding.levels));
}

std::string scalars_part(Finding const& finding) {
  std::vector<TableRow> rows;
  for (auto const& one : finding.curves) {
    if (one.measured.size() != 1)
      continue;
    auto const text = [&](std::vector<double> const& values) {
      return Cell{values.empty() ? "" : format_quantity(values.front(), one.unit), true};
    };
    rows.push_back({{{one.run},
                     {channel_in_words(one.channel)},
                     text(one.measured),
                     text(one.calibrated),
                     text(one.extended),
                     text(one.sd)},
                    ""});
  }
  if (rows.empty())
    return "";
  std::array<std::string, 6> const header{"Run",       "Read once",      "Measured",
                                          "Simulated", "With the cause", "Stated error"};
  return "<div class=\"scroll\">" + table_html(header, rows) + "</div>\n";
}

} // namespace coupling::finding
