#include "coupling/finding/cause_words.hpp"
#include "coupling/finding/power_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coupling::finding {
namespace {

using diagnosis::Power;

/// A rival is named where telling it apart asks for more than being seen.
constexpr double noticeable = 1.05;

/// Sizes in the unit that people use for them, two digits; a dash where no size is.
std::string shown(Power const& one, double size) {
  if (!std::isfinite(size))
    return "-";
  double const value = shown_as(one.name, one.unit).factor * size;
  // Rounded first: 9.99 has one digit before the point, 10 has two.
  double const last = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  double const rounded = std::round(value / last) * last;
  auto const digits = static_cast<int>(std::floor(std::log10(rounded) + 1e-9));
  return fmt::format("{:.{}f}", rounded, std::max(1 - digits, 0));
}

std::string unit_of(Power const& one) {
  auto const shown = shown_as(one.name, one.unit);
  return shown.unit.empty() ? "1" : shown.unit;
}

/// `0.36 / 0.58 (rival)`
std::string cell(Power const& one, std::string const& rival) {
  if (!std::isfinite(one.detected))
    return "-";
  bool const is_harder = one.told > noticeable * one.detected && !rival.empty();
  return fmt::format("{} / {}{}", shown(one, one.detected), shown(one, one.told),
                     is_harder ? fmt::format(" ({})", rival) : "");
}

std::string pressing_in_words(reduced::SetPressing const& one) {
  return fmt::format("{:.3g} mm/min to {:.4g} mm{}", one.speed * 6e4, one.gap * 1e3,
                     one.dwell > 0.0 ? fmt::format(" and {:g} s there", one.dwell) : "");
}

/// `A: upper force, one run: 46 rows; 1 mm/min to 8 mm`
std::string set_in_words(PowerColumn const& column) {
  std::vector<std::string> pressings;
  for (auto const& one : column.set.pressings)
    pressings.push_back(pressing_in_words(one));
  return fmt::format("{}: {}; {} rows; {}", column.set.name, column.set.words, column.n_rows,
                     fmt::join(pressings, ", "));
}

std::vector<std::string> assumptions(PowerTable const& table) {
  auto const& with = table.instruments;
  std::vector<std::string> lines = {fmt::format(
      "Sensors: forces {:g} N and {:g} %, radial pressure {:g} MPa and {:g} %, compact height {:g} "
      "um, ejection force {:g} N; {:g} readings a second; each run {}.",
      with.force_sd, 100.0 * with.force_relative, with.pressure_sd * 1e-6,
      100.0 * with.pressure_relative, with.height_sd * 1e6, with.ejection_sd, with.reading_rate,
      with.n_repeats == 1 ? "once" : fmt::format("the mean of {}", with.n_repeats))};
  std::vector<std::string> free, scatter;
  for (auto const& one : table.calibrated)
    free.push_back(fmt::format("{} (known to {:g} %)", one.name, 100.0 * one.sd));
  for (auto const& one : table.scatters)
    if (one.sd > 0.0)
      scatter.push_back(fmt::format("{} {:g}{}", one.name, one.sd,
                                    one.unit == "1" ? std::string() : " " + one.unit));
  lines.push_back(fmt::format("Calibrated: {}.", fmt::join(free, ", ")));
  lines.push_back(fmt::format("Scatter from run to run: {}.", fmt::join(scatter, ", ")));
  return lines;
}

std::string criteria(PowerTable const& table) {
  return fmt::format("Smallest size that is detected ({:g} standard uncertainties out of what "
                     "calibration absorbs) / told from its nearest single rival ({:g} apart; the "
                     "rival where that asks for more). -: no size up to {:g} prior sizes.",
                     table.settings.detection, table.settings.separation,
                     table.settings.most_scales);
}

} // namespace

std::string power_markdown(PowerTable const& table) {
  std::string text = criteria(table) + "\n\n| cause | prior size |";
  std::string rule = "|---|---|";
  for (auto const& column : table.columns)
    text += fmt::format(" {} |", column.set.name), rule += "---|";
  text += "\n" + rule + "\n";
  for (std::size_t j = 0; !table.columns.empty() && j < table.columns.front().causes.size(); ++j) {
    auto const& first = table.columns.front().causes[j];
    text +=
        fmt::format("| `{}` ({}) | {} |", first.name, unit_of(first), shown(first, first.scale));
    for (auto const& column : table.columns)
      text += fmt::format(" {} |", cell(column.causes[j], column.causes[j].rival));
    text += "\n";
  }
  text += "\n";
  for (auto const& column : table.columns)
    text += "- " + set_in_words(column) + ".\n";
  for (auto const& line : assumptions(table))
    text += "- " + line + "\n";
  return text + "- Emulator: " + table.emulator + ".\n";
}

std::string power_text(PowerTable const& table) {
  std::string text = criteria(table) + "\n\n";
  for (auto const& column : table.columns)
    text += "  " + set_in_words(column) + "\n";
  if (table.columns.empty())
    return text;
  text += fmt::format("\n{:>32}{:>8}", "", "prior");
  for (auto const& column : table.columns)
    text += fmt::format("{:>22}", column.set.name);
  auto const& causes = table.columns.front().causes;
  auto const line_of = [&](std::string const& name) {
    return std::ranges::find(causes, name, &Power::name) - causes.begin() + 1;
  };
  for (std::size_t j = 0; j < causes.size(); ++j) {
    text += fmt::format("\n{:>3} {:<28}{:>8}", j + 1,
                        fmt::format("{} [{}]", causes[j].name, unit_of(causes[j])),
                        shown(causes[j], causes[j].scale));
    for (auto const& column : table.columns) {
      auto const& one = column.causes[j];
      text += fmt::format("{:>22}",
                          cell(one, one.rival.empty() ? "" : std::to_string(line_of(one.rival))));
    }
  }
  text += "\n\n(n): the rival in line n\n";
  for (auto const& line : assumptions(table))
    text += line + "\n";
  return text + "Emulator: " + table.emulator + ".\n";
}

} // namespace coupling::finding
