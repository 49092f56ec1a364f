#pragma once

#include "coupling/progress.hpp"
#include "coupling/study/batch_child.hpp"

#include <iosfwd>
#include <list>

namespace coupling::study {

/// What the view tells.
struct BatchReading {
  std::size_t n_runs, n_done, n_failed, n_waiting, n_elsewhere;
  double seconds_left; ///< below 0: not known
};

/// How far a batch is: on a terminal one line that rewrites itself, otherwise a line for each run
/// that ends.
class BatchView {
public:
  BatchView(std::ostream& out, ProgressStyle style) : out_(out), style_(style) {}

  /// Whether show() would print: readings look at every run.
  bool is_due() const;

  void show(BatchReading const& now, std::list<BatchChild> const& children,
            BatchFolder const& folder);

  /// A run has ended. @param sentence  "done in 12 s"
  void tell_end(BatchReading const& now, std::string const& id, std::string const& sentence);

  void finish();

private:
  std::ostream& out_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point last_{};
  bool line_is_open_ = false;
};

} // namespace coupling::study
