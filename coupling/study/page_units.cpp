#include "coupling/study/page_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coupling::study {

ShownUnit shown_unit(ResultsTable const& table, StudyResponse const& response) {
  if (response.unit == "1") {
    bool const is_percent =
        response.quantity.starts_with("porosity") || response.quantity == "springback";
    return is_percent ? ShownUnit{100.0, "%"} : ShownUnit{};
  }
  static constexpr std::array<std::string_view, 6> prefixed{"N", "m", "Pa", "J", "W", "s"};
  if (std::ranges::count(prefixed, response.unit) == 0)
    return {1.0, response.unit};
  double largest = std::abs(response.observed.value_or(0.0));
  for (ResultRow const& row : table.rows)
    if (double const value = row.value(response.quantity); std::isfinite(value))
      largest = std::max(largest, std::abs(value));
  static constexpr std::array<std::pair<double, std::string_view>, 7> prefixes{
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
  bool const takes_large = response.unit != "m" && response.unit != "s";
  for (auto const& [factor, prefix] : prefixes)
    if (largest >= factor && (takes_large || factor <= 1.0))
      return {1.0 / factor, std::string(prefix) + response.unit};
  return {1.0, response.unit};
}

ShownUnit shown_unit(StudyFactor const& factor) {
  return {factor.number(1.0), factor.unit};
}

std::string short_number(double value, int digits) {
  if (!std::isfinite(value))
    return "-";
  double const size = std::abs(value);
  if (value != 0.0 && (size < 1e-4 || size >= 1e7))
    return fmt::format("{:.{}g}", value, std::min(digits, 4));
  int const whole = value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  auto text = fmt::format("{:.{}f}", value, std::max(digits - whole, 0));
  if (text.find('.') != std::string::npos)
    text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.'))
    text.pop_back();
  return text;
}

int decimals_of(std::span<double const> column, int digits) {
  double largest = 0.0;
  bool are_whole = true;
  for (double const value : column) {
    if (!std::isfinite(value))
      continue;
    largest = std::max(largest, std::abs(value));
    are_whole = are_whole && value == std::round(value);
  }
  if (are_whole || largest == 0.0)
    return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(largest))), 0, 9);
}

std::string fixed_number(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string short_text(StudyFactor const& factor, double natural) {
  if (natural == 0.0 || !std::isfinite(natural))
    return factor.text(natural);
  double const unit = std::pow(10.0, 3 - std::floor(std::log10(std::abs(factor.number(natural)))));
  return factor.text(std::round(factor.number(natural) * unit) / unit / factor.number(1.0));
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds))
    return "not known";
  static constexpr std::array<std::pair<double, std::string_view>, 4> units{
      {{365.25 * 86400.0, "years"}, {86400.0, "days"}, {3600.0, "h"}, {60.0, "min"}}};
  for (auto const& [length, name] : units)
    if (seconds >= 2.0 * length)
      return fmt::format("{:.3g} {}", seconds / length, name);
  return fmt::format("{:.3g} s", seconds);
}

} // namespace coupling::study
