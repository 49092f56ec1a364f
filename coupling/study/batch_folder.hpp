#pragma once

#include "coupling/study/run_cost.hpp"
#include "coupling/study/study_plan.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coupling::study {

enum class RunState { waiting, running, done, stopped, failed };

/// "done", "stopped", ...
char const* word(RunState state);

/// How a run ended, as kept in its folder.
struct RunRecord {
  std::string hash; ///< of the case that ran
  RunState state = RunState::waiting;
  int exit_status = 0; ///< 128 + signal where a signal ended it
  std::string reason;  ///< of a failure: the last line of its log
  int attempts = 0;
  double cpu_seconds = 0.0;  ///< of all attempts
  double wall_seconds = 0.0; ///< of all attempts
};

/// Holds a lock as long as it lives, or as long as a child lives that inherited it.
class FileLock {
public:
  FileLock() = default;
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  FileLock(FileLock&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  explicit operator bool() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

private:
  int descriptor_ = -1;
};

/// The files of a study:
///   study.resolved.prm  plan.json  cases/ID.prm  runs/ID/  logs/ID.log  states/ID.json
///   locks/ID.lock  study.lock  results.csv  study.json  analysis.txt  report.html  replaced/
/// All but the logs and the run folders appear complete or not at all.
class BatchFolder {
public:
  explicit BatchFolder(std::filesystem::path const& path);

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path run(std::string const& id) const { return path_ / "runs" / id; }
  std::filesystem::path case_of(std::string const& id) const {
    return path_ / "cases" / (id + ".prm");
  }
  std::filesystem::path log(std::string const& id) const { return path_ / "logs" / (id + ".log"); }

  /// Refuses a folder that cannot be written, holds other things or another study, before anything
  /// is touched.
  /// @param overwrite  take over the folder of another study
  /// @throws dem::InvalidInput
  void check(StudyPlan const& plan, bool overwrite) const;

  /// Makes the folder and writes the plan and the runs' cases. A run whose case has changed moves
  /// to `replaced/`; nothing is deleted. Several programs may do so at once.
  /// @param runs  those of the plan, then those beside the design
  void prepare(StudyFile const& study, std::vector<StudyRun> const& runs,
               std::vector<RunEstimate> const& estimates) const;

  /// Adds runs beside the design.
  void add_cases(std::vector<StudyRun> const& runs) const;

  /// Estimates of an earlier call, for the runs whose case is the same.
  std::vector<std::optional<RunEstimate>> kept_estimates(std::vector<StudyRun> const& runs) const;

  /// What is known of a run: waiting, if there is nothing or its case was another one.
  RunRecord record(StudyRun const& run) const;
  void write_record(StudyRun const& run, RunRecord const& record) const;

  /// The lock of a run; empty if somebody else has it.
  FileLock try_lock(std::string const& id) const;

  /// Whether somebody has the lock of a run at this moment.
  bool is_locked(std::string const& id) const;

private:
  FileLock lock_study() const;

  std::filesystem::path path_;
};

} // namespace coupling::study
