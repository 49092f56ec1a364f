#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/finding/power_table.hpp"
#include "coupling/press_output.hpp"
#include "coupling/quantity.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace coupling::commands {
namespace {

namespace fs = std::filesystem;

/// A quantity of the command line; an empty text leaves the default.
double quantity(std::string const& option, std::string const& text, Physical physical,
                double otherwise) {
  if (text.empty())
    return otherwise;
  try {
    double const value = parse_quantity(text, physical);
    VALIDATE(value > 0.0, fmt::format("{:g} is not positive (a size or an error of a reading is). "
                                      "Is the sign wrong?",
                                      value));
    return value;
  } catch (dem::InvalidInput const& error) {
    throw dem::InvalidInput(fmt::format("{} {}: {}", option, text, error.what()));
  }
}

reduced::Instruments instruments_of(PowerOptions const& options) {
  reduced::Instruments with;
  with.force_sd = quantity("--force-sd", options.force_sd, Physical::force, with.force_sd);
  with.pressure_sd =
      quantity("--pressure-sd", options.pressure_sd, Physical::modulus, with.pressure_sd);
  with.height_sd = quantity("--height-sd", options.height_sd, Physical::length, with.height_sd);
  with.ejection_sd =
      quantity("--ejection-sd", options.ejection_sd, Physical::force, with.ejection_sd);
  with.reading_rate = options.reading_rate;
  with.n_repeats = options.n_repeats;
  return with;
}

/// The gap to which the case closes its punches.
double closing_gap(Case const& setup) {
  auto const stage = std::ranges::find_if(setup.stages, [](Stage const& one) {
    return one.kind == StageKind::move && one.until == Limit::gap && one.speed < 0.0;
  });
  VALIDATE(stage != setup.stages.end(),
           fmt::format("{}: no stage closes the punches to a gap (the planned runs need one). "
                       "Give --end-gap?",
                       setup.file.string()));
  return stage->gap;
}

double end_gap_of(PowerOptions const& options, Case const& setup) {
  return options.end_gap.empty() ? closing_gap(setup)
                                 : quantity("--end-gap", options.end_gap, Physical::length, 0.0);
}

fs::path folder_of(PowerOptions const& options) {
  auto const& file = options.choice.file;
  auto const name =
      file.stem() == "case" ? fs::absolute(file).parent_path().filename() : file.stem();
  return options.folder.empty() ? fs::path("power") / name : options.folder;
}

std::string in_one_line(std::vector<fs::path> const& folders) {
  std::vector<std::string> names;
  for (auto const& folder : folders)
    names.push_back(folder.string());
  return fmt::format("{}", fmt::join(names, ", "));
}

void publish(finding::PowerTable const& table, fs::path const& folder) {
  fs::create_directories(folder);
  write_file(folder / "power.json", power_json(table));
  write_file(folder / "power.md", power_markdown(table));
  std::cout << power_text(table);
  for (auto const* const file : {"power.json", "power.md"})
    std::cout << file << ": " << (folder / file).string() << '\n';
}

} // namespace

int power(PowerOptions const& options) {
  use_threads(options.threads);
  Case const setup = read_chosen_case(options.choice);
  auto const instruments = instruments_of(options);
  double const gap = end_gap_of(options, setup);
  double const speed = quantity("--speed", options.speed, Physical::speed, 1e-3 / 60.0);
  auto const folder = folder_of(options);
  check_run_folder(folder, options.overwrite);
  auto simulations = options.simulations;
  if (simulations.empty()) {
    simulations = {folder / "simulation"};
    if (int const status = run({.choice = options.choice,
                                .folder = simulations.front(),
                                .threads = options.threads,
                                .until = "",
                                .overwrite = options.overwrite,
                                .quiet = options.quiet});
        status != done)
      return status;
  }
  auto simulated = reduced::simulated_press(simulations);
  if (options.n_grains > 0)
    simulated.n_grains = options.n_grains;
  simulated.sheet.young_modulus_sd = options.modulus_sd;
  simulated.sheet.cohesion_sd = options.cohesion_sd;
  // The case's own mass of the powder in the case's own die: exact, for nothing is measured yet.
  auto const nominal =
      in_laboratory(simulated, {.mass = {setup.powder.total_mass, 0.0},
                                .die_diameter = {setup.tooling.bore_diameter, 0.0}});
  auto table = finding::power_table({.simulated = simulated,
                                     .nominal = nominal,
                                     .fill_height = setup.powder.fill_height,
                                     .instruments = instruments},
                                    reduced::usual_instrument_sets(speed, gap));
  table.provenance = {.case_file = options.choice.file.string(),
                      .data_folder = "",
                      .version = PRESSCHECK_VERSION,
                      .simulation = in_one_line(simulations)};
  publish(table, folder);
  return done;
}

} // namespace coupling::commands
