#include "coupling/case_value.hpp"

#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace coupling {

namespace {

std::string_view trim(std::string_view text) {
  auto const first = text.find_first_not_of(' ');
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The parts of a text between separators, trimmed; none for an empty text.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (trim(text).empty())
    return parts;
  while (true) {
    auto const end = text.find(separator);
    parts.emplace_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

/// `Did you mean 250 MPa?` where the number in the entry's customary unit would be in range.
std::string unit_question(Entry const& entry, std::string_view text) {
  std::string_view const standard = entry.standard;
  auto const space = standard.find(' ');
  std::string_view const number = text.substr(0, text.find_first_not_of("+-.0123456789eE"));
  if (space != std::string_view::npos && !number.empty()) {
    std::string const guess = fmt::format("{} {}", number, standard.substr(space + 1));
    try {
      if (entry.range.contains(parse_quantity(guess, entry.physical)))
        return fmt::format("Did you mean {}?", guess);
    } catch (dem::InvalidInput const&) {
      // no number in front: the question below is the better one
    }
  }
  return "Choose a value inside it?";
}

void check_range(Entry const& entry, double value, std::string_view text) {
  VALIDATE(entry.range.contains(value),
           fmt::format("is outside the allowed range ({}). {}", describe_range(entry),
                       unit_question(entry, text)));
}

} // namespace

double parse_number(Entry const& entry, std::string_view text) {
  double const value = parse_quantity(text, entry.physical);
  check_range(entry, value, text);
  return value;
}

std::uint64_t parse_count(Entry const& entry, std::string_view text) {
  std::uint64_t value = 0;
  auto const read = std::from_chars(text.data(), text.data() + text.size(), value);
  VALIDATE(!text.empty() && read.ec == std::errc{} && read.ptr == text.data() + text.size() &&
               entry.range.contains(static_cast<double>(value)),
           fmt::format("is no whole number in the allowed range ({}). Write one such as {}?",
                       describe_range(entry), entry.standard));
  return value;
}

bool parse_truth(std::string_view text) {
  if (text == "true" || text == "yes" || text == "on")
    return true;
  if (text == "false" || text == "no" || text == "off")
    return false;
  throw dem::InvalidInput("is neither true nor false. Write one of them?");
}

std::string parse_choice(Entry const& entry, std::string_view text) {
  std::vector<std::string> const choices = split(entry.choices, '|');
  if (std::ranges::find(choices, text) != choices.end())
    return std::string(text);
  throw dem::InvalidInput(fmt::format("is none of the choices ({}).{}", entry.choices,
                                      did_you_mean(text, choices, "Choose one of them?")));
}

std::vector<SizeClass> parse_size_classes(Entry const& entry, std::string_view text) {
  std::vector<SizeClass> sizes;
  for (std::string const& part : split(text, ',')) {
    auto const colon = part.find(':');
    VALIDATE(
        colon != std::string::npos,
        fmt::format(
            "has a class '{}' without a share (a class is DIAMETER: SHARE). Write 0.5 mm: 100 %?",
            quote(part)));
    std::string const diameter = std::string(trim(std::string_view(part).substr(0, colon)));
    std::string const share = std::string(trim(std::string_view(part).substr(colon + 1)));
    try {
      sizes.push_back({.diameter = parse_quantity(diameter, Physical::length),
                       .mass_fraction = parse_quantity(share, Physical::ratio)});
    } catch (dem::InvalidInput const& problem) {
      throw dem::InvalidInput(fmt::format("in class '{}': {}", quote(part), problem.what()));
    }
    VALIDATE(entry.range.contains(sizes.back().diameter),
             fmt::format("has a diameter {} outside the allowed range ({}). Did you mean mm?",
                         quote(diameter), describe_range(entry)));
    VALIDATE(sizes.back().mass_fraction > 0.0 && sizes.back().mass_fraction <= 1.0,
             fmt::format(
                 "has a share {} that is not above 0 and up to 100 %. Is the percent sign missing?",
                 quote(share)));
  }
  VALIDATE(!sizes.empty(),
           "holds no size class (a component has at least one). Write 0.5 mm: 100 %?");
  return sizes;
}

std::vector<std::string> parse_tools(std::string_view text) {
  static std::vector<std::string> const known = {"die", "upper_punch", "lower_punch"};
  std::vector<std::string> const tools = split(text, ',');
  for (auto tool = tools.begin(); tool != tools.end(); ++tool) {
    VALIDATE(std::ranges::find(known, *tool) != known.end(),
             fmt::format("names an unknown tool '{}' (tools are die, upper_punch, lower_punch).{}",
                         quote(*tool), did_you_mean(*tool, known, "Name one of them?")));
    VALIDATE(std::find(tools.begin(), tool, *tool) == tool,
             fmt::format("names '{}' twice. Name it once?", *tool));
  }
  return tools;
}

void check_value(Entry const& entry, std::string_view text) {
  switch (entry.kind) {
  case EntryKind::text:
    VALIDATE(text.size() <= 200, "is longer than 200 bytes. Shorten it?");
    return;
  case EntryKind::file:
    return;
  case EntryKind::choice:
    parse_choice(entry, text);
    return;
  case EntryKind::truth:
    parse_truth(text);
    return;
  case EntryKind::count:
    parse_count(entry, text);
    return;
  case EntryKind::quantity:
    parse_number(entry, text);
    return;
  case EntryKind::size_classes:
    parse_size_classes(entry, text);
    return;
  case EntryKind::tools:
    parse_tools(text);
    return;
  }
}

std::string print_truth(bool value) {
  return value ? "true" : "false";
}

std::string print_size_classes(std::vector<SizeClass> const& sizes) {
  std::vector<std::string> parts;
  for (SizeClass const& size : sizes)
    parts.push_back(
        fmt::format("{}: {}", print_quantity(size.diameter, Physical::length), size.mass_fraction));
  return print_list(parts);
}

std::string print_list(std::vector<std::string> const& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace coupling
