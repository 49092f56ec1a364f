#include "coupling/finding/cause_words.hpp"
#include "coupling/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coupling::finding {
namespace {

/// "a, b and c"
std::string joined(std::vector<std::string> const& parts, std::string_view last) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
    text += (k == 0 ? "" : k + 1 == parts.size() ? fmt::format(" {} ", last) : ", ") + parts[k];
  return text;
}

std::string named_in_words(Finding const& finding) {
  std::vector<std::string> parts;
  double least = 1.0;
  for (auto const& cause : named_causes(finding)) {
    std::string part = words_of(cause.name);
    if (!cause.parameters.empty())
      part += fmt::format(" ({})",
                          size_in_words(cause.name, cause.size(), cause.parameters.front().unit));
    parts.push_back(part);
    least = std::min(least, cause.probability);
  }
  if (parts.empty())
    return "A cause was named.";
  std::string const rest = finding.is_incomplete
                               ? " As it is known, it does not explain all of it."
                               : " With that the simulation agrees with the measurement.";
  return fmt::format("{}. Probability: {:.0f} %.{}", capitalised(joined(parts, "and")),
                     100.0 * least, rest);
}

} // namespace

ShownAs shown_as(std::string_view cause, std::string_view unit) {
  if (unit == "m/N")
    return {1e9, "µm/kN"};
  if (unit == "m/s")
    return {6e7, "µm/min"};
  if (unit == "m/Pa")
    return {1e12, "µm/MPa"};
  if (unit == "m" && cause != "compact_height")
    return {1e6, "µm"};
  constexpr std::array<std::string_view, 8> in_per_cent{
      "force_gain", "mass_error",      "young_modulus", "cohesion",
      "breakage",   "rate_dependence", "missing_fines", "fill_state"};
  if (unit == "1" && std::ranges::count(in_per_cent, cause) > 0)
    return {100.0, "%"};
  return {1.0, unit == "1" ? "" : std::string(unit)};
}

std::string size_in_words(std::string_view cause, double value, std::string_view unit) {
  if (!std::isfinite(value))
    return "not known";
  auto const shown = shown_as(cause, unit);
  if (shown.factor == 1.0 && !shown.unit.empty())
    return format_quantity(value, unit, 4);
  return fmt::format("{:.3g}{}{}", shown.factor * value, shown.unit.empty() ? "" : " ", shown.unit);
}

std::string interval_in_words(std::string_view cause, CauseParameter const& parameter) {
  auto const text = [&](double value) { return size_in_words(cause, value, parameter.unit); };
  if (parameter.is_open_low && parameter.is_open_high)
    return fmt::format("{}, 95 %: no limit either way", text(parameter.value));
  return fmt::format("{}, 95 %: {} to {}", text(parameter.value),
                     parameter.is_open_low ? "no lower limit" : text(parameter.low),
                     parameter.is_open_high ? "no upper limit" : text(parameter.high));
}

std::string in_words(FoundCause const& cause) {
  if (cause.parameters.empty())
    return cause.name;
  return cause.name + " = " + interval_in_words(cause.name, cause.parameters.front());
}

std::string in_words(CalibratedValue const& value) {
  auto const text = [&](double number) { return format_quantity(number, value.unit, 4); };
  return fmt::format("calibrated: {} = {}, sd {}; sheet: {}", value.name, text(value.value),
                     text(value.sd), text(value.sheet));
}

std::string verdict_in_words(Finding const& finding) {
  if (finding.verdict == "consistent")
    return "Nothing wrong was found: measurement and simulation agree within their known errors.";
  if (finding.verdict == "named")
    return named_in_words(finding);
  if (finding.verdict == "undecided") {
    std::vector<std::string> parts;
    for (auto const& name : finding.group)
      parts.push_back(words_of(name));
    return fmt::format("Something is wrong, and these data cannot tell which: {}.{}",
                       joined(parts, "or"),
                       !finding.measurements.empty() && finding.measurements.front().is_enough
                           ? " The next measurement below tells them apart."
                           : "");
  }
  return "Something is wrong that no known cause explains. Where it shows is described below.";
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      c = ' ';
    else if (c == '\\')
      c = '/'; // a backslash at the end would swallow the next line
  return line;
}

} // namespace coupling::finding
