#include "coupling/study/study_factor.hpp"

#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace coupling::study {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int most_levels = 100;

std::string trim(std::string_view text) {
  auto const first = text.find_first_not_of(" \t");
  return first == std::string_view::npos
             ? ""
             : std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

/// 3e6 instead of 3e+06, and 2e5 instead of 200000.
std::string plain_number(double value, int digits) {
  auto const general = fmt::format("{:.{}g}", value, digits);
  auto const scientific = fmt::format("{:.{}e}", value, digits - 1);
  auto const e = scientific.find('e');
  auto mantissa = scientific.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.resize(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.')
      mantissa.pop_back();
  }
  auto const sign = scientific[e + 1] == '+' ? 2u : 1u;
  int exponent = 0;
  std::from_chars(scientific.data() + e + sign, scientific.data() + scientific.size(), exponent);
  auto const short_form = fmt::format("{}e{}", mantissa, exponent);
  bool const is_general = general.find('e') == std::string::npos;
  return is_general && general.size() <= short_form.size() + 1 ? general : short_form;
}

std::string with_unit(std::string const& number, std::string const& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::optional<Physical> physical_of(Entry const& entry) {
  if (entry.kind == EntryKind::quantity || entry.kind == EntryKind::size_classes)
    return entry.physical;
  if (entry.kind == EntryKind::count)
    return Physical::ratio;
  return std::nullopt;
}

/// `0.8 x Tooling/Young's modulus`, `Powder/Component 2/Size classes as {}: 100 %`.
FactorEntry read_factor_entry(StudyText const& text, std::string const& at, std::string part) {
  FactorEntry entry;
  if (auto const x = part.find(" x "); x != std::string::npos) {
    auto const number = part.substr(0, x);
    auto const read =
        std::from_chars(number.data(), number.data() + number.size(), entry.multiplier);
    if (read.ec != std::errc{} || read.ptr != number.data() + number.size() ||
        !(std::isfinite(entry.multiplier) && entry.multiplier != 0.0))
      text.refuse(at, fmt::format("'{}' is no number to multiply by (a part is PATH, 0.8 x PATH or "
                                  "PATH as {{}}: 100 %). Is the x one too many?",
                                  quote(number)));
    part = trim(part.substr(x + 3));
  }
  if (auto const as = part.find(" as "); as != std::string::npos) {
    entry.pattern = trim(part.substr(as + 4));
    part = trim(part.substr(0, as));
    auto const hole = entry.pattern.find("{}");
    if (hole == std::string::npos || entry.pattern.find("{}", hole + 2) != std::string::npos)
      text.refuse(at, fmt::format("'{}' has not one {{}} (that is where the value goes). Write it "
                                  "as {{}}: 100 %?",
                                  quote(entry.pattern)));
  } else if (auto const* row = find_entry(part); row && row->kind == EntryKind::size_classes)
    entry.pattern = "{}: 100 %";
  entry.path = part;
  if (find_entry(part) == nullptr)
    text.refuse(at, fmt::format("'{}' is no entry of a case.{}", quote(part), suggest_entry(part)));
  return entry;
}

void read_entries(StudyText const& text, std::string const& section, StudyFactor& factor) {
  auto const at = section + "/Entries";
  bool is_first = true;
  for (auto& part : split_list(text.needed(at, "entries of the case that the factor sets"), '+')) {
    auto entry = read_factor_entry(text, at, std::move(part));
    auto const physical = physical_of(*find_entry(entry.path));
    if (!physical)
      text.refuse(at, fmt::format("'{}' holds no number (a factor is a number). Make a table with "
                                  "this entry as a column?",
                                  entry.path));
    if (is_first)
      factor.physical = *physical;
    else if (!(describe(*physical).dimension == describe(factor.physical).dimension))
      text.refuse(at, fmt::format("'{}' is {}, '{}' is {} (one value cannot be both). Make two "
                                  "factors?",
                                  factor.entries[0].path, describe(factor.physical).words,
                                  entry.path, describe(*physical).words));
    for (auto const& earlier : factor.entries)
      if (earlier.path == entry.path)
        text.refuse(at, fmt::format("names '{}' twice. Name it once?", entry.path));
    factor.entries.push_back(std::move(entry));
    is_first = false;
  }
}

double read_limit(StudyText const& text, std::string const& path, std::string const& written,
                  StudyFactor& factor) {
  if (factor.unit.empty())
    factor.unit = unit_of(written);
  try {
    return parse_quantity(written, factor.physical);
  } catch (dem::InvalidInput const& problem) {
    text.refuse(path, problem.what());
  }
}

/// A number of levels between low and high, or the levels themselves.
void read_levels(StudyText const& text, std::string const& section, StudyFactor& factor) {
  auto const at = section + "/Levels";
  auto const parts = split_list(text.text(at), ',');
  if (parts.size() > 1) {
    for (auto const& part : parts)
      factor.levels.push_back(read_limit(text, at, part, factor));
    std::ranges::sort(factor.levels);
    if (std::ranges::adjacent_find(factor.levels) != factor.levels.end())
      text.refuse(at, "holds a level twice (its runs would be the same). Remove one?");
    if (std::isnan(factor.low))
      factor.low = factor.levels.front();
    if (std::isnan(factor.high))
      factor.high = factor.levels.back();
    return;
  }
  int count = 0;
  auto const& number = parts.empty() ? "" : parts[0];
  auto const read = std::from_chars(number.data(), number.data() + number.size(), count);
  if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || count < 2 ||
      count > most_levels)
    text.refuse(at, fmt::format("is no number of levels (2 to {}) and no list of levels (a factor "
                                "with one level is constant). Write 3, or 1375 MPa, 2500 MPa?",
                                most_levels));
  for (int k = 0; k < count; ++k)
    factor.levels.push_back(
        factor.rounded(factor.natural(2.0 * static_cast<double>(k) / (count - 1) - 1.0)));
}

void read_limits(StudyText const& text, std::string const& section, std::string const& kind,
                 StudyFactor& factor) {
  factor.low = factor.high = unknown;
  bool const is_list =
      kind == "full_factorial" && split_list(text.text(section + "/Levels"), ',').size() > 1;
  bool const is_free = kind == "table" || is_list;
  auto const limit = [&](char const* name) {
    auto const path = section + "/" + name;
    if (is_free && text.text(path).empty())
      return unknown;
    return read_limit(text, path, text.needed(path, "a design lies between two values"), factor);
  };
  factor.low = limit("Low");
  factor.high = limit("High");
  if (std::isnan(factor.low) != std::isnan(factor.high))
    text.refuse(section + (std::isnan(factor.low) ? "/High" : "/Low"),
                "stands without the other limit (-1 and 1 are coded by both). Set both, or none?");
  if (factor.low == factor.high)
    text.refuse(section + "/High", fmt::format("is Low, too (factor '{}' would be constant). Widen "
                                               "it, or move it to '{}'?",
                                               factor.name, common_section));
  if (factor.low > factor.high)
    text.refuse(section + "/High", "is below Low. Exchange them?");
  if (kind == "full_factorial")
    read_levels(text, section, factor);
  else if (text.has(section + "/Levels"))
    text.refuse(section + "/Levels",
                fmt::format("is not used (Design/Kind = {} chooses its own). Remove it?", kind));
}

bool is_short_name(std::string const& name) {
  auto const is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
  return !name.empty() && name.size() <= 20 && std::ranges::all_of(name, is_plain) &&
         std::isalpha(static_cast<unsigned char>(name[0])) != 0;
}

} // namespace

std::vector<std::string> split_list(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (trim(text).empty())
    return parts;
  while (true) {
    auto const end = text.find(separator);
    parts.push_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos)
      return parts;
    text.remove_prefix(end + 1);
  }
}

std::string unit_of(std::string_view quantity) {
  auto const end = quantity.find_first_not_of("+-.0123456789eE");
  return end == std::string_view::npos ? "" : trim(quantity.substr(end));
}

std::string StudyFactor::si_unit() const {
  auto const si = describe(physical).si;
  return si.empty() ? "1" : std::string(si);
}

double StudyFactor::number(double natural) const {
  return natural / parse_quantity(with_unit("1", unit), physical);
}

std::string StudyFactor::text(double natural) const {
  return with_unit(plain_number(number(natural), 6), unit);
}

double StudyFactor::rounded(double natural) const {
  return parse_quantity(text(natural), physical);
}

std::string StudyFactor::name_of(double natural) const {
  auto const written = plain_number(number(natural), 6);
  return std::isdigit(static_cast<unsigned char>(name.back())) != 0 ? name + "_" + written
                                                                    : name + written;
}

std::vector<PlacedValue> StudyFactor::values(double natural) const {
  std::vector<PlacedValue> set;
  double const in_unit = number(natural);
  for (auto const& entry : entries) {
    auto filled = entry.pattern;
    // Twelve digits: 0.8 x 2341 is 1872.8 and not its binary neighbour.
    filled.replace(filled.find("{}"), 2,
                   with_unit(plain_number(entry.multiplier * in_unit, 12), unit));
    set.push_back({entry.path, filled, where});
  }
  return set;
}

StudyFactor read_factor(StudyText const& text, int number, std::string const& kind) {
  auto const section = fmt::format("Factor {}", number);
  StudyFactor factor{.name = text.needed(section + "/Name", "tables and runs are called by it"),
                     .where = text.where(section + "/Entries"),
                     .entries = {},
                     .physical = Physical::ratio,
                     .unit = {},
                     .low = unknown,
                     .high = unknown,
                     .levels = {}};
  if (!is_short_name(factor.name))
    text.refuse(section + "/Name", "is no short name (a letter, then up to 19 letters, digits or "
                                   "dashes; runs are called by it). Write E?");
  read_entries(text, section, factor);
  read_limits(text, section, kind, factor);
  return factor;
}

double value_in(StudyFactor const& factor, FactorEntry const& entry, PlacedValue const& value) {
  auto const hole = entry.pattern.find("{}");
  auto const before = entry.pattern.substr(0, hole), after = entry.pattern.substr(hole + 2);
  if (!value.text.starts_with(before) || !value.text.ends_with(after) ||
      value.text.size() < before.size() + after.size())
    refuse_entry(value.where, value.path, value.text,
                 fmt::format("does not read '{}' (factor '{}' takes its value from there). Is the "
                             "factor's 'as' another one?",
                             entry.pattern, factor.name));
  auto const middle =
      value.text.substr(before.size(), value.text.size() - before.size() - after.size());
  try {
    return parse_quantity(middle, factor.physical) / entry.multiplier;
  } catch (dem::InvalidInput const& problem) {
    refuse_entry(value.where, value.path, value.text,
                 fmt::format("as factor '{}': {}", factor.name, problem.what()));
  }
}

} // namespace coupling::study
