#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <iostream>

namespace coupling::commands {
namespace {

FoundRestart find_restart(std::filesystem::path const& place) {
  VALIDATE(
      std::filesystem::exists(place),
      fmt::format("{}: does not exist (a run folder or a restart file is needed). Is it misspelt?",
                  place.string()));
  if (std::filesystem::is_directory(place))
    return newest_restart(place);
  return {.file = place, .header = StateReader(place).header(), .refused = {}};
}

} // namespace

int resume(ResumeOptions const& options) {
  use_threads(options.threads);
  FoundRestart const found = find_restart(options.folder);
  for (auto const& refused : found.refused)
    std::cerr << "passed over " << refused << '\n';
  auto const folder =
      std::filesystem::is_directory(options.folder) ? options.folder : options.folder.parent_path();
  Case const setup = parse_case(found.header.case_text, folder / "case.resolved.prm");
  note_ranks(setup);
  Press press = restore_press(setup, found.file);
  check_last_stage(press, options.until);
  if (!options.quiet)
    std::cerr << fmt::format("continuing from {} at t = {:.6g} s\n", found.file.string(),
                             press.world.time);
  return execute(
      press, {.folder = folder, .until = options.until, .quiet = options.quiet, .is_new = false});
}

} // namespace coupling::commands
