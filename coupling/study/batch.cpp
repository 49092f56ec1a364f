#include "coupling/study/batch.hpp"

#include "coupling/record/restart_file.hpp"
#include "coupling/study/batch_view.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <list>
#include <thread>

namespace coupling::study {
namespace {

constexpr auto pause = std::chrono::milliseconds(20);
constexpr auto pause_for_others = std::chrono::milliseconds(200);

/// Ends that say nothing about the case: somebody or the machine stopped the run.
bool was_stopped(int status) {
  return status == 130 || status == 128 + SIGKILL || status == 128 + SIGTERM ||
         status == 128 + SIGINT || status == 128 + SIGHUP;
}

/// Whether a run can go on from where it was: its folder has a whole restart of this case.
bool can_resume(std::filesystem::path const& folder, StudyRun const& run) {
  try {
    return hash_of(newest_restart(folder).header.case_text) == run.hash;
  } catch (dem::InvalidInput const&) {
    return false;
  }
}

class Batch {
public:
  Batch(BatchFolder const& folder, std::vector<StudyRun> const& runs,
        std::vector<RunEstimate> const& estimates, BatchOptions const& options, std::ostream& out)
      : folder_(folder), runs_(runs), estimates_(estimates), options_(options),
        view_(out, options.style) {
    for (std::size_t k = 0; k < runs.size(); ++k)
      open_.push_back((k + options.first) % runs.size());
  }

  BatchOutcome run() {
    while (true) {
      bool const someone_ended = reap();
      if (int const signal = options_.stop ? options_.stop() : 0; signal != 0 && !is_stopping_)
        stop(signal);
      if (!is_stopping_)
        start_what_can_be();
      if (children_.empty() && (is_stopping_ || open_.empty() || !options_.waits))
        break;
      if (view_.is_due())
        view_.show(reading(), children_, folder_);
      if (!someone_ended)
        std::this_thread::sleep_for(children_.empty() ? pause_for_others : pause);
    }
    view_.finish();
    auto outcome = count_runs(folder_, runs_);
    outcome.is_interrupted = is_stopping_;
    return outcome;
  }

private:
  /// Collects children that have ended.
  bool reap() {
    bool any = false;
    for (auto child = children_.begin(); child != children_.end();) {
      auto const end = child->poll();
      if (!end) {
        ++child;
        continue;
      }
      any = true;
      auto const record = record_end(child->run(), *end);
      auto const id = child->run().id;
      auto const& run = child->run();
      children_.erase(child++); // frees its lock
      view_.tell_end(reading(), id, sentence(run, record, *end));
    }
    return any;
  }

  RunRecord record_end(StudyRun const& run, BatchChild::End const& end) {
    auto record = folder_.record(run);
    record.hash = run.hash;
    record.attempts += 1;
    record.cpu_seconds += end.cpu_seconds;
    record.wall_seconds += end.wall_seconds;
    record.exit_status = end.status;
    record.reason.clear();
    record.state = RunState::done;
    if (end.status != 0) {
      record.state = was_stopped(end.status) ? RunState::stopped : RunState::failed;
      record.reason = end.status > 128 && end.status != 130
                          ? fmt::format("ended by signal {}", end.status - 128)
                          : last_line(folder_.log(run.id));
    }
    folder_.write_record(run, record);
    return record;
  }

  std::string sentence(StudyRun const& run, RunRecord const& record,
                       BatchChild::End const& end) const {
    if (record.state == RunState::done)
      return fmt::format("done in {}", write_duration(end.wall_seconds));
    return fmt::format("{} with status {}: {} (log: {})", word(record.state), record.exit_status,
                       record.reason, folder_.log(run.id).string());
  }

  void start_what_can_be() {
    n_elsewhere_ = 0;
    for (auto k = open_.begin(); k != open_.end();) {
      if (children_.size() >= static_cast<std::size_t>(options_.jobs))
        return;
      if (settle(runs_[*k]))
        k = open_.erase(k);
      else {
        ++k;
        ++n_elsewhere_;
      }
    }
  }

  /// Starts a run if it is to be run. @returns false if another process is at it
  bool settle(StudyRun const& run) {
    auto lock = folder_.try_lock(run.id);
    if (!lock)
      return false;
    // Only now: another process may have finished it a moment ago.
    auto const record = folder_.record(run);
    if (record.state == RunState::done || (record.state == RunState::failed && !options_.retries))
      return true;
    children_.emplace_back(run, std::move(lock), arguments_for(run, record), folder_.log(run.id));
    return true;
  }

  std::vector<std::string> arguments_for(StudyRun const& run, RunRecord const& record) const {
    auto const place = folder_.run(run.id);
    auto const threads = fmt::format("{}", options_.threads);
    // A restart that the program itself refused is no way to go on.
    bool const refused = record.state == RunState::failed && record.exit_status == 2;
    if (!refused && can_resume(place, run))
      return {"resume", place.string(), "--threads", threads};
    return {"run",  folder_.case_of(run.id).string(), "-o", place.string(), "--force", "--threads",
            threads};
  }

  /// Asks the children to write their restarts and end. Whoever sent us the signal may have sent it
  /// to them as well, and a second one of the same kind would end them at once: they get the other.
  void stop(int signal) {
    is_stopping_ = true;
    for (auto const& child : children_)
      child.signal(signal == SIGINT ? SIGTERM : SIGINT);
  }

  BatchReading reading() const {
    auto const now = count_runs(folder_, runs_);
    return {.n_runs = runs_.size(),
            .n_done = now.n_done,
            .n_failed = now.n_failed,
            .n_waiting = open_.size() - n_elsewhere_,
            .n_elsewhere = n_elsewhere_,
            .seconds_left = seconds_left()};
  }

  /// From what the finished runs took a particle-step, else from the estimates.
  double seconds_left() const {
    double used = 0.0, expected = 0.0, left = 0.0;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      auto const record = folder_.record(runs_[k]);
      if (record.state == RunState::done) {
        used += record.cpu_seconds;
        expected += estimates_[k].cpu_seconds();
      } else if (record.state != RunState::failed) {
        auto const child =
            std::ranges::find_if(children_, [&](auto const& c) { return &c.run() == &runs_[k]; });
        left += estimates_[k].cpu_seconds() *
                (child == children_.end() ? 1.0 : 1.0 - logged_fraction(folder_.log(runs_[k].id)));
      }
    }
    if (expected > 0.0)
      left *= used / expected;
    return left / (options_.jobs * options_.threads);
  }

  BatchFolder const& folder_;
  std::vector<StudyRun> const& runs_;
  std::vector<RunEstimate> const& estimates_;
  BatchOptions const& options_;
  BatchView view_;
  std::list<std::size_t> open_; // runs that are not settled
  std::list<BatchChild> children_;
  std::size_t n_elsewhere_ = 0;
  bool is_stopping_ = false;
};

} // namespace

BatchOutcome run_batch(BatchFolder const& folder, std::vector<StudyRun> const& runs,
                       std::vector<RunEstimate> const& estimates, BatchOptions const& options,
                       std::ostream& out) {
  return Batch(folder, runs, estimates, options, out).run();
}

BatchOutcome count_runs(BatchFolder const& folder, std::vector<StudyRun> const& runs) {
  BatchOutcome outcome;
  for (auto const& run : runs) {
    auto const state = folder.record(run).state;
    auto& count = state == RunState::done      ? outcome.n_done
                  : state == RunState::failed  ? outcome.n_failed
                  : state == RunState::stopped ? outcome.n_stopped
                                               : outcome.n_waiting;
    ++count;
  }
  return outcome;
}

} // namespace coupling::study
