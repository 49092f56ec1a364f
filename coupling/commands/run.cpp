#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/compare/kept_observed.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"

namespace coupling::commands {
namespace {

/// runs/<case>: the case's folder if the file is just called `case`, else the file's own name.
std::filesystem::path default_folder(std::filesystem::path const& case_file) {
  auto const name = case_file.stem() == "case"
                        ? std::filesystem::absolute(case_file).parent_path().filename()
                        : case_file.stem();
  return std::filesystem::path("runs") / name;
}

} // namespace

int run(RunOptions const& options) {
  use_threads(options.threads);
  Case const setup = read_chosen_case(options.choice);
  auto folder = options.folder.empty() ? default_folder(options.choice.file) : options.folder;
  if (options.folder.empty() && !options.choice.setup.empty())
    folder /= options.choice.setup;
  check_run_folder(folder, options.overwrite);
  note_ranks(setup);
  // Everything that can be wrong with the input is found before the folder is touched.
  Press press = set_up_press(setup);
  check_last_stage(press, options.until);
  auto const observed = observed_rows(options.choice.file, options.choice.setup);
  clear_run_folder(folder);
  keep_observed(observed, folder);
  return execute(
      press, {.folder = folder, .until = options.until, .quiet = options.quiet, .is_new = true});
}

} // namespace coupling::commands
