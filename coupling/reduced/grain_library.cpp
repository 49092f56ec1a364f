#include "coupling/reduced/grain_library.hpp"

#include "coupling/case_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/reduced/bed_fit.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace coupling::reduced {
namespace {

/// A factor as the case has it.
struct Factor {
  char const* name;
  char const* measure;
  double (*value)(Case const&);
};

Factor const factors[]{
    {"grain_friction", "coefficient of friction between grains [1]",
     [](Case const& c) { return c.contacts.grain_grain.static_friction; }},
    {"wall_friction", "coefficient of friction between grains and tools [1]",
     [](Case const& c) { return c.contacts.grain_wall.static_friction; }},
    {"young_modulus", "ln(Young's modulus of the grains / Pa)",
     [](Case const& c) { return std::log(c.powder.components.front().material.young_modulus); }},
    {"cohesion", "cohesion energy density [MJ/m^3]",
     [](Case const& c) { return 1e-6 * c.contacts.grain_grain.cohesion_energy_density; }}};

struct Run {
  Case setup;
  SimulatedCycle cycle;
};

struct Runs {
  std::map<std::uint64_t, Run> middle; ///< by packing seed
  std::vector<std::pair<std::string, Run>> others;
};

Runs read_runs(std::filesystem::path const& study) {
  std::set<std::filesystem::path> folders; // in the order of their names
  VALIDATE(std::filesystem::is_directory(study / "runs"),
           fmt::format("{}: holds no runs. Is it a study's folder?", study.string()));
  for (auto const& entry : std::filesystem::directory_iterator(study / "runs"))
    if (std::filesystem::exists(entry.path() / "summary.json")) // it has finished
      folders.insert(entry.path());
  Runs runs;
  for (auto const& folder : folders) {
    Run run{read_case(folder / "case.resolved.prm"), cycle_of(read_curves(folder / "curves.csv"))};
    auto const name = folder.filename().string();
    if (name == "base" || name.starts_with("base_r"))
      runs.middle.emplace(run.setup.powder.seed, std::move(run));
    else
      runs.others.emplace_back(name, std::move(run));
  }
  VALIDATE(runs.middle.size() >= 2,
           fmt::format("{}: {} finished runs of the setup `base` (two packing seeds at least). Has "
                       "the study run?",
                       study.string(), runs.middle.size()));
  return runs;
}

/// Cycles of one factor: by value, then by seed.
using ByValue = std::map<double, std::map<std::uint64_t, SimulatedCycle const*>>;

GrainEffect effect_of(Factor const& factor, ByValue const& values, Runs const& runs,
                      Bed const& bed) {
  VALIDATE(values.size() == 2,
           fmt::format("grain effect {}: {} values beside the middle (a low and a high one). Is a "
                       "run missing?",
                       factor.name, values.size()));
  std::vector<PairedCycles> seeds;
  for (auto const& [seed, middle] : runs.middle) {
    auto const &low = values.begin()->second, &high = values.rbegin()->second;
    if (low.contains(seed) && high.contains(seed))
      seeds.push_back({*low.at(seed), middle.cycle, *high.at(seed)});
  }
  GrainEffect effect{};
  effect.factor = factor.name, effect.measure = factor.measure;
  effect.low = values.begin()->first, effect.high = values.rbegin()->first;
  effect.middle = factor.value(runs.middle.begin()->second.setup);
  return measure_effect(effect, seeds, bed);
}

PlasticEffect plastic_of(double pressure,
                         std::map<std::uint64_t, SimulatedCycle const*> const& runs,
                         std::map<std::uint64_t, BedLaw> const& middles, Bed const& bed) {
  std::vector<PlasticChange> found;
  for (auto const& [seed, cycle] : runs)
    if (middles.contains(seed))
      found.push_back(plastic_change(middles.at(seed), *cycle, bed));
  auto const n = static_cast<double>(found.size());
  auto const mean_of = [&](auto const& number) {
    double sum = 0.0, squares = 0.0;
    for (auto const& one : found)
      sum += number(one);
    for (auto const& one : found)
      squares += std::pow(number(one) - sum / n, 2);
    return std::pair{sum / n, std::sqrt(squares / (n * (n - 1.0)))};
  };
  auto const size = mean_of([](auto const& c) { return c.yielding.size; });
  auto const stress = mean_of([](auto const& c) { return c.yielding.stress; });
  auto const recovery = mean_of([](auto const& c) { return c.recovery; });
  auto const opening = mean_of([](auto const& c) { return c.ln_opening; });
  return {pressure,
          found.size(),
          {{size.first, stress.first}, recovery.first, opening.first},
          {{size.second, stress.second}, recovery.second, opening.second}};
}

/// Mean and standard deviation of the middle's numbers.
void describe_middle(GrainLibrary& library, std::map<std::uint64_t, BedLaw> const& middles) {
  auto const numbers = [](BedLaw const& l) {
    return BedNumbers{std::log(l.stiffness),
                      std::log(std::max(l.cohesion, 1.0)),
                      l.onset,
                      l.exponent,
                      l.recovery,
                      std::log(l.opening),
                      l.wall_friction,
                      l.radial_ratio};
  };
  auto const n = static_cast<double>(middles.size());
  BedNumbers mean{};
  for (auto const& [seed, law] : middles)
    for (std::size_t k = 0; k < mean.size(); ++k)
      mean[k] += numbers(law)[k] / n;
  for (auto const& [seed, law] : middles)
    for (std::size_t k = 0; k < mean.size(); ++k)
      library.middle_error[k] += std::pow(numbers(law)[k] - mean[k], 2) / (n - 1.0);
  for (double& error : library.middle_error)
    error = std::sqrt(error);
  library.middle = {.stiffness = 1.0,
                    .cohesion = 1.0,
                    .exponent = 1.0,
                    .recovery = 0.0,
                    .radial_ratio = 0.0,
                    .opening = 1.0};
  library.middle.exponent = mean[3];
  mean[3] = 0.0;
  library.middle = changed(library.middle, mean);
}

} // namespace

GrainLibrary read_library(std::filesystem::path const& study) {
  auto const runs = read_runs(study);
  Case const& middle = runs.middle.begin()->second.setup;
  Bed const bed = bed_of(middle);
  std::map<std::string, ByValue> changed_runs;
  ByValue plastic;
  for (auto const& [name, run] : runs.others) {
    std::vector<std::string> differs;
    for (auto const& factor : factors)
      if (double const value = factor.value(run.setup); value != factor.value(middle)) {
        differs.push_back(factor.name);
        changed_runs[factor.name][value][run.setup.powder.seed] = &run.cycle;
      }
    if (run.setup.contacts.law.normal != middle.contacts.law.normal) {
      differs.push_back("plastic_contacts");
      plastic[-run.setup.contacts.law.yield_pressure][run.setup.powder.seed] = &run.cycle;
    }
    VALIDATE(differs.size() == 1,
             fmt::format("run {}: changes {} of the factors (one at a time). Is it of another "
                         "study?",
                         name, differs.size()));
  }
  GrainLibrary library;
  library.n_runs = runs.middle.size() + runs.others.size();
  for (auto const& factor : factors)
    if (changed_runs.contains(factor.name))
      library.effects.push_back(effect_of(factor, changed_runs.at(factor.name), runs, bed));
  std::map<std::uint64_t, BedLaw> middles;
  for (auto const& [seed, run] : runs.middle)
    middles[seed] = fit_bed_law(run.cycle, bed).law;
  for (auto const& [falling, by_seed] : plastic)
    library.plastic.push_back(plastic_of(-falling, by_seed, middles, bed));
  describe_middle(library, middles);
  return library;
}

} // namespace coupling::reduced
