#include "coupling/commands/execute.hpp"

#include "coupling/case_setups.hpp"
#include "coupling/commands/commands.hpp"
#include "coupling/commands/interrupt.hpp"
#include "coupling/elastic/session.hpp"
#include "coupling/press_cycle.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace coupling::commands {
namespace {

int report_interruption(RunFolder const& folder, Press const& press) {
  std::cerr << fmt::format("interrupted at t = {:.6g} s; {}. Continue with: presscheck resume {}\n",
                           press.world.time, folder.last_restart(), folder.path().string());
  return interrupted;
}

/// Runs, and adds to the reason of a stop from where one can go on.
RunEnd run_cycle(Press& press, RunFolder& folder, Progress& progress, std::string const& until) {
  PressCycle cycle(press, folder, progress, InterruptWatch::is_requested);
  try {
    return cycle.run(until);
  } catch (dem::PhysicsGuard const& guard) {
    progress.finish();
    folder.write_curves(press);
    throw dem::PhysicsGuard(fmt::format("{}; {}", guard.what(), folder.last_restart()));
  } catch (WriteFailed const& full) {
    progress.finish();
    throw WriteFailed(fmt::format("{}; {}", full.what(), folder.last_restart()));
  }
}

void report_end(RunFolder const& folder, Press const& press, RunEnd end) {
  if (end == RunEnd::stage_reached && !press.programme.is_done())
    std::cout << fmt::format("stopped before stage '{}'; continue with: presscheck resume {}\n",
                             press.programme.stage().name, folder.path().string());
  std::cout << fmt::format("report: {}\n", (folder.path() / "report.html").string());
}

} // namespace

void check_last_stage(Press const& press, std::string const& until) {
  auto const stages = press.programme.stages();
  if (until.empty() || std::ranges::count(stages, until, &Stage::name) > 0)
    return;
  std::string names;
  for (Stage const& stage : stages)
    names += (names.empty() ? "" : ", ") + stage.name;
  throw dem::InvalidInput(fmt::format(
      "--until {}: there is no such stage (there are: {}). Is it misspelt?", until, names));
}

Case read_chosen_case(CaseChoice const& choice) {
  // What is set by hand comes last and wins over the set-up's.
  std::vector<std::string> overrides;
  if (!choice.setup.empty())
    overrides = setup_overrides(choice.file, choice.setup);
  overrides.insert(overrides.end(), choice.overrides.begin(), choice.overrides.end());
  return read_case(choice.file, overrides);
}

void use_threads(int threads) {
  if (threads > 0)
    omp_set_num_threads(threads);
}

void note_ranks(Case const& setup) {
  if (n_ranks() == 1)
    return;
  if (setup.elastic.coupling.mode == CouplingMode::rigid)
    std::cerr << fmt::format("{}: Mode = rigid: one of the {} ranks does the work (ranks share "
                             "that of elastic tools). Leave out mpirun?\n",
                             setup.file.string(), n_ranks());
  if (long const n_cores = sysconf(_SC_NPROCESSORS_ONLN); omp_get_num_procs() < n_cores)
    std::cerr << fmt::format("mpirun: the grains may use {} of {} cores (it binds each rank to "
                             "some). Add --bind-to none?\n",
                             omp_get_num_procs(), n_cores);
}

int execute(Press& press, Execution const& how) {
  RunFolder folder(how.folder, press.world.time);
  if (how.is_new)
    folder.write_inputs(press);
  Progress progress(std::cerr, progress_style(STDERR_FILENO, how.quiet));
  InterruptWatch const watch;
  RunEnd const end = run_cycle(press, folder, progress, how.until);
  progress.finish();
  if (end == RunEnd::interrupted) {
    folder.write_curves(press);
    return report_interruption(folder, press);
  }
  folder.write_results(press);
  report_end(folder, press, end);
  return done;
}

} // namespace coupling::commands
