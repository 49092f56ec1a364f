#include "coupling/case_build.hpp"
#include "coupling/case_schema.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling {

namespace {

/// Reads one stage; only what its kind and limit use.
class StageReader {
public:
  StageReader(CaseReader& read, int number)
      : read_(read), at_(fmt::format("Press programme/Stage {}/", number)) {
    stage_.name = read_.words(at_ + "Name");
    if (stage_.name.empty())
      stage_.name = fmt::format("stage {}", number);
    if (stage_.name.size() > 40 || stage_.name.find_first_of(",;\"'/\\<>") != std::string::npos)
      read_.refuse(
          at_ + "Name",
          "is no name (at most 40 bytes, without , ; \" ' / \\ < >). Choose a plainer one?");
  }

  Stage take(std::string const& kind) {
    if (kind == "move")
      move();
    else if (kind == "hold")
      hold();
    else if (kind == "release")
      release();
    else if (kind == "follow")
      follow();
    else
      free();
    read_.refuse_unread(at_, reason(kind));
    return stage_;
  }

private:
  void move() {
    stage_.kind = StageKind::move;
    stage_.tools = needed_tools("a move needs one");
    stage_.speed = read_.number(at_ + "Speed");
    if (stage_.speed == 0.0)
      read_.refuse(at_ + "Speed",
                   "moves nothing. Give it a speed, positive up, or choose Kind = hold?");
    until_ = read_.choice(at_ + "Until");
    stage_.until = until_ == "gap"     ? Limit::gap
                   : until_ == "force" ? Limit::force
                   : until_ == "flush" ? Limit::flush
                                       : Limit::time;
    stage_.duration = read_.number(at_ + "Duration");
    if (stage_.until == Limit::time)
      need_positive("Duration", stage_.duration, "a move until a time needs one");
    if (stage_.until == Limit::gap)
      stage_.gap = needed("Gap", "a move until a gap needs one");
    if (stage_.until == Limit::force)
      stage_.force = needed("Force", "a move until a force needs one");
  }

  void hold() {
    stage_.kind = StageKind::hold;
    stage_.duration = needed("Duration", "a hold needs one");
    stage_.servo = read_.truth(at_ + "Servo");
    stage_.tools = read_.tools(at_ + "Tools");
    if (!stage_.servo)
      return;
    if (stage_.tools.size() != 1 || stage_.tools[0] == "die")
      read_.refuse(at_ + "Tools",
                   "is not the one punch that a servo drives. Name upper_punch or lower_punch?");
    stage_.force = needed("Force", "a servo keeps one");
    // The servo's largest speed; its sign follows from the force.
    stage_.speed = read_.number(at_ + "Speed");
  }

  void release() {
    stage_.kind = StageKind::release;
    stage_.tools = needed_tools("a release removes one");
  }

  void free() {
    stage_.kind = StageKind::free;
    stage_.duration = needed("Duration", "a free stage needs one");
  }

  void follow() {
    stage_.kind = StageKind::follow;
    stage_.tools = needed_tools("one punch follows the gap");
    if (stage_.tools.size() != 1 || stage_.tools[0] == "die")
      read_.refuse(at_ + "Tools",
                   "is not the one punch that follows a gap. Name upper_punch or lower_punch?");
    stage_.follow_file = read_.file(at_ + "Follow file");
    if (stage_.follow_file.empty())
      read_.refuse(at_ + "Follow file", "names no file (Kind = follow needs one). Which?");
    stage_.time_scale = read_.number(at_ + "Time scale");
  }

  void need_positive(std::string const& name, double value, std::string const& why) {
    if (!(value > 0.0))
      read_.refuse(at_ + name, fmt::format("sets no limit ({}). Give it a value above 0?", why));
  }

  double needed(std::string const& name, std::string const& why) {
    double const value = read_.number(at_ + name);
    need_positive(name, value, why);
    return value;
  }

  std::vector<std::string> needed_tools(std::string const& why) {
    std::vector<std::string> tools = read_.tools(at_ + "Tools");
    if (tools.empty())
      read_.refuse(at_ + "Tools", fmt::format("names no tool ({}). Name upper_punch?", why));
    return tools;
  }

  std::string reason(std::string const& kind) const {
    return fmt::format("Kind = {}{}", kind, until_.empty() ? "" : ", Until = " + until_);
  }

  CaseReader& read_;
  std::string at_;
  std::string until_;
  Stage stage_;
};

} // namespace

std::vector<Stage> read_stages(CaseReader& read) {
  std::vector<Stage> stages;
  for (int number = 1; number <= max_stages; ++number) {
    std::string const at = fmt::format("Press programme/Stage {}/", number);
    std::string const kind = read.choice(at + "Kind");
    if (kind == "none") {
      read.refuse_unread(at, fmt::format("stage {} is absent while its Kind is none", number));
      continue;
    }
    Stage const stage = StageReader(read, number).take(kind);
    auto const is_same = [&](Stage const& other) { return other.name == stage.name; };
    if (std::ranges::any_of(stages, is_same))
      read.refuse(at + "Name",
                  "is the name of an earlier stage (results are kept by name). Rename one?");
    stages.push_back(stage);
  }
  if (stages.empty())
    read.refuse("Press programme/Stage 1/Kind",
                "leaves the press programme without a stage (there is nothing to run). "
                "Set it to move?");
  return stages;
}

} // namespace coupling
