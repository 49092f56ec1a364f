#include "coupling/commands/case_runs.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/finding/bed_facts.hpp"
#include "coupling/finding/case_diagnosis.hpp"
#include "coupling/finding/dose_search.hpp"
#include "coupling/finding/finding_json.hpp"
#include "coupling/finding/finding_page.hpp"
#include "coupling/finding/height_diagnosis.hpp"
#include "coupling/measured/read_measured.hpp"
#include "coupling/press_output.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <optional>

namespace coupling::commands {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(DiagnoseOptions const& options) {
  return options.folder.empty()
             ? fs::path("diagnoses") / fs::absolute(options.measured).lexically_normal().filename()
             : options.folder;
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
void publish(finding::Finding found, Case const& setup, finding::BedFacts const& facts,
             fs::path const& folder) {
  auto const extended = extended_case(setup, found, facts);
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

/// What `simulate` gives; nothing, and why, where a guard stops the simulation: a diagnosis is not
/// lost because one of its cases cannot be pressed.
template <class Simulate>
auto unless_guarded(Simulate simulate) -> std::optional<decltype(simulate())> {
  try {
    return simulate();
  } catch (dem::PhysicsGuard const& guard) {
    std::cout << fmt::format("  not simulated to its end: {}\n", guard.what());
    return std::nullopt;
  }
}

/// How far those entries of the named causes go of which only simulations tell.
void search_doses(finding::CaseDiagnosis const& diagnosis, Case const& setup, CaseRuns& runs,
                  finding::BedFacts& facts) {
  auto const found = diagnosis.finding();
  for (auto const& cause : named_causes(found)) {
    auto const dosed = dosed_cause(cause, setup, facts);
    if (!dosed || !dosed->obstacle.empty())
      continue;
    auto const without = unless_guarded(
        [&] { return runs.press_of("calibrated", extended_case(setup, {}, found.calibrated)); });
    if (!without)
      return;
    int n = 0;
    auto const effect_of = [&](double dose) -> std::optional<double> {
      auto trial = facts;
      trial.doses[cause.name] = {dose, ""};
      auto const what = extended_case(setup, {cause}, found.calibrated, trial);
      auto const with = unless_guarded(
          [&] { return runs.press_of(fmt::format("{}_{}", cause.name, ++n), what); });
      if (!with)
        return std::nullopt;
      double const effect = diagnosis.effect_shown(cause.name, *without, *with);
      std::cout << fmt::format("  {} of dose {:.3g}: {:.2f} of the effect\n", cause.name, dose,
                               effect);
      return effect;
    };
    auto const& size = cause.parameters.front();
    finding::DoseSearch search;
    search.tolerance =
        std::clamp(0.25 * (size.high - size.low) / std::abs(size.value), search.tolerance, 0.15);
    auto const dose = search_dose(dosed->dose, search, effect_of);
    facts.doses[cause.name] = {dose.dose, in_words(dose)};
  }
}

/// The calibrated and the extended case, simulated, show what the named cause is worth.
void score_by_simulation(finding::CaseDiagnosis& diagnosis, Case const& setup, CaseRuns& runs,
                         finding::BedFacts const& facts) {
  auto const found = diagnosis.finding();
  auto const simulated = [&](char const* name, finding::ExtendedCase const& what) {
    return unless_guarded([&] { return runs.press_of(name, what); });
  };
  auto const calibrated = simulated("calibrated", extended_case(setup, {}, found.calibrated));
  auto const extended = simulated("extended", extended_case(setup, found, facts));
  if (calibrated && extended)
    diagnosis.score_simulations(*calibrated, *extended);
  else
    std::cout << "the gain is the emulator's: the cases above cannot be pressed as they are\n";
}

int diagnose_curves(Case const& setup, measured::MeasuredData const& data,
                    DiagnoseOptions const& options, finding::Provenance provenance,
                    fs::path const& folder) {
  CaseRuns runs(data, options, folder);
  auto const simulations = options.simulations.empty() ? runs.simulate(options.choice, "simulation")
                                                       : options.simulations;
  auto simulated = reduced::simulated_press(simulations);
  simulated.sheet.young_modulus_sd = options.modulus_sd;
  simulated.sheet.cohesion_sd = options.cohesion_sd;
  provenance.simulation = in_one_line(simulations);
  finding::CaseQuestion question{
      .setup = setup, .data = data, .simulated = simulated, .provenance = provenance};
  question.settings.misfit.seed = options.seed;
  finding::CaseDiagnosis diagnosis(question);
  auto facts = finding::bed_facts(simulations.front());
  if (!options.is_quick)
    search_doses(diagnosis, setup, runs, facts);
  if (diagnosis.can_gain() && !options.is_quick)
    score_by_simulation(diagnosis, setup, runs, facts);
  publish(diagnosis.finding(), setup, facts, folder);
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
    publish(finding::diagnose_heights(setup, data, provenance, settings), setup, {}, folder);
    return done;
  }
  try {
    return diagnose_curves(setup, data, options, provenance, folder);
  } catch (Stopped const& run) {
    return run.status;
  }
}

} // namespace coupling::commands
