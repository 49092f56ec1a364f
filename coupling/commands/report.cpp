#include "coupling/commands/commands.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/restart_file.hpp"

#include <iostream>

namespace coupling::commands {

int report(std::filesystem::path const& folder) {
  FoundRestart const found = newest_restart(folder);
  Press const press =
      restore_press(parse_case(found.header.case_text, folder / "case.resolved.prm"), found.file);
  write_press_report(press, folder / "report.html");
  std::cout << "report: " << (folder / "report.html").string() << '\n';
  return done;
}

} // namespace coupling::commands
