#include "coupling/progress.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <ostream>

namespace coupling {
namespace {

constexpr auto terminal_pause = std::chrono::milliseconds(500);
constexpr double rounding = 1e-9;

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

} // namespace

std::string write_duration(double seconds) {
  auto const whole = static_cast<long>(std::min(seconds, 1e7) + 0.5);
  if (whole >= 3600)
    return fmt::format("{} h {:02d} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60)
    return fmt::format("{} min {:02d} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

ProgressStyle progress_style(int file_descriptor, bool quiet) {
  if (quiet)
    return ProgressStyle::silent;
  return isatty(file_descriptor) ? ProgressStyle::terminal : ProgressStyle::lines;
}

Progress::Progress(std::ostream& out, ProgressStyle style) : out_(out), style_(style) {}

bool Progress::is_due(double run_fraction) {
  if (style_ == ProgressStyle::silent)
    return false;
  if (style_ == ProgressStyle::lines)
    return static_cast<int>(20.0 * run_fraction + rounding) > shown_twentieth_;
  return Clock::now() - last_shown_ >= terminal_pause;
}

std::string Progress::describe(ProgressReading const& now) {
  auto const clock = Clock::now();
  double const rate = static_cast<double>(now.step - last_step_) /
                      std::max(seconds_between(last_rate_, clock), 1e-9);
  double const elapsed = seconds_between(started_, clock);
  double const done = now.run_fraction - first_fraction_;
  bool const has_rate = first_fraction_ >= 0.0 && done > 0.0;
  std::string const left =
      has_rate ? write_duration(elapsed * (1.0 - now.run_fraction) / done) : "?";
  if (first_fraction_ < 0.0)
    first_fraction_ = now.run_fraction;
  last_rate_ = clock;
  last_step_ = now.step;
  return fmt::format(
      "{:3.0f} %  {} {:3.0f} %  t = {:.5f} s  height {:.3f} mm  force {:.1f} N  overlap {:.1f} %  "
      "{:.0f} steps/s  {} left",
      100.0 * now.run_fraction, now.stage, 100.0 * now.stage_fraction, now.time, 1e3 * now.height,
      now.force, 100.0 * now.max_relative_overlap, has_rate ? rate : 0.0, left);
}

void Progress::show(ProgressReading const& now) {
  if (style_ == ProgressStyle::silent)
    return;
  std::string const line = describe(now);
  shown_twentieth_ = static_cast<int>(20.0 * now.run_fraction + rounding);
  last_shown_ = Clock::now();
  if (style_ == ProgressStyle::lines) {
    out_ << line << std::endl;
    return;
  }
  out_ << '\r' << line << "\033[K" << std::flush;
  line_is_open_ = true;
}

void Progress::finish() {
  if (line_is_open_)
    out_ << std::endl;
  line_is_open_ = false;
}

} // namespace coupling
