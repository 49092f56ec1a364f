#include "coupling/press_set_up.hpp"

#include "coupling/fill_state.hpp"
#include "coupling/gap_path.hpp"
#include "coupling/press_grains.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_tools.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"
#include "dem/step/advance.hpp"
#include "dem/surface/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling {
namespace {

// A grain that the punch overruns by more in one step is not pushed but shot.
constexpr double largest_stroke_per_step = 0.05; // of the smallest radius

// Beyond a fifth of the Rayleigh time the first touch of two grains is not resolved.
constexpr double largest_rayleigh_fraction = 0.2;

dem::World empty_world(Case const& setup) {
  dem::World world;
  world.materials = make_materials(setup);
  world.gravity = setup.gravity;
  world.contacts = dem::ContactEngine(setup.contacts.law);
  return world;
}

void put_tools(Press& press) {
  Case const& setup = press.setup;
  if (setup.elastic.coupling.mode == CouplingMode::rigid) {
    press.world.tools = make_tools(setup, tool_material(setup));
    return;
  }
  std::vector<std::shared_ptr<YieldingTool const>> bodies;
  for (ElasticPair const& pair : make_yielding_tools(setup)) {
    dem::Tool tool{
        .name = pair.body->name, .surface = pair.touched, .material = tool_material(setup)};
    tool.deformation = pair.body->surface;
    press.world.tools.push_back(std::move(tool));
    bodies.push_back(pair.body);
  }
  press.coupling = ToolCoupling(setup.elastic.coupling, std::move(bodies));
}

Press empty_press(Case const& setup) {
  auto const stages = stages_of(setup);
  try {
    validate_stages(stages, setup.powder.fill_height);
  } catch (dem::InvalidInput const& error) {
    throw dem::InvalidInput(
        fmt::format("{}: Press programme: {}", setup.file.string(), error.what()));
  }
  VALIDATE((setup.frame.is_rigid() && setup.frame.measures_the_gap()) ||
               std::ranges::count(stages, StageKind::follow, &Stage::kind) == 0,
           fmt::format("{}: Press frame/{}: a stage follows the gap as measured at the punch "
                       "faces, behind the frame. Set it to 0, or move by command?",
                       setup.file.string(),
                       !setup.frame.is_rigid()         ? "Stiffness"
                       : setup.frame.gap_offset != 0.0 ? "Gap offset"
                                                       : "Thermal drift"));
  VALIDATE(setup.tooling.walls != WallKind::analytic ||
               std::ranges::count(stages, Limit::flush, &Stage::until) == 0,
           fmt::format("{}: Tooling/Walls = analytic: a stage ends flush with the die's rim, which "
                       "an endless cylinder does not have. Choose Walls = surface?",
                       setup.file.string()));
  Press press{.setup = setup,
              .world = empty_world(setup),
              .programme = PressProgramme(stages, starting_faces(setup),
                                          longest_step_of(setup.time_stepping),
                                          setup.time_stepping.adaptive, setup.frame),
              .record = PressRecord(curve_columns()),
              .tally = {},
              .load_cell = LoadCell(setup.load_cell),
              .peak = {},
              .coupling = {}};
  put_tools(press);
  tool_named(press.world, "upper_punch").displacement.z() += setup.frame.gap_offset;
  return press;
}

double total_mass(dem::Spheres const& grains) {
  return std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0);
}

/// Grains whose centre is nearer to a tool's face than (1 - limit) R, or beyond it.
void check_walls(Case const& setup, dem::Spheres const& grains) {
  double const bore = 0.5 * setup.tooling.bore_diameter;
  double const limit = setup.time_stepping.max_relative_overlap;
  double const gap = setup.powder.fill_height + setup.frame.gap_offset;
  std::size_t n_outside = 0, worst = 0;
  double deepest = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    dem::Vec3 const& x = grains.position[i];
    double const R = grains.radius[i];
    double const ceiling = gap + setup.tooling.punch_slope() * x.x();
    double const overlap =
        std::max({std::hypot(x.x(), x.y()) + R - bore, R - x.z(), x.z() + R - ceiling});
    if (overlap <= limit * R)
      continue;
    ++n_outside;
    if (overlap > deepest)
      deepest = overlap, worst = i;
  }
  VALIDATE(n_outside == 0,
           fmt::format("{}: {} of {} grains start outside the die (grain {} at z = {:.4g} m by "
                       "{:.3g} m). Is the axis of the "
                       "packing z, z = 0 the lower punch, and 'Fill height' the upper one's?",
                       setup.file.string(), n_outside, grains.size(), worst,
                       grains.position[worst].z(), deepest));
}

void check_overlaps(Case const& setup, dem::World const& world) {
  std::size_t n_deep = 0;
  double worst = 0.0;
  dem::Spheres const& grains = world.grains;
  dem::ContactStream(world).for_each([&](dem::Contact const& contact) {
    if (contact.j == dem::Contact::none)
      return;
    double const relative =
        contact.overlap / std::min(grains.radius[contact.i], grains.radius[contact.j]);
    if (relative > setup.time_stepping.max_relative_overlap)
      ++n_deep;
    worst = std::max(worst, relative);
  });
  VALIDATE(n_deep == 0,
           fmt::format("{}: {} pairs of grains overlap by more than {:.3g} of the smaller radius "
                       "at the start (the worst by "
                       "{:.3g}). Is the packing's diameter a radius, or a grain listed twice?",
                       setup.file.string(), n_deep, setup.time_stepping.max_relative_overlap,
                       worst));
}

void check_speeds(Press const& press) {
  double const step = longest_step_of(press.setup.time_stepping)(press.world);
  double const radius = *std::ranges::min_element(press.world.grains.radius);
  for (Stage const& stage : press.programme.stages()) {
    double const stroke =
        stage.kind == StageKind::move ? std::abs(stage.speed) * step / radius : 0.0;
    VALIDATE(stroke <= largest_stroke_per_step,
             fmt::format("{}: stage '{}': Speed = {:.6g} m/s moves {:.3g} grain radii per step "
                         "(limit {:.3g}). Lower the "
                         "speed or the time step?",
                         press.setup.file.string(), stage.name, stage.speed, stroke,
                         largest_stroke_per_step));
  }
}

} // namespace

std::vector<Stage> stages_of(Case const& setup) {
  std::vector<Stage> stages;
  if (setup.powder.settle_time > 0.0)
    stages.push_back({.name = "settle",
                      .kind = StageKind::free,
                      .tools = {},
                      .duration = setup.powder.settle_time});
  stages.insert(stages.end(), setup.stages.begin(), setup.stages.end());
  for (Stage& stage : stages) {
    if (stage.kind != StageKind::follow)
      continue;
    stage.path = read_gap_path(stage.follow_file, stage.time_scale);
    stage.duration = stage.path.time.back();
  }
  return stages;
}

PressProgramme::LongestStep longest_step_of(TimeStepping const& time_stepping) {
  return [time_stepping](dem::World const& world) {
    double const rayleigh = dem::rayleigh_time(world);
    if (!time_stepping.adaptive)
      return time_stepping.rayleigh_fraction * rayleigh;
    return std::min(time_stepping.safety * dem::stable_time_step(world),
                    largest_rayleigh_fraction * rayleigh);
  };
}

Press set_up_press(Case const& setup) {
  Press press = empty_press(setup);
  press.world.materials = materials_now(press);
  press.world.grains = fill_die(setup);
  press.grain_mass = total_mass(press.world.grains);
  check_walls(setup, press.world.grains);
  check_speeds(press);
  dem::prepare(press.world);
  check_overlaps(setup, press.world);
  return press;
}

Press restore_press(Case const& setup, std::filesystem::path const& restart_file) {
  Press press = empty_press(setup);
  StateReader read(restart_file);
  press.load(read);
  read.finish();
  change_materials(press);
  return press;
}

void write_tools(Press const& press, std::filesystem::path const& folder) {
  if (press.setup.tooling.walls == WallKind::analytic)
    return;
  std::filesystem::create_directories(folder);
  for (dem::Tool const& tool : press.world.tools)
    dem::write_stl(folder / (tool.name + ".stl"), tool.surface.triangles());
}

} // namespace coupling
