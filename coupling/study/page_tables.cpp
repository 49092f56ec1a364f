#include "coupling/study/page_tables.hpp"

#include "coupling/report/html.hpp"
#include "coupling/report/sections.hpp"
#include "coupling/study/page_units.hpp"
#include "coupling/study/published.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace coupling::study {
namespace {

std::string paragraph(std::string const& text) {
  return "<p class=\"quiet\">" + escape_html(text) + "</p>\n";
}

std::string list_html(std::vector<std::string> const& items, std::string const& name) {
  if (items.empty())
    return "";
  std::string out = fmt::format("<ul class=\"{}\">\n", name);
  for (auto const& item : items)
    out += "<li>" + escape_html(item) + "</li>\n";
  return out + "</ul>\n";
}

/// `3e6` of `3e6 J/m^3`.
std::string number_of(std::string const& quantity) {
  return quantity.substr(0, quantity.find(' '));
}

std::size_t count_of(ResultsTable const& table, RunState state) {
  return static_cast<std::size_t>(std::ranges::count(table.rows, state, &ResultRow::state));
}

/// `39.4 (-3.2 %)`: what was published, and how far ours is from it.
Cell beside(double theirs, double ours, ShownUnit const& unit) {
  if (!std::isfinite(theirs))
    return {"-", true};
  auto text = short_number(unit.factor * theirs, 4);
  if (std::isfinite(ours) && theirs != 0.0)
    text += fmt::format(" ({:+.1f} %)", 100.0 * (ours - theirs) / std::abs(theirs));
  return {text, true};
}

/// A run's response and what was published beside it.
void add_response(TableRow& line, ResultsTable const& table, ResultRow const& row,
                  StudyResponse const& response, Published const& published) {
  auto const unit = shown_unit(table, response);
  std::vector<double> column;
  for (auto const& one : table.rows)
    column.push_back(unit.factor * one.value(response.quantity));
  double const ours = row.value(response.quantity);
  line.cells.push_back({fixed_number(unit.factor * ours, decimals_of(column)), true});
  for (auto const& source : published.sources())
    line.cells.push_back(beside(published.value(source, row.run.setup, response), ours, unit));
}

} // namespace

std::string lead_html(StudyPage const& page) {
  auto const& study = page.table.study;
  std::set<std::string> setups;
  for (auto const& run : page.plan.runs)
    setups.insert(run.setup);
  std::vector<std::string> factors, responses;
  for (auto const& factor : study.factors)
    factors.push_back(fmt::format("{} ({} to {})", factor.name, factor.text(factor.low),
                                  factor.text(factor.high)));
  for (auto const& response : study.responses) {
    auto quantity = response.quantity;
    std::ranges::replace(quantity, '_', ' ');
    responses.push_back(fmt::format("{} ({})", response.name, quantity));
  }
  auto text = fmt::format("{} set-ups in {} runs{}", setups.size(), page.plan.runs.size(),
                          study.is_data() ? ", read from a table" : "");
  if (!factors.empty())
    text += fmt::format(": how {} {} on {}", fmt::join(responses, ", "),
                        responses.size() == 1 ? "depends" : "depend", fmt::join(factors, ", "));
  return "<p class=\"lead\">" + escape_html(text) + ".</p>\n";
}

std::string runs_verdict_html(StudyPage const& page) {
  auto const& rows = page.table.rows;
  auto const n_done = count_of(page.table, RunState::done);
  auto const n_failed = count_of(page.table, RunState::failed);
  bool const is_complete = n_done == rows.size();
  auto const n_beside =
      std::ranges::count_if(rows, [](ResultRow const& row) { return row.run.is_validation; });
  auto const beside =
      n_beside > 0 ? fmt::format(" ({} of them validation runs beside the design)", n_beside) : "";
  auto out = fmt::format(
      "<div class=\"verdict {}\" role=\"status\"><strong>{} of {} runs finished</strong>{}, {} "
      "failed.{}",
      is_complete ? "pass" : "fail", n_done, rows.size(), escape_html(beside), n_failed,
      page.analysis || page.table.study.responses.empty()
          ? ""
          : " The runs that are missing leave the design incomplete, so nothing is fitted to it.");
  std::vector<std::string> missing;
  for (auto const& row : rows)
    if (!row.is_done())
      missing.push_back(fmt::format("{}: {}{}{}", row.run.id, word(row.state),
                                    row.reason.empty() ? "" : ", ", row.reason));
  return out + list_html(missing, "missing-runs") + "</div>\n";
}

std::string answers_html(StudyPage const& page) {
  auto const all = answers(page);
  if (all.empty())
    return "";
  return "<section class=\"card\" id=\"answers\"><h2>Answers</h2>\n" + list_html(all, "answers") +
         "</section>\n";
}

std::string design_html(StudyPage const& page) {
  auto const& study = page.table.study;
  Published const published(page.plan);
  std::vector<std::string> header{"Run"};
  for (auto const& factor : study.factors)
    header.push_back(shown_unit(factor).head(factor.name));
  for (auto const& response : study.responses) {
    header.push_back(shown_unit(page.table, response).head(response.name));
    for (auto const& source : published.sources())
      header.push_back(fmt::format("{}: {}", response.name, source));
  }
  std::vector<TableRow> rows;
  for (auto const& row : page.table.rows) {
    TableRow line{{{row.run.id}}, row.is_done() ? "" : "fail"};
    for (std::size_t f = 0; f < study.factors.size(); ++f)
      line.cells.push_back({number_of(study.factors[f].text(row.run.natural[f])), true});
    for (auto const& response : study.responses)
      add_response(line, page.table, row, response, published);
    rows.push_back(std::move(line));
  }
  std::string note;
  if (!published.sources().empty())
    note = "Published values stand beside ours, with the deviation of ours in per cent of theirs.";
  for (auto const& response : study.responses)
    if (!published.sources().empty() && response.reference_scale != 1.0)
      note += fmt::format(" Those of {} are taken times {:.6g}.", response.name,
                          response.reference_scale);
  return "<section class=\"card\" id=\"design\"><h2>Runs and results</h2>\n<div class=\"scroll "
         "tall\">" +
         table_html(header, rows) + "</div>\n" + (note.empty() ? "" : paragraph(note)) +
         "</section>\n";
}

std::string study_provenance_html(StudyPage const& page) {
  auto const& study = page.table.study;
  double cpu = 0.0;
  for (auto const& row : page.table.rows)
    cpu += row.cpu_seconds;
  std::vector<ProvenanceEntry> entries{
      {"program", fmt::format("presscheck {}", PRESSCHECK_VERSION)},
      {"case", study.case_file.filename().string()},
      {"design", study.design.kind_name},
      {"model", study.factors.empty() ? "none" : study.model},
      {"packings of a point", fmt::format("{}", study.design.replicates)}};
  if (study.is_data())
    entries.push_back({"results", study.design.results.filename().string()});
  for (auto const& table : study.references.tables)
    entries.push_back({"published values", table.filename().string()});
  if (cpu > 0.0)
    entries.push_back({"processor time of all runs", duration_text(cpu)});
  return provenance_html(entries);
}

} // namespace coupling::study
