#include "coupling/compare/compare.hpp"

#include "coupling/record/atomic_file.hpp"
#include "coupling/report/assets.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/page_data.hpp"
#include "coupling/report/sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace coupling {
namespace {

using Json = nlohmann::ordered_json;

char const* word(Agreement agreement) {
  switch (agreement) {
  case Agreement::within:
    return "within";
  case Agreement::beyond:
    return "beyond";
  case Agreement::unknown:
    break;
  }
  return "not known";
}

char const* row_class(Agreement agreement) {
  return agreement == Agreement::within ? "pass" : agreement == Agreement::beyond ? "fail" : "";
}

std::string difference_text(QuantityRow const& row, double difference) {
  if (!std::isfinite(difference))
    return "not known";
  return row.is_relative ? fmt::format("{:+.2f} %", 100.0 * difference)
                         : fmt::format("{:+.4f}", difference);
}

std::string tolerance_text(QuantityRow const& row, double allowed) {
  return row.is_relative ? fmt::format("{:.3g} %", 100.0 * allowed)
                         : fmt::format("{:.3g}", allowed);
}

/// A line for each source and quantity, so that any number of sources fits a page.
std::string quantities_html(Comparison const& c) {
  std::vector<std::string> const header = {"Quantity",   "Source",    "Value",
                                           "Difference", "Tolerance", "Verdict"};
  std::vector<TableRow> rows;
  for (auto const& row : c.quantities) {
    auto words = row.words; // once, in the first line of its group
    for (std::size_t k = 0; k < c.sources.size(); ++k) {
      if (!std::isfinite(row.values[k]))
        continue;
      bool const is_reference = k == 0;
      rows.push_back(
          {{{std::exchange(words, "")},
            {c.sources[k].label},
            {format_quantity(row.values[k], row.unit, 5), true},
            {is_reference ? "reference" : difference_text(row, row.differences[k]), true},
            {is_reference ? "" : tolerance_text(row, row.allowed[k]), true},
            {is_reference ? "" : word(row.agreement[k])}},
           row_class(row.agreement[k])});
    }
  }
  return table_html(header, rows);
}

std::string curves_html(Comparison const& c) {
  if (c.curves.empty())
    return "<p class=\"quiet\">No two curves to compare.</p>";
  std::vector<std::string> const header = {"Source", "Branch",           "Largest, of the peak",
                                           "at gap", "Root mean square", "Verdict"};
  std::vector<TableRow> rows;
  for (auto const& row : c.curves)
    rows.push_back({{{c.sources[row.source].label},
                     {row.branch},
                     {fmt::format("{:.2f} %", 100.0 * row.largest), true},
                     {format_quantity(row.at_gap, "m"), true},
                     {fmt::format("{:.2f} %", 100.0 * row.rms), true},
                     {word(row.agreement)}},
                    row_class(row.agreement)});
  return table_html(header, rows);
}

std::string missing_html(Comparison const& c) {
  if (c.missing.empty())
    return "";
  std::string out =
      "<section class=\"card\" id=\"missing\"><h2>What could not be compared</h2><ul>";
  for (auto const& sentence : c.missing)
    out += "<li>" + escape_html(sentence) + "</li>";
  return out + "</ul></section>";
}

std::string verdict_line(Comparison const& c) {
  auto const* kind = c.n_compared() == 0 ? "none" : c.agrees() ? "pass" : "fail";
  return fmt::format("<p class=\"verdict {}\" role=\"status\"><strong>{}</strong> {}</p>", kind,
                     c.n_compared() == 0 ? "No verdict."
                     : c.agrees()        ? "They agree."
                                         : "They differ.",
                     escape_html(in_words(c)));
}

std::string title(Comparison const& c) {
  std::string text;
  for (auto const& source : c.sources)
    text += (text.empty() ? "" : ", ") + source.label;
  return text;
}

std::string page_data(Comparison const& c) {
  std::string out = "[";
  for (auto const& source : c.sources)
    out += fmt::format("{}{{\"label\":{},\"record\":{}}}", out.size() > 1 ? "," : "",
                       json_text(source.label), record_json(source.record));
  return out + "]";
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json verdict(Agreement agreement) {
  return agreement == Agreement::unknown ? Json(nullptr) : Json(agreement == Agreement::within);
}

Json quantity_json(QuantityRow const& row) {
  Json entry = {{"name", row.name},
                {"unit", row.unit},
                {"tolerance", row.tolerance},
                {"tolerance_is", row.is_relative ? "relative" : "absolute"}};
  for (double const v : row.values)
    entry["values"].push_back(number(v));
  for (double const v : row.differences)
    entry["differences"].push_back(number(v));
  for (double const v : row.allowed)
    entry["allowed"].push_back(number(v));
  for (auto const a : row.agreement)
    entry["ok"].push_back(verdict(a));
  return entry;
}

std::string comparison_json(Comparison const& c) {
  Json json = {{"reference", c.sources[0].label},
               {"ok", c.agrees()},
               {"compared", c.n_compared()},
               {"beyond", c.n_beyond()},
               {"summary", in_words(c)}};
  for (auto const& source : c.sources)
    json["sources"].push_back(source.label);
  json["quantities"] = Json::array();
  for (auto const& row : c.quantities)
    json["quantities"].push_back(quantity_json(row));
  json["curves"] = Json::array();
  for (auto const& row : c.curves)
    json["curves"].push_back({{"source", c.sources[row.source].label},
                              {"branch", row.branch},
                              {"max_difference", row.largest},
                              {"at_gap_m", row.at_gap},
                              {"rms_difference", row.rms},
                              {"ok", verdict(row.agreement)}});
  json["missing"] = c.missing;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

void write_comparison(std::filesystem::path const& page, Comparison const& c) {
  constexpr auto how = "Differences are to the reference. Work is the integral of the upper punch "
                       "force over the gap, to the "
                       "smallest gap and after it. Where a value states its standard uncertainty, "
                       "twice that is allowed.";
  write_file(page, fill_template(assets::compare_page,
                                 {
                                     {"title", escape_html(title(c))},
                                     {"reference", escape_html(c.sources[0].label)},
                                     {"style", std::string(assets::style)},
                                     {"verdict", verdict_line(c)},
                                     {"quantities", quantities_html(c)},
                                     {"how", how},
                                     {"curves", curves_html(c)},
                                     {"missing", missing_html(c)},
                                     {"data", escape_json_in_script(page_data(c))},
                                     {"charts", escape_inline_script(assets::charts)},
                                     {"script", escape_inline_script(assets::compare_script)},
                                 }));
  write_file(page.parent_path() / "comparison.json", comparison_json(c));
}

} // namespace coupling
