#include "coupling/report/sections.hpp"

#include "coupling/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

Cell number(double value, std::string_view unit, int digits = 4) {
  return {format_quantity(value, unit, digits), true};
}

std::string percent(double fraction) {
  return std::isfinite(fraction) ? fmt::format("{:.2f} %", 100.0 * fraction) : "not reached";
}

/// 123456789 -> "123 456 789"
std::string grouped(std::uint64_t count) {
  auto text = std::to_string(count);
  for (auto at = static_cast<int>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), "\u202f");
  return text;
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 60.0)
    return format_quantity(seconds, "s", 3);
  auto const minutes = static_cast<long>(seconds / 60.0);
  if (minutes < 60)
    return fmt::format("{} min {:.0f} s", minutes, std::floor(seconds - 60.0 * minutes));
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string shape_in_words(Summary const& summary) {
  if (summary.shape_quality == 0)
    return "not reached";
  return fmt::format("{} of 5 (similarity {:.4f})", summary.shape_quality,
                     summary.shape_similarity);
}

/// "energy_ledger" -> "energy ledger"
std::string words(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

} // namespace

std::string table_html(std::span<std::string const> header, std::span<TableRow const> rows) {
  std::string out = "<table>";
  if (!header.empty()) {
    out += "<thead><tr>";
    for (std::size_t k = 0; k < header.size(); ++k) {
      bool const is_number =
          !rows.empty() && k < rows[0].cells.size() && rows[0].cells[k].is_number;
      out += fmt::format("<th scope=\"col\"{}>{}</th>", is_number ? " class=\"number\"" : "",
                         escape_html(header[k]));
    }
    out += "</tr></thead>";
  }
  out += "<tbody>\n";
  for (auto const& row : rows) {
    out +=
        row.verdict.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", escape_html(row.verdict));
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      auto const text = escape_html(row.cells[k].text);
      if (k == 0)
        out += fmt::format("<th scope=\"row\">{}</th>", text);
      else
        out +=
            fmt::format("<td{}>{}</td>", row.cells[k].is_number ? " class=\"number\"" : "", text);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table>";
}

std::string verdict_html(std::span<Check const> checks) {
  auto const n_failed = std::ranges::count_if(checks, [](Check const& c) { return !c.ok; });
  if (checks.empty())
    return "<p class=\"verdict none\" role=\"status\"><strong>Nothing was checked.</strong> The "
           "numbers below have no verdict.</p>";
  if (n_failed == 0) {
    auto const all = checks.size() == 1 ? std::string("The one check")
                                        : fmt::format("All {} checks", checks.size());
    return fmt::format("<p class=\"verdict pass\" role=\"status\"><strong>{} passed.</strong> The "
                       "calculation kept its own "
                       "books within the tolerances below.</p>",
                       all);
  }
  std::string names;
  for (auto const& check : checks) {
    if (check.ok)
      continue;
    if (!names.empty())
      names += "; ";
    names += fmt::format("{} is {:.3g}, allowed {:.3g}", words(check.name), check.value,
                         check.tolerance);
  }
  return fmt::format("<p class=\"verdict fail\" role=\"status\"><strong>{} of {} checks "
                     "failed.</strong> Do not rely on "
                     "this run: {}.</p>",
                     n_failed, checks.size(), escape_html(names));
}

std::string run_in_words(ReportData const& data) {
  auto const& s = data.summary;
  auto text = fmt::format("{} grains were pressed with up to {}", grouped(s.grains),
                          format_quantity(s.max_force, "N"));
  if (data.record.has("punch_gap") && data.record.size() > 0) {
    double smallest = std::numeric_limits<double>::infinity();
    for (double const gap : data.record.column("punch_gap"))
      if (gap < smallest)
        smallest = gap;
    if (std::isfinite(smallest))
      text += fmt::format(" at a gap down to {}", format_quantity(smallest, "m"));
  }
  if (std::isfinite(s.compact_height) && std::isfinite(s.porosity))
    text += fmt::format("; the compact is {} high with {} porosity",
                        format_quantity(s.compact_height, "m"), percent(s.porosity));
  return "<p class=\"lead\">" + escape_html(text) + ".</p>";
}

std::string summary_html(Summary const& s) {
  std::vector<TableRow> rows = {
      {{{"Largest punch force"}, number(s.max_force, "N")}, ""},
      {{{"Compact height"}, number(s.compact_height, "m")}, ""},
      {{{"Springback"}, {percent(s.springback), true}}, ""},
      {{{"Porosity"}, {percent(s.porosity), true}}, ""},
      {{{"Porosity of the core"}, {percent(s.porosity_core), true}}, ""},
      {{{"Shape quality"}, {shape_in_words(s), true}}, ""},
      {{{"Grains"}, {grouped(s.grains), true}}, ""},
      {{{"Steps"}, {grouped(s.steps), true}}, ""},
      {{{"Smallest time step"}, number(s.time_step, "s")}, ""},
      {{{"Time taken"}, {duration(s.wall_seconds), true}}, ""},
      {{{"Speed"},
        {fmt::format("{:.3g} million particle steps/s", s.particle_steps_per_second / 1e6), true}},
       ""},
      {{{"Mode"}, {s.mode, true}}, ""},
  };
  if (std::isfinite(s.ejection_force)) // most cycles end with the die's release instead
    rows.insert(rows.begin() + 1, {{{"Ejection force"}, number(s.ejection_force, "N")}, ""});
  return table_html({}, rows);
}

std::string checks_html(std::span<Check const> checks) {
  if (checks.empty())
    return "<p class=\"quiet\">None.</p>";
  std::vector<TableRow> rows;
  for (auto const& c : checks)
    rows.push_back({{{words(c.name)},
                     {fmt::format("{:.4g}", c.value), true},
                     {fmt::format("{:.4g}", c.tolerance), true},
                     {c.ok ? "passed" : "FAILED"}},
                    c.ok ? "pass" : "fail"});
  std::vector<std::string> const header = {"Check", "Value", "Tolerance", "Verdict"};
  return table_html(header, rows);
}

namespace {

/// Where report.js draws the tools.
std::string stressed_html(StressPicture const& picture) {
  if (picture.tools.empty())
    return "";
  return fmt::format(
      "<h3>At the largest force <small>t = {}, cut open, grains as they stood</small></h3>"
      "<div class=\"stage\"><canvas id=\"tools-canvas\" tabindex=\"0\" role=\"img\" "
      "aria-label=\"The stressed tools in three dimensions. Arrow keys turn them, plus "
      "and minus zoom.\"></canvas><div id=\"tools-bar\" class=\"bar\"></div>"
      "<p id=\"tools-note\" class=\"note\" role=\"status\"></p></div>",
      format_quantity(picture.time, "s"));
}

} // namespace

std::string tools_html(std::span<ToolSummary const> tools, StressPicture const& picture) {
  std::vector<TableRow> rows;
  for (auto const& t : tools) {
    if (!std::isfinite(t.max_von_mises))
      continue;
    auto const place = fmt::format("({:.2f}, {:.2f}, {:.2f}) mm", 1e3 * t.where.x(),
                                   1e3 * t.where.y(), 1e3 * t.where.z());
    rows.push_back(
        {{{words(t.name)},
          number(t.max_von_mises, "Pa"),
          {place, true},
          number(t.valid_below_depth, "m", 3),
          {std::isfinite(t.yield_utilisation) ? percent(t.yield_utilisation) : "no strength given",
           true},
          {percent(t.contact_share), true}},
         ""});
  }
  if (rows.empty())
    return "";
  std::vector<std::string> const header = {"Tool at the peak",
                                           "Largest von Mises stress",
                                           "Where",
                                           "Independent of single contacts below",
                                           "Of yield",
                                           "Of a contact's give, twice"};
  return "<section class=\"card\" id=\"tools\"><h2>Stress of the tools</h2>" +
         table_html(header, rows) +
         "<p class=\"quiet\">The last column is the share of a wall contact's compliance that the "
         "contact law already gives to the tool (Tooling/Young's modulus); where grains dent the "
         "elastic body as well, it counts twice.</p>" +
         stressed_html(picture) + "</section>";
}

std::string comparison_html(std::span<ComparedValue const> compared) {
  if (compared.empty())
    return "";
  std::vector<TableRow> rows;
  for (auto const& c : compared) {
    auto const relative = (c.ours - c.theirs) / std::abs(c.theirs);
    auto const difference =
        std::isfinite(relative) ? fmt::format("{:+.2f} %", 100.0 * relative) : "not known";
    rows.push_back({{{words(c.quantity)},
                     number(c.ours, c.unit),
                     number(c.theirs, c.unit),
                     {difference, true},
                     {c.source}},
                    ""});
  }
  std::vector<std::string> const header = {"Quantity", "Here", "Published", "Difference", "Source"};
  return "<section class=\"card\" id=\"comparison\"><h2>Against published values</h2>" +
         table_html(header, rows) + "</section>";
}

std::string observed_html(std::span<ObservedValue const> observed) {
  if (observed.empty())
    return "";
  std::vector<TableRow> rows;
  for (auto const& o : observed)
    rows.push_back({{{words(o.name)},
                     number(o.value, o.unit),
                     {std::isfinite(o.sd) ? format_quantity(o.sd, o.unit, 2) : "not stated", true},
                     {o.source}},
                    ""});
  std::vector<std::string> const header = {"Quantity", "Value", "Standard uncertainty", "Source"};
  return "<section class=\"card\" id=\"observed\"><h2>Observed values</h2>" +
         table_html(header, rows) + "</section>";
}

std::string provenance_html(std::span<ProvenanceEntry const> entries) {
  std::string out = "<dl class=\"provenance\">";
  for (auto const& e : entries)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape_html(e.key),
                       escape_html(e.value));
  return out + "</dl>";
}

} // namespace coupling
