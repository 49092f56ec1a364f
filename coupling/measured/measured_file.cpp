#include "coupling/measured/measured_file.hpp"

#include "coupling/measured/channel_kinds.hpp"
#include "coupling/measured/json_values.hpp"
#include "coupling/measured/layout_entries.hpp"
#include "coupling/nearest_name.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coupling::measured {
namespace {

using Kind = PlacedJson::Kind;
using Names = std::vector<std::string>;

Sample read_sample(PlacedJson const& object) {
  static Names const known = {"mass", "die_diameter", "solid_density"};
  check_members(object, known);
  auto const value = [&](std::string const& name, Physical physical, std::string_view why) {
    auto const& node = needed(object, name, why);
    auto const read = uncertain_of(node, physical);
    if (!(read.value > 0.0))
      node.find("value")->refuse("is not positive (there is something to press). Is the sign "
                                 "wrong?");
    return read;
  };
  Sample sample{.mass = value("mass", Physical::mass, "the powder in the die"),
                .die_diameter = value("die_diameter", Physical::length, "forces act on its area")};
  if (object.find("solid_density") != nullptr)
    sample.solid_density = value("solid_density", Physical::density, "of the grains");
  return sample;
}

Channel read_channel(std::string const& name, PlacedJson const& object) {
  static Names const known = {"unit", "sd", "sd_relative"};
  static Names const with_unit = {"sd"};
  check_members(object, known);
  auto const& kind = *find_kind(channel_kinds(), name);
  auto const* const sd = object.find("sd");
  if (sd == nullptr)
    object.refuse("has no uncertainty (without it nobody can say what departs from what). Add "
                  "\"sd\", the standard uncertainty of a reading?");
  Channel channel{.name = name,
                  .unit = std::string(describe(kind.physical).si),
                  .sd = quantity_of(*sd, kind.physical, unit_of(object, with_unit))};
  if (!(channel.sd > 0.0))
    sd->refuse("is not positive (a reading without error would outweigh all others). State the "
               "standard uncertainty?");
  if (auto const* const relative = object.find("sd_relative")) {
    channel.sd_relative = quantity_of(*relative, Physical::ratio);
    if (!(channel.sd_relative >= 0.0 && channel.sd_relative < 1.0))
      relative->refuse("is no share of a reading (0 to below 1). Is it in per cent?");
  }
  return channel;
}

std::vector<Channel> read_channels(PlacedJson const& object) {
  check_members(object, names_of(channel_kinds()));
  for (auto const* const name : {"punch_gap", "upper_punch_force"})
    needed(object, name, "every run has it, and without its uncertainty it says nothing");
  std::vector<Channel> channels;
  for (auto const& kind : channel_kinds()) // in the table's order, however they were written
    if (auto const* const node = object.find(kind.name))
      channels.push_back(read_channel(std::string(kind.name), *node));
  return channels;
}

PressProtocol read_press(PlacedJson const& object) {
  static Names const known = {"speed_down", "speed_up", "end_gap", "fill_height", "dwell", "unit"};
  check_members(object, known);
  if (auto const* const unit = object.find("unit"); unit && unit->text != "SI")
    unit->refuse("is not 'SI' (bare numbers are SI; others carry their units, as \"1 mm/min\"). "
                 "Write the values as texts with units?");
  auto const value = [&](std::string const& name, Physical physical, std::string_view why) {
    return positive_of(needed(object, name, why), physical);
  };
  PressProtocol press{
      .speed_down = value("speed_down", Physical::speed, "how fast the punch closes"),
      .speed_up = value("speed_up", Physical::speed, "how fast the punch opens"),
      .end_gap = value("end_gap", Physical::length, "where the closing ends"),
      .fill_height = value("fill_height", Physical::length, "height of the filled bed"),
      .dwell = {}};
  if (press.end_gap >= press.fill_height)
    object.find("end_gap")->refuse(fmt::format(
        "is not below fill_height = {} m (pressing closes the gap). Are the two swapped?",
        press.fill_height));
  if (auto const* const dwell = object.find("dwell")) {
    press.dwell = quantity_of(*dwell, Physical::time);
    if (*press.dwell < 0.0)
      dwell->refuse("is negative (a dwell lasts). Is the sign wrong?");
  }
  return press;
}

std::map<std::string, Uncertain> read_scalars(PlacedJson const& object) {
  check_members(object, names_of(scalar_kinds()));
  std::map<std::string, Uncertain> scalars;
  for (auto const& [name, node] : object.members)
    scalars[name] = uncertain_of(node, find_kind(scalar_kinds(), name)->physical);
  return scalars;
}

/// The run's curve, or a name where single numbers alone are known.
PlacedJson const& file_or_name(PlacedJson const& object) {
  auto const *const file = object.find("file"), *const name = object.find("name");
  if (file && name)
    name->refuse("stands beside a file (a run with a curve has the file's name). Remove one?");
  return name ? *name
              : needed(object, "file", "the run's curve; of single numbers alone give a \"name\"");
}

RunEntry read_run(PlacedJson const& object, LabLayout const& layout, ClockChoice const& clock) {
  static Names const known = [] {
    Names names = {"file", "name", "role", "press", "scalars", "position_file"};
    names.insert(names.end(), layout_entries().begin(), layout_entries().end());
    return names;
  }();
  static Names const roles = {"fit", "held-out"};
  check_members(object, known);
  RunEntry entry{
      .run = {.file = text_of(file_or_name(object)),
              .role = choice_of(needed(object, "role", "fit or held-out"), roles) == 0
                          ? Role::fit
                          : Role::held_out,
              .press = read_press(needed(object, "press", "what the press was told to do"))},
      .where = fmt::format("{}:{}: {}", object.file, object.line, object.path),
      .has_file = object.find("file") != nullptr,
      .position_file = {},
      .layout = layout,
      .clock = clock};
  if (auto const* const scalars = object.find("scalars"))
    entry.run.scalars = read_scalars(*scalars);
  if (auto const* const position = object.find("position_file"))
    entry.position_file = text_of(*position);
  read_layout(object, entry.layout, entry.clock);
  return entry;
}

/// Decisions of an earlier reading, each a text, or an object with file and row.
std::vector<Decision> read_decisions(PlacedJson const& list) {
  static Names const known = {"file", "row", "what"};
  if (!list.is(Kind::list))
    list.refuse("is no list (decisions of an earlier reading). Remove it?");
  std::vector<Decision> decisions;
  for (auto const& item : list.items) {
    check_members(item, known);
    Decision decision{.file = {}, .what = text_of(needed(item, "what", "the decision in words"))};
    if (auto const* const file = item.find("file"))
      decision.file = text_of(*file);
    if (auto const* const row = item.find("row")) {
      double const number = quantity_of(*row, Physical::ratio);
      if (!(number >= 1.0 && number < 1e15 && number == std::floor(number)))
        row->refuse("is no row (rows count from 1). Remove it?");
      decision.row = static_cast<std::size_t>(number);
    }
    decisions.push_back(std::move(decision));
  }
  return decisions;
}

} // namespace

MeasuredFile parse_measured_file(std::string_view text, std::string const& name) {
  static Names const known = [] {
    Names names = {"sample", "channels", "gap_source", "runs", "decisions"};
    names.insert(names.end(), layout_entries().begin(), layout_entries().end());
    return names;
  }();
  static Names const sources = {"commanded", "measured"};
  VALIDATE(!text.empty(), fmt::format("{}: is empty (it describes the sample, the channels and the "
                                      "runs). Was its writing interrupted?",
                                      name));
  auto const json = parse_placed_json(text, name);
  check_members(json, known);
  LabLayout layout;
  ClockChoice clock;
  read_layout(json, layout, clock);
  MeasuredFile file{
      .sample = read_sample(needed(json, "sample", "what was pressed")),
      .channels = read_channels(needed(json, "channels", "what was read, and how well")),
      .gap_source = static_cast<GapSource>(choice_of(
          needed(json, "gap_source", "commanded, or measured at the punch faces"), sources)),
      .runs = {},
      .decisions = {}};
  auto const& runs = needed(json, "runs", "the pressings");
  if (!runs.is(Kind::list) || runs.items.empty())
    runs.refuse("is no list of runs, or an empty one (nothing was measured). Is it the right "
                "file?");
  for (auto const& run : runs.items)
    file.runs.push_back(read_run(run, layout, clock));
  if (auto const* const decisions = json.find("decisions"))
    file.decisions = read_decisions(*decisions);
  return file;
}

} // namespace coupling::measured
