#pragma once

#include "coupling/case.hpp"
#include "coupling/press_frame.hpp"
#include "coupling/press_servo.hpp"
#include "dem/step/world.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// Heights of the punch faces in the tools' own frames [m].
struct PunchFaces {
  double lower = 0.0;
  double upper = 0.0; ///< in its middle
  double drop = 0.0;  ///< of the lowest side of a tilted upper face below its middle
};

/// Distance of the punch faces as they are, on the axis [m]; kept when a punch has been released.
double punch_gap(dem::World const& world, PunchFaces const& faces);

/// Height of the die's rim in its own frame [m].
double rim_height(dem::Tool const& die);

/// The tool of that name. @throws std::out_of_range if there is none
dem::Tool& tool_named(dem::World& world, std::string_view name);
dem::Tool const& tool_named(dem::World const& world, std::string_view name);

/// Axial force of the bed on a tool [N], positive when the tool is squeezed: the upper punch pushed
/// up, the lower punch and the die pushed down. Zero for a tool that has been released.
double squeezing_force(dem::Tool const& tool);

/// Whether a stage acts on a tool.
bool drives(Stage const& stage, std::string_view tool);

/// d gap / dt of a motion [m/s], positive when it opens.
double gap_rate(Stage const& stage);

/// Speed of the lower punch's face towards the die's rim [m/s], positive when it ejects.
double ejection_rate(Stage const& stage);

/// Refuses stages that cannot be run: none at all, an unknown or missing tool, a second use of a
/// released tool, a motion that leads away from its limit, punches that would meet.
/// @param fill_height  gap of the punches before the first stage [m]
/// @throws dem::InvalidInput
void validate_stages(std::span<Stage const> stages, double fill_height);

/// How long each stage is expected to take [s]; a stage that ends by force: its longest, or until
/// the punches meet.
std::vector<double> expected_lengths(std::span<Stage const> stages, double fill_height);

/// The stages of a press cycle, one after the other, as commands to the tools.
///
/// Within a stage of known length T all steps are equal, dt = T / ceil(T / dt_max), so that the
/// last one lands on the stage's end; the end is the planned time to the last bit. A stage that
/// ends by force runs with dt_max. If the step adapts to the state, the plan is renewed every
/// `renewal` steps.
class PressProgramme {
public:
  /// The longest step [s] that the present state allows.
  using LongestStep = std::function<double(dem::World const&)>;
  static constexpr std::uint64_t renewal = 400; ///< steps

  /// @param adaptive  ask for the longest step again every `renewal` steps, not only when a stage
  /// starts
  PressProgramme(std::vector<Stage> stages, PunchFaces faces, LongestStep longest_step,
                 bool adaptive, FrameLaw frame = {});

  bool is_done() const { return index_ == stages_.size(); }
  bool is_started() const { return started_ != 0; }
  std::uint64_t index() const { return index_; }
  Stage const& stage() const { return stages_.at(index_); }
  std::span<Stage const> stages() const { return stages_; }
  PunchFaces const& faces() const { return faces_; }
  PressFrame const& frame() const { return frame_; }

  /// Distance of the punch faces as the machine commands it [m]: less than punch_gap() by what the
  /// frame gives.
  double commanded_gap(dem::World const& world) const;

  /// Does what the present stage does at its start: tools are released, driven or stopped, the
  /// steps planned.
  /// @throws dem::PhysicsGuard if the stage's limit cannot be reached from here
  void start_stage(dem::World& world);

  /// Whether the present stage has ended. @throws dem::PhysicsGuard if it can no longer end as the
  /// case asks
  bool stage_has_ended(dem::World const& world) const;

  /// Sets the tools' velocities for the next step. @returns its length [s]
  double command_step(dem::World& world);

  /// Counts the step that has been made; on the last of a plan the time is set to the planned end.
  void step_done(dem::World& world);

  /// Plans the rest of the stage anew: the grains allow another step.
  void renew_plan(dem::World const& world) { plan_steps(world); }

  /// Stops the tools and goes on to the next stage.
  void finish_stage(dem::World& world);

  /// Fraction of the present stage that is done, by time or by force [1].
  double stage_progress(dem::World const& world) const;

  /// Fraction of the whole programme that is done, by the time that stages are expected to take
  /// [1].
  double run_progress(dem::World const& world) const;

  /// Length of the steps of the present plan [s].
  double present_step() const { return step_; }

  /// See dem::visit_state.
  template <class Field> void visit_state(Field&& field) {
    field("programme/stage", index_);
    field("programme/started", started_);
    field("programme/stage_start", stage_start_);
    field("programme/stage_end", stage_end_);
    field("programme/step", step_);
    field("programme/steps_to_end", steps_to_end_);
    field("programme/steps_to_renewal", steps_to_renewal_);
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      if (stages_[k].kind != StageKind::follow)
        continue;
      // The path as the run began with it, whatever has become of its file.
      std::string const at = "programme/path_" + std::to_string(k);
      field(at + "_time", stages_[k].path.time);
      field(at + "_gap", stages_[k].path.gap);
    }
    servo_.visit_state(field);
    frame_.visit_state(field);
  }

private:
  void plan_steps(dem::World const& world);
  double planned_length(dem::World const& world) const;
  double length_until(double distance, double rate, std::string_view aim) const;
  bool force_reached(dem::World const& world) const;

  std::vector<Stage> stages_;
  PunchFaces faces_;
  LongestStep longest_step_;
  bool adaptive_;
  std::vector<double> expected_lengths_; // [s], of the stages

  std::uint64_t index_ = 0;
  std::uint64_t started_ = 0;
  double stage_start_ = 0.0;       // [s]
  double stage_end_ = 0.0;         // [s]; infinite where only a force ends the stage
  double step_ = 0.0;              // [s]
  std::uint64_t steps_to_end_ = 0; // 0 with an infinite end: unknown
  std::uint64_t steps_to_renewal_ = 0;
  ForceServo servo_;
  PressFrame frame_;
};

} // namespace coupling
