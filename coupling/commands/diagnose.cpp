#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/finding/case_diagnosis.hpp"
#include "coupling/finding/finding_json.hpp"
#include "coupling/finding/finding_page.hpp"
#include "coupling/finding/height_diagnosis.hpp"
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

/// As many packings as have the grains of a bed that scatters by half a per cent, at most four; a
/// fill from a file is one packing.
int packings_of(Press const& press) {
  constexpr std::size_t enough = 10'000, most = 4;
  auto const n = press.world.grains.size();
  return press.setup.powder.fill_method != FillMethod::random
             ? 1
             : static_cast<int>(std::clamp((enough + n - 1) / n, std::size_t{1}, most));
}

/// Runs packings of a case: into `folder`, and folder_2, ... beside it. @returns exit status
int simulate(CaseChoice const& choice, measured::MeasuredData const& data,
             DiagnoseOptions const& options, fs::path const& folder,
             std::vector<fs::path>& simulated) {
  auto const further = as_far_as(data, read_chosen_case(choice));
  VALIDATE(options.packings <= 1 ||
               read_chosen_case(choice).powder.fill_method == FillMethod::random,
           fmt::format("--packings {}: {} fills its die from a file, which is one packing. Give "
                       "other packings by --simulation?",
                       options.packings, choice.file.string()));
  int n = std::max(options.packings, 1);
  for (int k = 0; k < n; ++k) {
    auto packing = choice;
    packing.overrides.insert(packing.overrides.end(), further.begin(), further.end());
    Case setup = read_chosen_case(packing);
    setup.powder.seed += static_cast<std::uint64_t>(k);
    auto const into = k == 0 ? folder : fs::path(fmt::format("{}_{}", folder.string(), k + 1));
    Press press = set_up_press(setup);
    if (options.packings == 0)
      n = packings_of(press);
    std::cout << fmt::format("simulating {} in {} (packing {} of {})\n", choice.file.string(),
                             into.string(), k + 1, n);
    clear_run_folder(into);
    if (int const status = execute(press, {.folder = into,
                                           .until = last_pressing_stage(setup),
                                           .quiet = options.quiet,
                                           .is_new = true});
        status != done)
      return status;
    simulated.push_back(into);
  }
  return done;
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

std::string in_one_line(std::vector<fs::path> const& folders) {
  std::vector<std::string> names;
  for (auto const& folder : folders)
    names.push_back(folder.string());
  return fmt::format("{}", fmt::join(names, ", "));
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
  std::vector<fs::path> calibrated, extended;
  auto const run = [&](std::string const& name, finding::ExtendedCase const& what,
                       std::vector<fs::path>& simulated) {
    write_file(folder / (name + ".prm"), what.text);
    return simulate({.file = folder / (name + ".prm"), .overrides = {}, .setup = {}}, data, options,
                    folder / name, simulated);
  };
  fs::create_directories(folder);
  if (int const status = run("calibrated", extended_case(setup, {}, found.calibrated), calibrated);
      status != done)
    return status;
  if (int const status = run("extended", extended_case(setup, found), extended); status != done)
    return status;
  diagnosis.score_simulations(reduced::simulated_press(calibrated),
                              reduced::simulated_press(extended));
  return done;
}

} // namespace

int diagnose(DiagnoseOptions const& options) {
  use_threads(options.threads);
  Case const setup = read_chosen_case(options.choice);
  auto const data = measured::read_measured(options.measured);
  auto const folder = folder_of(options);
  check_run_folder(folder, options.overwrite);
  finding::Provenance const provenance{.case_file = options.choice.file.string(),
                                       .data_folder = options.measured.string(),
                                       .version = PRESSCHECK_VERSION,
                                       .simulation = {}};
  if (data.has_numbers_alone()) {
    diagnosis::DiagnosisSettings settings;
    settings.misfit.seed = options.seed;
    publish(finding::diagnose_heights(setup, data, provenance, settings), setup, folder);
    return done;
  }
  auto simulations = options.simulations;
  if (simulations.empty())
    if (int const status =
            simulate(options.choice, data, options, folder / "simulation", simulations);
        status != done)
      return status;
  auto simulated = reduced::simulated_press(simulations);
  simulated.sheet.young_modulus_sd = options.modulus_sd;
  simulated.sheet.cohesion_sd = options.cohesion_sd;
  finding::CaseQuestion question{
      .setup = setup, .data = data, .simulated = simulated, .provenance = provenance};
  question.provenance.simulation = in_one_line(simulations);
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
