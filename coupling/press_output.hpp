#pragma once

#include "coupling/press.hpp"
#include "coupling/record/vtu.hpp"

#include <filesystem>
#include <string>

namespace coupling {

/// Refuses a folder that cannot be written or holds something already, before anything is
/// calculated.
/// @param overwrite  allow a folder that is not empty
/// @throws dem::InvalidInput
void check_run_folder(std::filesystem::path const& folder, bool overwrite);

/// Makes the folder if need be and removes what an earlier run left in it; foreign files stay.
/// @throws dem::InvalidInput
void clear_run_folder(std::filesystem::path const& folder);

/// The folder that holds a run's results (see coupling/README.md for its files).
class RunFolder {
public:
  /// @param time  [s], of the state from which the run goes on; later snapshots of an earlier
  /// attempt are forgotten
  RunFolder(std::filesystem::path folder, double time);

  std::filesystem::path const& path() const { return folder_; }

  /// The case as understood and the tools' surfaces.
  void write_inputs(Press const& press) const;

  /// Grains and tools for ParaView, and a frame of run.h5; once for each time.
  void write_snapshot(Press& press);

  /// Displacement and stress of every elastic tool that is there, under the mean loads of the last
  /// window; a frame of TOOL_stress.pvd.
  void write_tool_stresses(Press const& press) const;

  /// A rolling restart; the two newest are kept.
  std::filesystem::path write_restart(Press& press);

  /// The restart of a stage that has just ended.
  std::filesystem::path write_stage_restart(Press& press, std::string const& stage);

  /// curves.csv as far as the run has come.
  void write_curves(Press const& press) const;

  /// curves.csv, summary.json, run.h5 and report.html.
  void write_results(Press const& press) const;

  /// Newest restart of this folder in words, for messages: a file, or that there is none yet.
  std::string last_restart() const;

private:
  std::filesystem::path folder_;
  PvdSeries grains_;
  PvdSeries tools_;
};

/// report.html of a press.
void write_press_report(Press const& press, std::filesystem::path const& file);

} // namespace coupling
