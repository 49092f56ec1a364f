#pragma once

#include "coupling/report/report.hpp"

#include <span>
#include <string>

/// The parts of the report that are plain HTML and need no script. Everything from outside is
/// escaped here.
namespace coupling {

/// A cell is escaped; `is_number` aligns it to the right.
struct Cell {
  std::string text;
  bool is_number = false;
};

/// One <table>. A row's class ("pass", "fail", "") colours its last cell.
struct TableRow {
  std::vector<Cell> cells;
  std::string verdict;
};
std::string table_html(std::span<std::string const> header, std::span<TableRow const> rows);

/// The line on top: what the checks say, in words, with class pass, fail or none.
std::string verdict_html(std::span<Check const> checks);

/// One sentence about the run: peak force, height, porosity, as far as it got.
std::string run_in_words(ReportData const& data);

std::string summary_html(Summary const& summary);
std::string checks_html(std::span<Check const> checks);
/// What deformable tools bore at the peak; nothing if they were rigid.
std::string tools_html(std::span<ToolSummary const> tools, StressPicture const& picture);
std::string comparison_html(std::span<ComparedValue const> rows);
std::string observed_html(std::span<ObservedValue const> rows);
std::string provenance_html(std::span<ProvenanceEntry const> entries);

} // namespace coupling
