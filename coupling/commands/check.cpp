#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/press_tools.hpp"
#include "dem/step/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <vector>

namespace coupling::commands {
namespace {

constexpr int n_timed_steps = 41;

// What the engine is allowed, its contacts included.
constexpr double bytes_a_pressed_grain = 1000.0;

// A step of the pressed bed costs about so many times a step of the filling, measured over the
// seed's cycle.
constexpr double pressed_to_loose = 5.0;

struct Costs {
  double bytes;          ///< of grains, lists and records
  double seconds_a_step; ///< of wall clock, as the bed lies now
};

/// Runs a few steps of a copy: the press itself stays as it is.
Costs measure_costs(dem::World world, double step) {
  std::vector<double> seconds;
  for (int k = 0; k < n_timed_steps; ++k) {
    auto const start = std::chrono::steady_clock::now();
    dem::advance(world, step);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(seconds); // the median: the first step builds lists, another may have waited
                              // for a busy processor
  constexpr double bytes_a_grain =
      5.0 * sizeof(dem::Vec3) + 2.0 * sizeof(double) + sizeof(std::uint32_t) + 1.0;
  double const grains = bytes_a_grain * static_cast<double>(world.grains.size());
  return {.bytes = grains + static_cast<double>(world.contacts.statistics(world).bytes),
          .seconds_a_step = seconds[n_timed_steps / 2]};
}

double solid_fraction(Case const& setup, dem::Spheres const& grains) {
  double volume = 0.0;
  for (double const radius : grains.radius)
    volume += dem::sphere_volume(radius);
  double const bore = setup.tooling.bore_diameter;
  return volume / (0.25 * dem::pi * bore * bore * setup.powder.fill_height);
}

void say(std::string const& name, std::string const& value) {
  std::cout << fmt::format("{:<28}{}\n", name, value);
}

void describe_grains(Press const& press) {
  dem::Spheres const& grains = press.world.grains;
  say("grains", fmt::format("{}", grains.size()));
  for (std::size_t k = 0; k < press.setup.powder.components.size(); ++k)
    say("  " + press.setup.powder.components[k].material.name,
        fmt::format("{}", std::count(grains.material.begin(), grains.material.end(),
                                     static_cast<std::uint8_t>(k))));
  say("mass", fmt::format("{:.6g} g", 1e3 * press.grain_mass));
  say("solid fraction of the fill", fmt::format("{:.4f}", solid_fraction(press.setup, grains)));
}

void describe_tools(Press const& press) {
  for (std::size_t t = 0; t < press.coupling.n_tools(); ++t) {
    YieldingTool const& tool = press.coupling.tool(t);
    say(tool.name + ", elastic",
        fmt::format("{} nodes that grains press, gives {:.3g} um/kN", tool.pressure_loads.cols(),
                    1e9 * tool.uniform_compliance));
  }
  if (!press.coupling.is_rigid())
    say("of a contact's give, twice", fmt::format("{:.2g} % (the contact law gives it to the tool, "
                                                  "whose body is dented as well)",
                                                  100.0 * tool_share(press.setup)));
  for (dem::Tool const& tool : press.world.tools)
    say(tool.name,
        fmt::format("{} triangles, {} smooth patches", tool.surface.triangles().triangles.size(),
                    tool.surface.patches().size()));
}

} // namespace

int check(CaseChoice const& choice) {
  Case const setup = read_chosen_case(choice);
  note_ranks(setup);
  Press const press = set_up_press(setup);
  double const step = longest_step_of(setup.time_stepping)(press.world);
  auto const lengths = expected_lengths(press.programme.stages(), setup.powder.fill_height);
  double const simulated = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  double const steps = std::ceil(simulated / step);
  Costs const costs = measure_costs(press.world, step);
  std::cout << setup.title << '\n';
  describe_grains(press);
  describe_tools(press);
  say("Rayleigh time", fmt::format("{:.4g} s", dem::rayleigh_time(press.world)));
  say("time step", fmt::format("{:.4g} s", step));
  for (std::size_t k = 0; k < lengths.size(); ++k)
    say("stage " + press.programme.stages()[k].name, fmt::format("{:.6g} s", lengths[k]));
  say("simulated time", fmt::format("{:.6g} s", simulated));
  say("steps", fmt::format("{:.0f}", steps));
  say("memory",
      fmt::format("{:.1f} MB as loose as now, below {:.1f} MB pressed", 1e-6 * costs.bytes,
                  1e-6 * bytes_a_pressed_grain * static_cast<double>(press.world.grains.size())));
  say("estimated duration",
      fmt::format("{:.0f} s to {:.0f} s (as loose as now; pressed)", steps * costs.seconds_a_step,
                  pressed_to_loose * steps * costs.seconds_a_step));
  return done;
}

} // namespace coupling::commands
