#include "coupling/study/run_cost.hpp"

#include "coupling/case_file.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/progress.hpp"
#include "coupling/run_estimate.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::study {
namespace {

// Mean of a cycle between the loose bed and the pressed one, which costs pressed_to_loose times as
// much; on the seed's cycle.
constexpr double mean_to_loose = 0.5 * (1.0 + pressed_to_loose);

} // namespace

RunEstimate estimate_run(StudyRun const& run) {
  try {
    Case setup = parse_case(run.case_text, run.id + ".prm");
    // Elastic tools take minutes to condense and change neither grains nor steps.
    setup.elastic.coupling.mode = CouplingMode::rigid;
    Press const press = set_up_press(setup);
    RunSize const size = run_size(press);
    return {.grains = size.grains,
            .steps = size.steps,
            .bytes = bytes_of_run(size.grains),
            .seconds_per_particle_step =
                mean_to_loose * measure_step(press.world, size.step).seconds / size.grains};
  } catch (dem::InvalidInput const& problem) {
    throw dem::InvalidInput(fmt::format("{}: run '{}': {}", run.where, run.id, problem.what()));
  }
}

double bytes_of_run(double grains) {
  return bytes_of_program + bytes_a_pressed_grain * grains;
}

StudyCost sum_costs(std::vector<RunEstimate> const& estimates) {
  StudyCost sum{.n_runs = estimates.size()};
  for (auto const& one : estimates) {
    sum.particle_steps += one.particle_steps();
    sum.cpu_seconds += one.cpu_seconds();
    sum.largest_bytes = std::max(sum.largest_bytes, one.bytes);
    sum.longest_cpu_seconds = std::max(sum.longest_cpu_seconds, one.cpu_seconds());
  }
  return sum;
}

std::string describe_costs(std::vector<StudyRun> const& runs,
                           std::vector<RunEstimate> const& estimates) {
  std::size_t width = 3;
  for (auto const& run : runs)
    width = std::max(width, run.id.size());
  auto text = fmt::format("{:<{}}  {:>8}  {:>9}  {:>14}  {:>10}  {:>13}\n", "run", width, "grains",
                          "steps", "particle-steps", "memory", "CPU time");
  for (std::size_t k = 0; k < runs.size(); ++k)
    text +=
        fmt::format("{:<{}}  {:>8.0f}  {:>9.0f}  {:>14.3g}  {:>7.0f} MB  {:>13}\n", runs[k].id,
                    width, estimates[k].grains, estimates[k].steps, estimates[k].particle_steps(),
                    1e-6 * estimates[k].bytes, write_duration(estimates[k].cpu_seconds()));
  auto const sum = sum_costs(estimates);
  return text + fmt::format("in all: {} runs, {:.3g} particle-steps, about {} of CPU time\n",
                            sum.n_runs, sum.particle_steps, write_duration(sum.cpu_seconds));
}

} // namespace coupling::study
