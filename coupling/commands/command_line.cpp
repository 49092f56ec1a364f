#include "coupling/commands/command_line.hpp"

#include "coupling/commands/commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>

namespace coupling::commands {
namespace {

using Command = std::function<int()>;

void add_case_choice(CLI::App& app, CaseChoice& choice) {
  app.add_option("case", choice.file, "case file, .prm or .json")->required();
  app.add_option("--set", choice.overrides,
                 "change an entry: 'Section/Entry=value'; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--setup", choice.setup, "row of the table of set-ups beside the case, by name");
}

void add_execution(CLI::App& app, int& threads, std::string& until, bool& quiet) {
  app.add_option("--threads", threads, "number of threads (results do not depend on it)")
      ->check(CLI::Range(1, 1024));
  app.add_option("--until", until, "stop at the end of this stage");
  app.add_flag("--quiet", quiet, "no progress on standard error");
}

void declare_run(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand("run", "run a press cycle");
  auto options = std::make_shared<RunOptions>();
  add_case_choice(app, options->choice);
  app.add_option("-o,--output", options->folder, "run folder (default: runs/<case>)");
  app.add_flag("--force", options->overwrite, "replace the results in a folder that is not empty");
  add_execution(app, options->threads, options->until, options->quiet);
  app.callback([options, &command] { command = [options] { return run(*options); }; });
}

void declare_check(CLI::App& program, Command& command) {
  CLI::App& app =
      *program.add_subcommand("check", "read, validate and describe a case without running it");
  auto choice = std::make_shared<CaseChoice>();
  add_case_choice(app, *choice);
  app.callback([choice, &command] { command = [choice] { return check(*choice); }; });
}

void declare_resume(CLI::App& program, Command& command) {
  CLI::App& app =
      *program.add_subcommand("resume", "continue an interrupted run, to the same bits");
  auto options = std::make_shared<ResumeOptions>();
  app.add_option("folder", options->folder, "run folder, or one restart file in it")->required();
  add_execution(app, options->threads, options->until, options->quiet);
  app.callback([options, &command] { command = [options] { return resume(*options); }; });
}

void declare_compare(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand("compare", "overlay runs, curve files and observed data");
  auto options = std::make_shared<CompareOptions>();
  app.add_option("sources", options->sources,
                 "two or more run folders, curve files or observed data")
      ->required()
      ->expected(2, -1);
  app.add_option("-o,--output", options->file, "page to write (default: comparison.html)");
  app.callback([options, &command] { command = [options] { return compare(*options); }; });
}

void declare_report(CLI::App& program, Command& command) {
  CLI::App& app =
      *program.add_subcommand("report", "rebuild the report of a run folder or of a study");
  auto folder = std::make_shared<std::filesystem::path>();
  app.add_option("folder", *folder, "run folder, or folder of a study")->required();
  app.callback([folder, &command] { command = [folder] { return report(*folder); }; });
}

void declare_defaults(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand(
      "defaults", "every case entry with default, unit, range and description");
  auto format = std::make_shared<std::string>("prm");
  app.add_option("--format", *format, "prm or json")->check(CLI::IsMember({"prm", "json"}));
  app.callback([format, &command] {
    command = [format] {
      return defaults(*format == "json" ? DefaultsFormat::json : DefaultsFormat::prm);
    };
  });
}

void declare_verify(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand(
      "verify", "the verification suite: one row a benchmark, with its error");
  auto filter = std::make_shared<std::string>();
  app.add_option("--filter", *filter, "only benchmarks whose name contains this");
  app.callback([filter, &command] { command = [filter] { return verify(*filter); }; });
}

void declare_study(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand(
      "study",
      "a design of experiments: runs (or reads) a table of cases, and goes on after a stop");
  auto options = std::make_shared<StudyOptions>();
  app.add_option("study", options->file, "study file, .prm");
  app.add_option("-o,--output", options->folder, "folder of the study (default: studies/<study>)");
  app.add_option("--jobs", options->jobs, "runs at once (default: cores / threads)")
      ->check(CLI::Range(1, 4096));
  app.add_option("--threads", options->threads, "threads of each run")->check(CLI::Range(1, 1024));
  app.add_option("--only", options->only, "only this run; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  app.add_flag("--dry-run", options->dry_run, "check all cases, print the plan and stop");
  app.add_flag("--retry", options->retries, "try failed runs again");
  app.add_flag("--collect", options->collects, "gather the results that there are, run nothing");
  app.add_option("--export", options->export_to, "slurm: write job scripts, run nothing")
      ->check(CLI::IsMember({"slurm"}));
  app.add_flag("--entries", options->lists_entries, "list every entry of a study file and stop");
  app.add_flag("--force", options->overwrite, "use a folder that holds something else");
  app.add_flag("--quiet", options->quiet, "no plan, no progress");
  app.callback([options, &command] { command = [options] { return study(*options); }; });
}

void declare_diagnose(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand(
      "diagnose", "measured data against the simulation: what is wrong, the cause, the gain");
  auto options = std::make_shared<DiagnoseOptions>();
  add_case_choice(app, options->choice);
  app.add_option("measured", options->measured, "folder with measured.json and its curves")
      ->required();
  app.add_option("-o,--output", options->folder,
                 "folder of the diagnosis (default: diagnoses/<measured>)");
  app.add_option("--simulation", options->simulations,
                 "run folder of this case; once more for each other packing; without it the case "
                 "is run")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--packings", options->packings,
                 "packings to run (default: as many as have 10000 grains together, at most 4)")
      ->check(CLI::Range(1, 64));
  app.add_option("--seed", options->seed, "of the random draws behind p-values");
  app.add_option("--modulus-sd", options->modulus_sd,
                 "relative standard uncertainty of the case's Young's modulus (default 0.3)")
      ->check(CLI::Range(1e-3, 3.0));
  app.add_option("--cohesion-sd", options->cohesion_sd,
                 "the same of its cohesion energy density (default 0.5)")
      ->check(CLI::Range(1e-3, 3.0));
  app.add_flag("--quick", options->is_quick, "do not run the extended case");
  app.add_flag("--force", options->overwrite, "write into a folder that is not empty");
  app.add_option("--threads", options->threads, "number of threads (results do not depend on it)")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--quiet", options->quiet, "no progress on standard error");
  app.callback([options, &command] { command = [options] { return diagnose(*options); }; });
}

void declare_power(CLI::App& program, Command& command) {
  CLI::App& app = *program.add_subcommand(
      "power", "before anything is measured: which instruments would show which cause");
  auto options = std::make_shared<PowerOptions>();
  add_case_choice(app, options->choice);
  app.add_option("-o,--output", options->folder, "folder of the table (default: power/<case>)");
  app.add_option("--simulation", options->simulations,
                 "run folder of this case; once more for each other packing; without it the case "
                 "is run")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--speed", options->speed, "of closing, e.g. '2 mm/min' (default 1 mm/min)");
  app.add_option("--end-gap", options->end_gap, "of the punches (default: the case's)");
  app.add_option("--force-sd", options->force_sd, "error of a force's reading (default 12 N)");
  app.add_option("--pressure-sd", options->pressure_sd,
                 "error of a radial pressure's reading (default 0.08 MPa)");
  app.add_option("--height-sd", options->height_sd,
                 "error of a compact's measured height (default 15 um)");
  app.add_option("--ejection-sd", options->ejection_sd,
                 "error of a measured ejection force (default 10 N)");
  app.add_option("--rate", options->reading_rate, "readings a second (default 10)")
      ->check(CLI::Range(0.1, 1e5));
  app.add_option("--grains", options->n_grains,
                 "packings scatter as those of so many grains, which a finer simulation of the "
                 "powder would have (default: the simulation's)")
      ->check(CLI::Range(1, 1'000'000'000));
  app.add_option("--repeats", options->n_repeats, "repeats of each planned run (default 1)")
      ->check(CLI::Range(1, 1000));
  app.add_option("--modulus-sd", options->modulus_sd,
                 "relative standard uncertainty of the case's Young's modulus (default 0.3)")
      ->check(CLI::Range(1e-3, 3.0));
  app.add_option("--cohesion-sd", options->cohesion_sd,
                 "the same of its cohesion energy density (default 0.5)")
      ->check(CLI::Range(1e-3, 3.0));
  app.add_flag("--force", options->overwrite, "write into a folder that is not empty");
  app.add_option("--threads", options->threads, "number of threads (results do not depend on it)")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--quiet", options->quiet, "no progress on standard error");
  app.callback([options, &command] { command = [options] { return power(*options); }; });
}

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

} // namespace

int run_command_line(int argc, char const* const* argv) {
  CLI::App program("Can this simulation of powder pressing be trusted?", "presscheck");
  program.set_version_flag("--version", PRESSCHECK_VERSION);
  program.require_subcommand(1);
  Command command;
  declare_run(program, command);
  declare_check(program, command);
  declare_resume(program, command);
  declare_compare(program, command);
  declare_report(program, command);
  declare_defaults(program, command);
  declare_verify(program, command);
  declare_study(program, command);
  declare_diagnose(program, command);
  declare_power(program, command);
  try {
    program.parse(argc, argv);
  } catch (CLI::Success const& help_or_version) {
    return program.exit(help_or_version);
  } catch (CLI::ParseError const& error) {
    std::cerr << "presscheck: " << on_one_line(error.what())
              << ". What does presscheck --help say?\n";
    return wrong_input;
  }
  return command();
}

} // namespace coupling::commands
