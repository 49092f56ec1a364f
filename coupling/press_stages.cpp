#include "coupling/gap_path.hpp"
#include "coupling/press_programme.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace coupling {
namespace {

constexpr std::array<std::string_view, 3> known_tools{"die", "upper_punch", "lower_punch"};
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(Stage const& stage, std::string const& problem) {
  throw dem::InvalidInput(fmt::format("stage '{}': {}", stage.name, problem));
}

/// Walks through the programme as the case describes it, before anything runs.
class StageWalk {
public:
  explicit StageWalk(double fill_height) : gap_(fill_height) {}

  void take(Stage const& stage) {
    if (!names_.insert(stage.name).second)
      refuse(stage, "this name is used twice (results are kept by stage). Rename it?");
    check_tools(stage);
    switch (stage.kind) {
    case StageKind::move:
      return move(stage);
    case StageKind::hold:
      return hold(stage);
    case StageKind::release:
      return release(stage);
    case StageKind::free:
      return check_duration(stage);
    case StageKind::follow:
      return follow(stage);
    }
  }

private:
  void check_tools(Stage const& stage) const {
    bool const needs_tools =
        stage.kind != StageKind::free && (stage.kind != StageKind::hold || stage.servo);
    if (needs_tools && stage.tools.empty())
      refuse(stage, "it names no tool. Which of die, upper_punch, lower_punch?");
    for (auto const& tool : stage.tools) {
      if (std::ranges::count(known_tools, tool) == 0)
        refuse(stage,
               fmt::format(
                   "tool '{}' is unknown (known: die, upper_punch, lower_punch). Is it misspelt?",
                   tool));
      if (released_.contains(tool))
        refuse(stage,
               fmt::format("tool '{}' was released by an earlier stage. Release it later?", tool));
    }
  }

  void check_duration(Stage const& stage) const {
    if (!(stage.duration > 0.0) || !std::isfinite(stage.duration))
      refuse(stage, fmt::format("a duration of {:.6g} s ends it before it starts. Give it a time?",
                                stage.duration));
  }

  void move(Stage const& stage) {
    if (stage.speed == 0.0 || !std::isfinite(stage.speed))
      refuse(stage, "a motion needs a speed other than 0. Is it a hold?");
    if (stage.until == Limit::flush)
      return eject(stage);
    if (stage.until != Limit::gap) {
      if (stage.until == Limit::time)
        check_duration(stage);
      bool const is_timed = stage.until == Limit::time;
      return move_gap(stage, is_timed ? gap_ + gap_rate(stage) * stage.duration : unknown);
    }
    if (gap_rate(stage) == 0.0)
      refuse(stage, "the punches do not approach each other (it moves both or none). Limit its "
                    "time instead?");
    if ((stage.gap - gap_) * gap_rate(stage) < 0.0)
      refuse(stage, fmt::format("a speed of {:.6g} m/s leads away from the gap of {:.6g} m (it "
                                "starts at {:.6g} m). Turn the "
                                "speed's sign?",
                                stage.speed, stage.gap, gap_));
    move_gap(stage, stage.gap);
  }

  void eject(Stage const& stage) {
    if (!(ejection_rate(stage) > 0.0))
      refuse(stage, "it brings the lower punch no nearer to the die's rim. Move lower_punch up, or "
                    "the die down?");
    if (gap_rate(stage) < 0.0 && !released_.contains("upper_punch"))
      refuse(stage, "the upper punch is in the compact's way. Release it first?");
    gap_ = unknown;
  }

  void move_gap(Stage const& stage, double gap) {
    if (released_.contains("upper_punch") || released_.contains("lower_punch"))
      gap = unknown;
    if (gap <= 0.0)
      refuse(stage, fmt::format("the punches meet (gap {:.6g} m at its end, {:.6g} m at its "
                                "start). Shorten the stroke?",
                                gap, gap_));
    gap_ = gap;
  }

  void hold(Stage const& stage) {
    check_duration(stage);
    if (!stage.servo)
      return;
    if (stage.tools.front() == "die")
      refuse(stage, "a servo drives a punch, not the die. Which punch?");
    if (!(stage.force > 0.0))
      refuse(stage, fmt::format("a servo needs a force above 0 N, not {:.6g} N", stage.force));
    gap_ = unknown;
  }

  void follow(Stage const& stage) {
    if (stage.path.gap.empty()) { // its file has not been read yet
      gap_ = unknown;
      return;
    }
    check_duration(stage);
    double const first = stage.path.gap.front();
    if (std::abs(first - gap_) > path_start_tolerance)
      refuse(stage, fmt::format("its path starts at a gap of {:.6g} m, but the punches will stand "
                                "{:.6g} m apart. Move them there in a stage before?",
                                first, gap_));
    gap_ = stage.path.gap.back();
  }

  void release(Stage const& stage) { released_.insert(stage.tools.begin(), stage.tools.end()); }

  double gap_; // [m]; NaN once a force decides
  std::set<std::string> names_;
  std::set<std::string, std::less<>> released_;
};

} // namespace

bool drives(Stage const& stage, std::string_view tool) {
  return std::ranges::count(stage.tools, tool) > 0;
}

double gap_rate(Stage const& stage) {
  return stage.speed * (int(drives(stage, "upper_punch")) - int(drives(stage, "lower_punch")));
}

double ejection_rate(Stage const& stage) {
  return stage.speed * (int(drives(stage, "lower_punch")) - int(drives(stage, "die")));
}

void validate_stages(std::span<Stage const> stages, double fill_height) {
  VALIDATE(
      !stages.empty(),
      "the press programme has no stage (there is nothing to run). Add a stage such as 'loading'?");
  StageWalk walk(fill_height);
  for (Stage const& stage : stages)
    walk.take(stage);
}

std::vector<double> expected_lengths(std::span<Stage const> stages, double fill_height) {
  std::vector<double> lengths;
  double gap = fill_height;
  for (Stage const& stage : stages) {
    double const rate = stage.kind == StageKind::move ? gap_rate(stage) : 0.0;
    double length = stage.kind == StageKind::release ? 0.0 : stage.duration;
    if (rate != 0.0 && stage.until == Limit::gap)
      length = std::max((stage.gap - gap) / rate, 0.0);
    if (rate != 0.0 && stage.until == Limit::force && length == 0.0)
      length = gap / std::abs(rate);
    if (stage.until == Limit::flush && length == 0.0)
      length = fill_height / ejection_rate(stage);
    gap = stage.kind == StageKind::follow ? stage.path.gap.back()
                                          : std::max(gap + rate * length, 0.0);
    lengths.push_back(length);
  }
  return lengths;
}

} // namespace coupling
