#include "coupling/commands/case_runs.hpp"

#include "coupling/commands/execute.hpp"
#include "coupling/press_output.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace coupling::commands {
namespace {

namespace fs = std::filesystem;

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

/// A fill from a file is one packing.
int packings_of(Press const& press) {
  constexpr std::size_t enough = 10'000, most = 4;
  auto const n = press.world.grains.size();
  return press.setup.powder.fill_method != FillMethod::random
             ? 1
             : static_cast<int>(std::clamp((enough + n - 1) / n, std::size_t{1}, most));
}

/// A case file without its remarks.
std::string entries_of(std::string const& prm) {
  std::string entries, line;
  for (std::istringstream lines(prm); std::getline(lines, line);)
    if (auto const at = line.find_first_not_of(' '); at != line.npos && line[at] != '#')
      entries += line + '\n';
  return entries;
}

} // namespace

std::vector<fs::path> CaseRuns::simulate(CaseChoice const& choice, std::string const& name) {
  auto const further = as_far_as(data_, read_chosen_case(choice));
  VALIDATE(options_.packings <= 1 ||
               read_chosen_case(choice).powder.fill_method == FillMethod::random,
           fmt::format("--packings {}: {} fills its die from a file, which is one packing. Give "
                       "other packings by --simulation?",
                       options_.packings, choice.file.string()));
  std::vector<fs::path> simulated;
  int n = std::max(options_.packings, 1);
  for (int k = 0; k < n; ++k) {
    auto packing = choice;
    packing.overrides.insert(packing.overrides.end(), further.begin(), further.end());
    Case setup = read_chosen_case(packing);
    setup.powder.seed += static_cast<std::uint64_t>(k);
    auto const into = folder_ / (k == 0 ? name : fmt::format("{}_{}", name, k + 1));
    Press press = set_up_press(setup);
    if (options_.packings == 0)
      n = packings_of(press);
    std::cout << fmt::format("simulating {} in {} (packing {} of {})\n", choice.file.string(),
                             into.string(), k + 1, n);
    clear_run_folder(into);
    if (int const status = execute(press, {.folder = into,
                                           .until = last_pressing_stage(setup),
                                           .quiet = options_.quiet,
                                           .is_new = true});
        status != done)
      throw Stopped{status};
    simulated.push_back(into);
  }
  return simulated;
}

reduced::SimulatedPress CaseRuns::press_of(std::string const& name,
                                           finding::ExtendedCase const& what) {
  auto const entries = entries_of(what.text);
  if (auto const known = presses_.find(entries); known != presses_.end())
    return known->second;
  fs::create_directories(folder_);
  auto const file = folder_ / (name + ".prm");
  write_file(file, what.text);
  auto const folders = simulate({.file = file, .overrides = {}, .setup = {}}, name);
  return presses_.emplace(entries, reduced::simulated_press(folders)).first->second;
}

} // namespace coupling::commands
