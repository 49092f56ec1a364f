#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/commands/interrupt.hpp"
#include "coupling/nearest_name.hpp"
#include "coupling/study/analysis.hpp"
#include "coupling/study/batch.hpp"
#include "coupling/study/batch_rank.hpp"
#include "coupling/study/published.hpp"
#include "coupling/study/results_table.hpp"
#include "coupling/study/slurm_export.hpp"
#include "coupling/study/study_estimates.hpp"
#include "coupling/study/study_page.hpp"
#include "coupling/study/validation_runs.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <thread>

namespace coupling::commands {
namespace {

using namespace coupling::study;

/// studies/<study>: the file's folder if the file is just called `study`, else its own name.
std::filesystem::path folder_of(StudyOptions const& options) {
  if (!options.folder.empty())
    return options.folder;
  auto const name = options.file.stem() == "study"
                        ? std::filesystem::absolute(options.file).parent_path().filename()
                        : options.file.stem();
  return std::filesystem::path("studies") / name;
}

/// The runs that were asked for by name; all without a name.
std::vector<std::size_t> chosen(std::vector<StudyRun> const& runs, StudyOptions const& options) {
  std::vector<std::string> names;
  names.reserve(runs.size());
  for (auto const& run : runs)
    names.push_back(run.id);
  std::vector<std::size_t> found;
  for (auto const& name : options.only) {
    auto const at = std::ranges::find(names, name);
    VALIDATE(at != names.end(),
             fmt::format("--only {}: is no run of {} (it has {}).{}", name, options.file.string(),
                         names.size(), did_you_mean(name, names, "What does --dry-run list?")));
    found.push_back(static_cast<std::size_t>(at - names.begin()));
  }
  for (std::size_t k = 0; options.only.empty() && k < runs.size(); ++k)
    found.push_back(k);
  return found;
}

template <class T>
std::vector<T> part_of(std::vector<T> const& all, std::vector<std::size_t> const& indices) {
  std::vector<T> part;
  part.reserve(indices.size());
  for (auto const k : indices)
    part.push_back(all[k]);
  return part;
}

BatchOptions batch_options(StudyOptions const& options, BatchRank const& rank, std::size_t n_runs) {
  int const n_cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  BatchOptions batch{.retries = options.retries, .stop = InterruptWatch::signal};
  // Few runs leave cores free: they get threads.
  batch.threads = options.threads > 0 ? options.threads
                  : rank.is_one_of_several()
                      ? 1
                      : std::max(1, n_cores / std::max(1, static_cast<int>(n_runs)));
  // A rank is a place for one run.
  batch.jobs = options.jobs > 0           ? options.jobs
               : rank.is_one_of_several() ? 1
                                          : std::max(1, n_cores / batch.threads);
  batch.waits = rank.rank == 0;
  batch.first = static_cast<std::size_t>(rank.rank) * n_runs / static_cast<std::size_t>(rank.size);
  batch.style = progress_style(STDERR_FILENO, options.quiet || rank.rank > 0);
  return batch;
}

std::string call_again(StudyOptions const& options, BatchFolder const& folder) {
  return fmt::format("presscheck study {} -o {}", options.file.string(), folder.path().string());
}

/// Writes what came out: results.csv, study.json, and what the study asks for of complete runs;
/// then the page.
void write_outcome(ResultsTable const& table, StudyPlan const& plan, BatchFolder const& folder) {
  write_results(table, folder.path());
  auto const analysis = analyse_if_complete(table);
  if (analysis) {
    write_analysis(*analysis, table.study, folder.path());
    std::cout << describe(*analysis, table.study) << '\n';
  }
  write_study_page({table, plan, analysis}, folder.path() / "report.html");
}

/// Tells how the runs stand. @returns the exit status
int report_runs(ResultsTable const& table, StudyOptions const& options, BatchFolder const& folder) {
  std::size_t n_done = 0, n_failed = 0;
  for (auto const& row : table.rows) {
    n_done += row.is_done() ? 1 : 0;
    n_failed += row.state == RunState::failed ? 1 : 0;
    if (row.state == RunState::failed || row.state == RunState::stopped)
      std::cerr << fmt::format("{} {}: {} (log: {})\n", row.run.id, word(row.state), row.reason,
                               folder.log(row.run.id).string());
  }
  std::cout << fmt::format("{} of {} runs done, {} failed\n", n_done, table.rows.size(), n_failed);
  std::cout << fmt::format("results: {}\nreport: {}\n", (folder.path() / "results.csv").string(),
                           (folder.path() / "report.html").string());
  if (n_done == table.rows.size())
    return done;
  std::cerr << fmt::format("go on with: {}{}\n", call_again(options, folder),
                           n_failed > 0 ? " (with --retry, failed runs too)" : "");
  return failed;
}

int read_instead(StudyPlan const& plan, StudyOptions const& options, BatchFolder const& folder) {
  auto const table = results_as_data(plan);
  std::cout << fmt::format("{}: {} runs, read from {}\n", plan.study.title, plan.runs.size(),
                           plan.study.design.results.string());
  if (options.dry_run)
    return done;
  folder.check(plan, options.overwrite);
  folder.prepare(plan.study, plan.runs, std::vector<RunEstimate>(plan.runs.size()));
  write_outcome(table, plan, folder);
  return report_runs(table, options, folder);
}

int collect(StudyPlan const& plan, StudyOptions const& options, BatchFolder const& folder) {
  auto const table = load_study(folder.path());
  write_outcome(table, plan, folder);
  return report_runs(table, options, folder);
}

/// Runs the calibrated point, once all runs of the design are done. Nothing is run twice.
/// @param runs  all so far
BatchOutcome run_validation(StudyPlan const& plan, std::vector<StudyRun> runs,
                            BatchOptions const& batch, BatchFolder const& folder) {
  auto const point = calibrated_point(analyse(load_study(folder.path())));
  for (auto& run :
       add_validation_runs(plan, folder, point, plan.study.calibration.validation_replicates))
    if (std::ranges::count(runs, run.id, &StudyRun::id) == 0)
      runs.push_back(std::move(run));
  auto const estimates = estimate_runs(runs, folder);
  folder.prepare(plan.study, runs, estimates);
  return run_batch(folder, runs, estimates, batch, std::cerr);
}

int run_study(StudyPlan const& plan, StudyOptions const& options, BatchFolder const& folder) {
  auto const rank = batch_rank();
  bool const speaks = rank.rank == 0 && options.only.empty() && !options.quiet;
  folder.check(plan, options.overwrite);
  auto runs = plan.runs;
  for (auto& run : kept_validation_runs(plan, folder))
    runs.push_back(std::move(run));
  auto const indices = chosen(runs, options);
  auto const estimates = estimate_runs(runs, folder);
  if (speaks || options.dry_run)
    std::cout << plan.study.title << '\n' << describe_costs(runs, estimates) << std::flush;
  if (options.dry_run)
    return done;
  folder.prepare(plan.study, runs, estimates);
  if (options.export_to == "slurm") {
    std::cout << "submit with: "
              << export_slurm(folder, runs, estimates,
                              {.program = std::filesystem::read_symlink("/proc/self/exe"),
                               .study = options.file,
                               .threads = std::max(1, options.threads)})
                     .string()
              << '\n';
    return done;
  }
  InterruptWatch const watch;
  auto const mine = part_of(runs, indices);
  auto const batch = batch_options(options, rank, mine.size());
  auto outcome = run_batch(folder, mine, part_of(estimates, indices), batch, std::cerr);
  if (plan.study.calibration.is_validated && rank.rank == 0 && options.only.empty() &&
      !outcome.is_interrupted && outcome.is_complete())
    outcome = run_validation(plan, runs, batch, folder);
  if (outcome.is_interrupted) {
    if (rank.rank == 0)
      std::cerr << fmt::format("interrupted: {} of {} runs done, {} stopped with what they had. Go "
                               "on with: {}\n",
                               outcome.n_done, mine.size(), outcome.n_stopped,
                               call_again(options, folder));
    return interrupted;
  }
  if (rank.rank > 0)
    return done; // rank 0 tells what failed
  if (!options.only.empty())
    return outcome.is_complete() ? done : failed;
  return collect(plan, options, folder);
}

} // namespace

int study(StudyOptions const& options) {
  if (options.lists_entries) {
    std::cout << describe_study_entries();
    return done;
  }
  VALIDATE(!options.file.empty(),
           "presscheck study: names no study file. What does presscheck study --entries list?");
  use_threads(1); // the work is done by the runs
  BatchFolder const folder(folder_of(options));
  auto const plan = plan_study(read_study(options.file));
  validate_model(plan);
  static_cast<void>(Published(plan)); // its tables are refused before anything is run
  if (plan.study.is_data())
    return read_instead(plan, options, folder);
  if (options.collects)
    return collect(plan, options, folder);
  return run_study(plan, options, folder);
}

} // namespace coupling::commands
