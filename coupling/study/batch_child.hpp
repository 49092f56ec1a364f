#pragma once

#include "coupling/study/batch_folder.hpp"

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coupling::study {

/// A run in a process of its own, which dies with this one and keeps the run's lock while it lives.
class BatchChild {
public:
  /// Starts this program with other arguments; what it says goes to the run's log.
  /// @throws std::runtime_error if there can be no further process
  BatchChild(StudyRun const& run, FileLock lock, std::vector<std::string> const& arguments,
             std::filesystem::path const& log);

  /// How the process ended, or nothing while it lives.
  struct End {
    int status;         ///< exit status, or 128 + signal
    double cpu_seconds; ///< user and system
    double wall_seconds;
  };
  std::optional<End> poll();

  void signal(int number) const;
  StudyRun const& run() const { return *run_; }

private:
  StudyRun const* run_;
  FileLock lock_;
  pid_t process_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// The last line of a log that says something; empty if there is none.
std::string last_line(std::filesystem::path const& log);

/// The fraction of a run that its log tells of last [1].
double logged_fraction(std::filesystem::path const& log);

} // namespace coupling::study
