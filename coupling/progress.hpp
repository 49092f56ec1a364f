#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace coupling {

/// What a line of progress tells.
struct ProgressReading {
  std::string stage;
  double stage_fraction;       ///< [1], of the present stage
  double run_fraction;         ///< [1], of the whole programme, by time
  double time;                 ///< [s], simulated
  double height;               ///< [m], between the punches
  double force;                ///< [N], on the upper punch
  double max_relative_overlap; ///< [1]
  std::uint64_t step;
};

enum class ProgressStyle { silent, lines, terminal };

/// `1 h 05 min`, `3 min 20 s`, `7 s`.
std::string write_duration(double seconds);

/// `terminal` if the file descriptor is one, otherwise `lines`; `silent` if asked for.
ProgressStyle progress_style(int file_descriptor, bool quiet);

/// Tells how far a run is: on a terminal one line that rewrites itself twice a second, in a file a
/// line per 5 %.
class Progress {
public:
  Progress(std::ostream& out, ProgressStyle style);

  /// Whether show() would print: cheap, so that readings are made only when needed.
  bool is_due(double run_fraction);

  void show(ProgressReading const& now);

  /// Ends the line that rewrites itself.
  void finish();

private:
  using Clock = std::chrono::steady_clock;
  std::string describe(ProgressReading const& now);

  std::ostream& out_;
  ProgressStyle style_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point last_shown_{};
  Clock::time_point last_rate_ = started_;
  std::uint64_t last_step_ = 0;
  double first_fraction_ = -1.0; // where this session took up the run
  int shown_twentieth_ = -1;
  bool line_is_open_ = false;
};

} // namespace coupling
