#include "coupling/commands/commands.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/restart_file.hpp"
#include "coupling/study/study_page.hpp"

#include <iostream>

namespace coupling::commands {
namespace {

/// A study's folder is told by its study.json.
void report_study(std::filesystem::path const& folder) {
  auto const table = study::load_study(folder);
  auto const plan = study::plan_study(table.study);
  auto const analysis = study::analyse_if_complete(table);
  study::write_study_page({table, plan, analysis}, folder / "report.html");
}

void report_run(std::filesystem::path const& folder) {
  FoundRestart const found = newest_restart(folder);
  Press const press =
      restore_press(parse_case(found.header.case_text, folder / "case.resolved.prm"), found.file);
  write_press_report(press, folder / "report.html");
}

} // namespace

int report(std::filesystem::path const& folder) {
  if (std::filesystem::exists(folder / "study.json"))
    report_study(folder);
  else
    report_run(folder);
  std::cout << "report: " << (folder / "report.html").string() << '\n';
  return done;
}

} // namespace coupling::commands
