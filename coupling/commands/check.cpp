#include "coupling/commands/commands.hpp"
#include "coupling/commands/execute.hpp"
#include "coupling/press_set_up.hpp"
#include "coupling/press_tools.hpp"
#include "coupling/run_estimate.hpp"
#include "dem/step/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace coupling::commands {
namespace {

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
  RunSize const size = run_size(press);
  auto const lengths = expected_lengths(press.programme.stages(), setup.powder.fill_height);
  StepCost const cost = measure_step(press.world, size.step);
  std::cout << setup.title << '\n';
  describe_grains(press);
  describe_tools(press);
  say("Rayleigh time", fmt::format("{:.4g} s", dem::rayleigh_time(press.world)));
  say("time step", fmt::format("{:.4g} s", size.step));
  for (std::size_t k = 0; k < lengths.size(); ++k)
    say("stage " + press.programme.stages()[k].name, fmt::format("{:.6g} s", lengths[k]));
  say("simulated time", fmt::format("{:.6g} s", size.simulated));
  say("steps", fmt::format("{:.0f}", size.steps));
  say("memory", fmt::format("{:.1f} MB as loose as now, below {:.1f} MB pressed", 1e-6 * cost.bytes,
                            1e-6 * bytes_a_pressed_grain * size.grains));
  say("estimated duration",
      fmt::format("{:.0f} s to {:.0f} s (as loose as now; pressed)", size.steps * cost.seconds,
                  pressed_to_loose * size.steps * cost.seconds));
  return done;
}

} // namespace coupling::commands
