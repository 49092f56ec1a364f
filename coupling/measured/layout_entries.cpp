#include "coupling/measured/layout_entries.hpp"

#include "coupling/measured/channel_kinds.hpp"
#include "coupling/measured/json_values.hpp"

namespace coupling::measured {
namespace {

using Names = std::vector<std::string>;

void read_columns(PlacedJson const& object, LabLayout& layout) {
  static Names const known = [] {
    Names names = names_of(channel_kinds());
    names.insert(names.begin(), "time");
    names.emplace_back("position_time");
    return names;
  }();
  static Names const parts = {"name", "unit", "at_zero"};
  check_members(object, known);
  for (auto const& [channel, node] : object.members) {
    ColumnChoice choice;
    if (node.is(PlacedJson::Kind::text)) {
      choice.name = text_of(node);
    } else {
      check_members(node, parts);
      choice.name = text_of(needed(node, "name", "the column's name in the file's header"));
      if (auto const* const unit = node.find("unit"))
        choice.unit = text_of(*unit);
      if (auto const* const at_zero = node.find("at_zero")) {
        if (channel != "punch_gap")
          at_zero->refuse("belongs to punch_gap (it turns a travel into a gap). Remove it?");
        choice.at_zero = quantity_of(*at_zero, Physical::length);
      }
    }
    layout.columns[channel] = choice;
  }
}

void read_clock(PlacedJson const& object, LabLayout& layout, ClockChoice& clock) {
  static Names const known = {"align", "shift", "sd", "interval"};
  static Names const ways = {"common", "stated", "first_contact", "turning_point"};
  check_members(object, known);
  if (auto const* const align = object.find("align")) {
    clock.align = static_cast<Alignment>(choice_of(*align, ways));
    clock.is_stated = true;
  }
  bool const is_given = clock.is_stated && clock.align <= Alignment::stated;
  if (auto const* const interval = object.find("interval"))
    layout.interval = positive_of(*interval, Physical::time);
  if (auto const* const shift = object.find("shift")) {
    if (clock.align != Alignment::stated || !clock.is_stated)
      shift->refuse("is not used (align is not 'stated'). Set align to stated, or remove it?");
    clock.shift = quantity_of(*shift, Physical::time);
  }
  if (clock.align == Alignment::stated && clock.is_stated) {
    needed(object, "shift", "what is added to the position's time");
    if (object.find("sd") == nullptr)
      object.find("shift")->refuse("has no uncertainty (a stated shift is a measured value). Add "
                                   "\"sd\"?");
  }
  if (auto const* const sd = object.find("sd")) {
    if (clock.is_stated && !is_given)
      sd->refuse("is not used (the alignment finds its own). Remove it?");
    clock.sd = positive_of(*sd, Physical::time);
  }
}

} // namespace

std::vector<std::string> const& layout_entries() {
  static Names const names = {"columns", "decimal_mark", "clock"};
  return names;
}

void read_layout(PlacedJson const& object, LabLayout& layout, ClockChoice& clock) {
  static Names const marks = {".", ","};
  if (auto const* const columns = object.find("columns"))
    read_columns(*columns, layout);
  if (auto const* const mark = object.find("decimal_mark"))
    layout.decimal_mark = marks[choice_of(*mark, marks)];
  if (auto const* const own = object.find("clock")) {
    clock = {};
    read_clock(*own, layout, clock);
  }
}

} // namespace coupling::measured
