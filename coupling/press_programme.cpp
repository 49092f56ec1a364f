#include "coupling/press_programme.hpp"

#include "coupling/gap_path.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace coupling {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// A stage length that is a whole number of steps but for rounding gets that number, not one more.
constexpr double rounding = 1e-9;

double grain_mass(dem::World const& world) {
  return std::accumulate(world.grains.mass.begin(), world.grains.mass.end(), 0.0);
}

ServoReading read_servo(dem::World const& world, Stage const& stage, PunchFaces const& faces) {
  return {.gap = punch_gap(world, faces),
          .force = squeezing_force(tool_named(world, stage.tools.front())),
          .mass = grain_mass(world)};
}

/// Bound of a servo's speed [m/s]: the stage's own, or the seed's punch speed.
double servo_speed(Stage const& stage) {
  return stage.speed != 0.0 ? std::abs(stage.speed) : 0.2;
}

/// An upper bound of the bed's stiffness: its grains' material as one solid cylinder,  E A / gap,
/// A = V / gap.
double solid_stiffness(dem::World const& world, double gap) {
  double volume = 0.0;
  double modulus = 0.0;
  for (std::size_t i = 0; i < world.grains.size(); ++i) {
    volume += dem::sphere_volume(world.grains.radius[i]);
    modulus = std::max(modulus, world.materials[world.grains.material[i]].young_modulus);
  }
  return modulus * volume / (gap * gap);
}

auto& find_tool(auto& tools, std::string_view name) {
  auto const found = std::ranges::find(tools, name, &dem::Tool::name);
  if (found == tools.end())
    throw std::out_of_range("no tool is called " + std::string(name));
  return *found;
}

} // namespace

double punch_gap(dem::World const& world, PunchFaces const& faces) {
  double const upper = tool_named(world, "upper_punch").displacement.z() + faces.upper;
  double const lower = tool_named(world, "lower_punch").displacement.z() + faces.lower;
  return upper - lower;
}

double rim_height(dem::Tool const& die) {
  double height = -unbounded;
  for (dem::Vec3 const& vertex : die.surface.triangles().vertices)
    height = std::max(height, vertex.z());
  return height;
}

dem::Tool const& tool_named(dem::World const& world, std::string_view name) {
  return find_tool(world.tools, name);
}

dem::Tool& tool_named(dem::World& world, std::string_view name) {
  return find_tool(world.tools, name);
}

double squeezing_force(dem::Tool const& tool) {
  if (!tool.present)
    return 0.0;
  return tool.name == "upper_punch" ? tool.force.z()
                                    : 0.0 - tool.force.z(); // 0 - 0 is no negative zero
}

PressProgramme::PressProgramme(std::vector<Stage> stages, PunchFaces faces,
                               LongestStep longest_step, bool adaptive, FrameLaw frame)
    : stages_(std::move(stages)), faces_(faces), longest_step_(std::move(longest_step)),
      adaptive_(adaptive), expected_lengths_(expected_lengths(stages_, faces.upper - faces.lower)),
      frame_(frame) {}

double PressProgramme::commanded_gap(dem::World const& world) const {
  return punch_gap(world, faces_) - frame_.deflection();
}

void PressProgramme::start_stage(dem::World& world) {
  EXPECT(!is_done() && !is_started());
  if (stage().kind == StageKind::release) {
    for (auto const& name : stage().tools) {
      dem::Tool& tool = tool_named(world, name);
      tool.present = false;
      tool.force = tool.velocity = dem::Vec3::Zero();
      tool.radial_force = 0.0;
    }
  }
  if (stage().kind == StageKind::hold && stage().servo)
    servo_.start(solid_stiffness(world, punch_gap(world, faces_)));
  started_ = 1;
  stage_start_ = world.time;
  stage_end_ = world.time + planned_length(world);
  plan_steps(world);
}

double PressProgramme::planned_length(dem::World const& world) const {
  Stage const& s = stage();
  if (s.kind == StageKind::release)
    return 0.0;
  if (s.kind == StageKind::follow) {
    double const gap = punch_gap(world, faces_);
    if (std::abs(s.path.gap.front() - gap) > path_start_tolerance)
      throw dem::PhysicsGuard(fmt::format("stage '{}': the path to follow starts at a gap of "
                                          "{:.6g} m, but the punches stand {:.6g} m apart. Move "
                                          "them there in a stage before?",
                                          s.name, s.path.gap.front(), gap));
  }
  double const limit = s.duration > 0.0 ? s.duration : unbounded;
  if (s.kind != StageKind::move || s.until == Limit::time)
    return s.duration;
  if (s.until == Limit::force)
    return limit;
  if (s.until == Limit::flush) {
    dem::Tool const& die = tool_named(world, "die");
    double const face = tool_named(world, "lower_punch").displacement.z() + faces_.lower;
    return length_until(rim_height(die) + die.displacement.z() - face, ejection_rate(s),
                        "the die's rim");
  }
  double const gap = commanded_gap(world);
  return length_until(s.gap - gap, gap_rate(s), fmt::format("a gap of {:.6g} m", s.gap));
}

double PressProgramme::length_until(double distance, double rate, std::string_view aim) const {
  Stage const& s = stage();
  double const length = distance / rate;
  double const limit = s.duration > 0.0 ? s.duration : unbounded;
  if (length >= 0.0 && length <= limit * (1.0 + rounding))
    return length;
  throw dem::PhysicsGuard(fmt::format("stage '{}': {} is not reached over {:.6g} m at {:.6g} m/s "
                                      "within {:.6g} s. Give it more time, or turn the speed's "
                                      "sign?",
                                      s.name, aim, distance, s.speed, limit));
}

void PressProgramme::plan_steps(dem::World const& world) {
  double const longest = longest_step_(world);
  double const left = stage_end_ - world.time;
  steps_to_renewal_ = renewal;
  if (!std::isfinite(stage_end_)) {
    steps_to_end_ = 0;
    step_ = longest;
    return;
  }
  steps_to_end_ = static_cast<std::uint64_t>(std::ceil(left / longest * (1.0 - rounding)));
  step_ = steps_to_end_ > 0 ? left / static_cast<double>(steps_to_end_) : longest;
}

bool PressProgramme::force_reached(dem::World const& world) const {
  double const force = squeezing_force(tool_named(world, stage().tools.front()));
  return gap_rate(stage()) > 0.0 ? force <= stage().force : force >= stage().force;
}

bool PressProgramme::stage_has_ended(dem::World const& world) const {
  bool const time_is_over = std::isfinite(stage_end_) && steps_to_end_ == 0;
  bool const is_driven =
      stage().kind == StageKind::move || stage().kind == StageKind::follow || stage().servo;
  double const gap = punch_gap(world, faces_);
  if (is_driven && gap <= faces_.drop)
    throw dem::PhysicsGuard(fmt::format(
        "stage '{}': the punches meet at t = {:.6g} s (gap {:.6g} m). Is there too little "
        "powder for the stage's limit?",
        stage().name, world.time, gap));
  if (stage().kind != StageKind::move || stage().until != Limit::force)
    return time_is_over;
  if (force_reached(world))
    return true;
  if (time_is_over)
    throw dem::PhysicsGuard(fmt::format("stage '{}': {} carries {:.6g} N after {:.6g} s and the "
                                        "limit of {:.6g} N is not reached. Give it more time, or "
                                        "a smaller force?",
                                        stage().name, stage().tools.front(),
                                        squeezing_force(tool_named(world, stage().tools.front())),
                                        world.time - stage_start_, stage().force));
  return false;
}

double PressProgramme::command_step(dem::World& world) {
  if (adaptive_ && steps_to_renewal_ == 0)
    plan_steps(world);
  Stage const& s = stage();
  double speed = s.kind == StageKind::move ? s.speed : 0.0;
  if (s.kind == StageKind::follow) {
    double const aim = gap_at(s.path, world.time + step_ - stage_start_);
    double const opening = (aim - punch_gap(world, faces_)) / step_;
    speed = s.tools.front() == "upper_punch" ? opening : -opening;
  }
  if (s.kind == StageKind::hold && s.servo) {
    double const closing =
        servo_.closing_speed(read_servo(world, s, faces_), s.force, servo_speed(s), step_);
    speed = s.tools.front() == "upper_punch" ? -closing : closing;
  }
  for (dem::Tool& tool : world.tools)
    tool.velocity = dem::Vec3(0.0, 0.0, drives(s, tool.name) ? speed : 0.0);
  dem::Tool& upper = tool_named(world, "upper_punch");
  upper.velocity.z() += frame_.speed();
  // A released punch goes along with the other, so that their gap stays what it was.
  if (!upper.present)
    upper.velocity = tool_named(world, "lower_punch").velocity;
  return step_;
}

void PressProgramme::step_done(dem::World& world) {
  if (steps_to_renewal_ > 0)
    --steps_to_renewal_;
  if (stage().kind == StageKind::move && gap_rate(stage()) != 0.0)
    servo_.watch(punch_gap(world, faces_),
                 squeezing_force(tool_named(world, stage().tools.front())));
  frame_.step_done(squeezing_force(tool_named(world, "upper_punch")), punch_gap(world, faces_),
                   step_);
  if (steps_to_end_ > 0 && --steps_to_end_ == 0)
    world.time = stage_end_;
}

void PressProgramme::finish_stage(dem::World& world) {
  for (dem::Tool& tool : world.tools)
    tool.velocity = dem::Vec3::Zero();
  started_ = 0;
  ++index_;
}

double PressProgramme::stage_progress(dem::World const& world) const {
  if (!is_started())
    return 0.0;
  double const by_time = std::isfinite(stage_end_) ? (world.time - stage_start_) /
                                                         std::max(stage_end_ - stage_start_, 1e-300)
                                                   : 0.0;
  if (stage().kind != StageKind::move || stage().until != Limit::force || gap_rate(stage()) > 0.0)
    return std::clamp(by_time, 0.0, 1.0);
  double const by_force = squeezing_force(tool_named(world, stage().tools.front())) / stage().force;
  return std::clamp(std::max(by_time, by_force), 0.0, 1.0);
}

double PressProgramme::run_progress(dem::World const& world) const {
  double const all = std::accumulate(expected_lengths_.begin(), expected_lengths_.end(), 0.0);
  if (is_done() || all == 0.0)
    return 1.0;
  auto const present = expected_lengths_.begin() + static_cast<std::ptrdiff_t>(index_);
  return (std::accumulate(expected_lengths_.begin(), present, 0.0) +
          stage_progress(world) * *present) /
         all;
}

} // namespace coupling
