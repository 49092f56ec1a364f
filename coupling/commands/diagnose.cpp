#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/finding/case_diagnosis.hpp"
#include "coupling/finding/finding_json.hpp"
#include "coupling/finding/finding_page.hpp"
#include "coupling/measured/read_measured.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace coupling::commands {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(DiagnoseOptions const& options) {
  return options.folder.empty()
             ? fs::path("diagnoses") / fs::absolute(options.measured).lexically_normal().filename()
             : options.folder;
}

/// The stage in which the punches close to a gap.
std::size_t closing_stage(Case const& setup) {
  auto const stage = std::ranges::find_if(setup.stages, [](Stage const& one) {
    return one.kind == StageKind::move && one.until == Limit::gap && one.speed < 0.0;
  });
  VALIDATE(stage != setup.stages.end(),
           fmt::format("{}: no stage closes the punches to a gap (measured data are compared at "
                       "gaps). Add a move of the upper punch until a gap?",
                       setup.file.string()));
  return static_cast<std::size_t>(stage - setup.stages.begin());
}

/// Everything up to the last stage before tools are taken away: what a press record shows.
std::string last_pressing_stage(Case const& setup) {
  std::string last;
  for (auto const& stage : setup.stages) {
    if (stage.kind == StageKind::release || stage.kind == StageKind::free)
      break;
    last = stage.name;
  }
  return last;
}

/// Overrides with which the case is pressed as far as the measured runs went.
std::vector<std::string> as_far_as(measured::MeasuredData const& data, Case const& setup) {
  auto const stage = closing_stage(setup);
  double least = setup.stages[stage].gap;
  for (auto const& run : data.runs)
    least = std::min(least, run.press.end_gap);
  if (least >= setup.stages[stage].gap)
    return {};
  return {fmt::format("Press programme/Stage {}/Gap = {} m", stage + 1, least)};
}

/// Runs a case into a folder unless it is there. @returns exit status
int simulate(CaseChoice choice, measured::MeasuredData const& data, fs::path const& folder,
             DiagnoseOptions const& options) {
  auto const further = as_far_as(data, read_chosen_case(choice));
  choice.overrides.insert(choice.overrides.end(), further.begin(), further.end());
  Case const setup = read_chosen_case(choice);
  std::cout << fmt::format("simulating {} in {}\n", choice.file.string(), folder.string());
  Press press = set_up_press(setup);
  clear_run_folder(folder);
  return execute(press, {.folder = folder,
                         .until = last_pressing_stage(setup),
                         .quiet = options.quiet,
                         .is_new = true});
}

/// `frame_compliance: 2e-08 m/N (1.8e-08 to 2.2e-08), probability 0.97`
std::string in_words(finding::FoundCause const& cause) {
  std::string words = cause.name;
  if (!cause.parameters.empty()) {
    auto const& size = cause.parameters.front();
    words += fmt::format(": {:.3g} {} ({:.3g} to {:.3g})", size.value,
                         size.unit == "1" ? "" : size.unit, size.low, size.high);
  }
  return words + fmt::format(", probability {:.2g}", cause.probability);
}

/// What was found, as files and in words.
void publish(finding::Finding found, Case const& setup, fs::path const& folder) {
  auto const extended = extended_case(setup, found);
  found.extension = extended.changes;
  found.not_modelled = extended.not_modelled;
  fs::create_directories(folder);
  write_file(folder / "extended.prm", extended.text);
  write_file(folder / "report.html", finding_page(found));
  write_file(folder / "diagnosis.json", diagnosis_json(found));
  std::cout << "verdict: " << found.verdict << (found.is_incomplete ? " (incomplete)" : "") << '\n';
  for (auto const& sentence : found.sentences)
    std::cout << "  " << sentence << '\n';
  for (auto const& cause : named_causes(found))
    std::cout << "  " << in_words(cause) << '\n';
  if (!found.group.empty())
    std::cout << fmt::format("  one of: {}\n", fmt::join(found.group, ", "));
  if (!found.measurements.empty())
    std::cout << fmt::format(
        "  measure next: {}{}\n", found.measurements.front().name,
        found.measurements.front().is_enough ? "" : " (it will not tell all apart)");
  for (auto const& sentence : extended.not_modelled)
    std::cout << "  not in the extended case: " << sentence << '\n';
  for (auto const* const file : {"diagnosis.json", "extended.prm", "report.html"})
    std::cout << file << ": " << (folder / file).string() << '\n';
}

/// The calibrated and the extended case, simulated, show what the named cause is worth.
int score_by_simulation(finding::CaseDiagnosis& diagnosis, Case const& setup,
                        measured::MeasuredData const& data, DiagnoseOptions const& options,
                        fs::path const& folder) {
  auto const found = diagnosis.finding();
  auto const simulated = [&](std::string const& name, finding::ExtendedCase const& what) {
    write_file(folder / (name + ".prm"), what.text);
    return simulate({.file = folder / (name + ".prm"), .overrides = {}, .setup = {}}, data,
                    folder / name, options);
  };
  fs::create_directories(folder);
  if (int const status = simulated("calibrated", extended_case(setup, {}, found.calibrated));
      status != done)
    return status;
  if (int const status = simulated("extended", extended_case(setup, found)); status != done)
    return status;
  diagnosis.score_simulations(reduced::simulated_press(folder / "calibrated"),
                              reduced::simulated_press(folder / "extended"));
  return done;
}

} // namespace

int diagnose(DiagnoseOptions const& options) {
  use_threads(options.threads);
  Case const setup = read_chosen_case(options.choice);
  auto const data = measured::read_measured(options.measured);
  auto const folder = folder_of(options);
  check_run_folder(folder, options.overwrite);
  auto const simulation = options.simulation.empty() ? folder / "simulation" : options.simulation;
  if (options.simulation.empty())
    if (int const status = simulate(options.choice, data, simulation, options); status != done)
      return status;
  auto simulated = reduced::simulated_press(simulation);
  simulated.sheet.young_modulus_sd = options.modulus_sd;
  simulated.sheet.cohesion_sd = options.cohesion_sd;
  finding::CaseQuestion question{.setup = setup,
                                 .data = data,
                                 .simulated = simulated,
                                 .provenance = {.case_file = options.choice.file.string(),
                                                .data_folder = options.measured.string(),
                                                .version = PRESSCHECK_VERSION,
                                                .simulation = simulation.string()}};
  question.settings.misfit.seed = options.seed;
  finding::CaseDiagnosis diagnosis(question);
  if (diagnosis.can_gain() && !options.is_quick)
    if (int const status = score_by_simulation(diagnosis, setup, data, options, folder);
        status != done)
      return status;
  publish(diagnosis.finding(), setup, folder);
  return done;
}

} // namespace coupling::commands
