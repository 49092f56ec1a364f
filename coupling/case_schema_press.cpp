#include "coupling/case_schema_parts.hpp"

#include <fmt/format.h>

namespace coupling::case_entries {

using enum EntryKind;
using enum Physical;

std::vector<Entry> frame_entries() {
  std::string const at = "Press frame/";
  return {
      {at + "Stiffness", quantity, stiffness, "0 N/m", within(0.0, 1e13), "",
       "Stiffness of the machine between command and upper punch; 0: rigid."},
      {at + "Seating", quantity, length, "0 mm", within(0.0, 0.01), "",
       "What the machine's joints give in all, on top of its stiffness, until they are seated."},
      {at + "Seating force", quantity, force, "0 N", within(0.0, 1e7), "",
       "Force scale F_s of that: seating (1 - exp(-F / F_s))."},
      {at + "Gap offset", quantity, length, "0 mm", within(-0.01, 0.01), "",
       "How much further apart the punch faces are than the machine takes them to be."},
      {at + "Thermal drift", quantity, speed, "0 m/s", within(-1.0, 1.0), "",
       "Growth of that in time, as the frame warms."},
  };
}

std::vector<Entry> load_cell_entries() {
  std::string const at = "Load cell/";
  return {
      {at + "Gain", quantity, ratio, "1", above_up_to(0.0, 10.0), "",
       "What the load cell on the upper punch shows (upper_punch_reading) of each newton."},
      {at + "Offset", quantity, force, "0 N", within(-1e7, 1e7), "", "What it shows unloaded."},
      {at + "Drift", quantity, force_rate, "0 N/s", within(-1e9, 1e9), "",
       "Growth of that in time."},
      {at + "Time constant", quantity, time, "0 s", within(0.0, 1e3), "",
       "Lag of the reading behind the force, of first order."},
  };
}

namespace {

/// Defaults of the seed's press cycle: down to 8 mm in 0.06 s, up for 0.04 s, die and punch
/// removed, 0.05 s free.
struct StageDefaults {
  char const *kind, *name, *tools, *speed, *until, *duration, *gap;
};

StageDefaults stage_defaults(int number) {
  switch (number) {
  case 1:
    return {"move", "loading", "upper_punch", "-0.2 m/s", "gap", "0 s", "8 mm"};
  case 2:
    return {"move", "unloading", "upper_punch", "0.2 m/s", "gap", "0 s", "16 mm"};
  case 3:
    return {"release", "release", "die, upper_punch", "0 m/s", "time", "0 s", "0 mm"};
  case 4:
    return {"free", "relaxation", "", "0 m/s", "time", "0.05 s", "0 mm"};
  default:
    return {"none", "", "", "0 m/s", "time", "0 s", "0 mm"};
  }
}

} // namespace

std::vector<Entry> stage_entries(int number) {
  StageDefaults const stage = stage_defaults(number);
  std::string const at = fmt::format("Press programme/Stage {}/", number);
  return {
      {at + "Kind", choice, ratio, stage.kind, any, "none | move | hold | release | free | follow",
       "move the tools, hold them, release (remove) them, drive nothing, or follow a measured gap; "
       "none: no such stage."},
      {at + "Name", text, ratio, stage.name, any, "",
       "Name of the stage; empty: stage and its number."},
      {at + "Tools", tools, ratio, stage.tools, any, "",
       "Tools that move, are held at a force, or are released."},
      {at + "Speed", quantity, speed, stage.speed, within(-1e3, 1e3), "",
       "Speed of a move, positive up."},
      {at + "Until", choice, ratio, stage.until, any, "time | gap | force | flush",
       "What ends a move; flush: the face of the lower punch is level with the die's rim."},
      {at + "Duration", quantity, time, stage.duration, within(0.0, 1e6), "",
       "Length of the stage; for another limit the longest it may take (0: no bound)."},
      {at + "Gap", quantity, length, stage.gap, within(0.0, 2.0), "",
       "Gap between the punch faces that ends a move."},
      {at + "Force", quantity, force, "0 N", within(0.0, 1e9), "",
       "Force on the tool that ends a move or is held."},
      {at + "Servo", truth, ratio, "false", any, "", "Hold: keep Force instead of the position."},
      {at + "Follow file", file, ratio, "", any, "",
       "Follow: CSV with the columns time and punch_gap, the punch faces' distance as measured."},
      {at + "Time scale", quantity, ratio, "1", above_up_to(0.0, 1e6), "",
       "Follow: simulated time over measured time; below 1 the press runs faster than measured."},
  };
}

} // namespace coupling::case_entries
