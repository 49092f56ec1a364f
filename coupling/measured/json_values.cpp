#include "coupling/measured/json_values.hpp"

#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coupling::measured {

using Kind = PlacedJson::Kind;

void check_members(PlacedJson const& object, std::span<std::string const> known) {
  if (!object.is(Kind::object))
    object.refuse(
        fmt::format("is no object (it holds: {}). Write it in braces?", fmt::join(known, ", ")));
  for (auto const& [name, member] : object.members)
    if (std::ranges::find(known, name) == known.end())
      member.refuse(fmt::format("is no entry of measured data (known here: {}).{}",
                                fmt::join(known, ", "), did_you_mean(name, known, "Remove it?")));
}

PlacedJson const& needed(PlacedJson const& object, std::string const& name, std::string_view why) {
  auto const* const member = object.find(name);
  if (member == nullptr)
    throw dem::InvalidInput(fmt::format("{}:{}: {}{}{} is missing ({}). Add it?", object.file,
                                        object.line, quote(object.path),
                                        object.path.empty() ? "" : "/", name, why));
  return *member;
}

std::string text_of(PlacedJson const& node) {
  if (!node.is(Kind::text) || node.text.empty())
    node.refuse("is no text (words in quotes are needed). Write \"...\"?");
  return node.text;
}

std::size_t choice_of(PlacedJson const& node, std::span<std::string const> choices) {
  auto const found = std::ranges::find(choices, node.text);
  if (!node.is(Kind::text) || found == choices.end())
    node.refuse(fmt::format("is none of the choices ({}).{}", fmt::join(choices, " | "),
                            did_you_mean(node.text, choices, "Choose one of them?")));
  return static_cast<std::size_t>(found - choices.begin());
}

double quantity_of(PlacedJson const& node, Physical physical, std::string const& unit) {
  if (!node.is(Kind::number) && !node.is(Kind::text))
    node.refuse(fmt::format("is no number ({} is needed). Write a number, or a text such as "
                            "\"1 {}\"?",
                            describe(physical).words, describe(physical).si));
  try {
    return parse_quantity(
        node.is(Kind::number) && !unit.empty() ? node.text + " " + unit : node.text, physical);
  } catch (dem::InvalidInput const& problem) {
    node.refuse(problem.what());
  }
}

double positive_of(PlacedJson const& node, Physical physical, std::string const& unit) {
  double const value = quantity_of(node, physical, unit);
  if (!(value > 0.0))
    node.refuse(fmt::format("is not positive ({} here is more than zero). Is the sign wrong?",
                            describe(physical).words));
  return value;
}

std::string unit_of(PlacedJson const& object, std::span<std::string const> numbers) {
  if (auto const* const unit = object.find("unit"))
    return text_of(*unit);
  for (auto const& name : numbers)
    if (auto const* const number = object.find(name); number && number->is(Kind::number))
      number->refuse("has no unit (a measured number without unit means nothing). Add \"unit\"?");
  return "";
}

Uncertain uncertain_of(PlacedJson const& object, Physical physical) {
  static std::vector<std::string> const members = {"value", "sd", "unit"};
  check_members(object, members);
  needed(object, "value", "what was measured");
  if (object.find("sd") == nullptr)
    object.refuse("has no uncertainty (without it nobody can say what departs from what). Add "
                  "\"sd\", the standard uncertainty?");
  auto const unit = unit_of(object, members);
  Uncertain const read{.value = quantity_of(*object.find("value"), physical, unit),
                       .sd = quantity_of(*object.find("sd"), physical, unit)};
  if (!(read.sd > 0.0))
    object.find("sd")->refuse("is not positive (a value without error would outweigh all others). "
                              "State the standard uncertainty?");
  return read;
}

} // namespace coupling::measured
