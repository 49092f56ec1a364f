#pragma once

#include "coupling/press.hpp"
#include "coupling/press_output.hpp"
#include "coupling/progress.hpp"

#include <chrono>
#include <functional>
#include <string>

namespace coupling {

enum class RunEnd { finished, stage_reached, interrupted };

/// A press cycle from where the press stands to its end.
class PressCycle {
public:
  using StopRequest = std::function<bool()>;

  /// @param stop_is_requested  asked after every step; true writes a restart and ends the run as
  /// interrupted
  PressCycle(Press& press, RunFolder& folder, Progress& progress, StopRequest stop_is_requested);

  /// Runs the stages; records, guards, snapshots and restarts on the way.
  /// @param last_stage  stop at its end; empty = run all
  /// @throws dem::PhysicsGuard if the result can no longer be trusted, or a stage cannot end
  RunEnd run(std::string const& last_stage);

private:
  void begin();
  void start_stage();
  void step();
  void keep_peak();
  void record_if_due();
  void save_if_due();
  void write_stress_if_due();
  void finish_stage();
  void conclude();

  void record();
  void show_progress();
  void keep_clock();

  using Clock = std::chrono::steady_clock;
  Press& press_;
  RunFolder& folder_;
  Progress& progress_;
  StopRequest stop_is_requested_;
  Clock::time_point clock_ = Clock::now();
  Clock::time_point last_restart_ = clock_;
};

} // namespace coupling
