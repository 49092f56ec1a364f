#include "coupling/compare/si_units.hpp"

#include "coupling/units.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace coupling {
namespace {

struct NamedUnit {
  std::string_view name;
  Dimension dimension;
};

constexpr std::array<NamedUnit, 8> si_names = {{{"1", {0, 0, 0}},
                                                {"m", {0, 1, 0}},
                                                {"s", {0, 0, 1}},
                                                {"kg", {1, 0, 0}},
                                                {"N", {1, 1, -2}},
                                                {"Pa", {1, -1, -2}},
                                                {"J", {1, 2, -2}},
                                                {"m/s", {0, 1, -1}}}};

/// Units of the columns that the comparison reads: a gap in newton must not pass for one in metre.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> known_columns = {
    {{"time", "s"},
     {"punch_gap", "m"},
     {"bed_height", "m"},
     {"compact_height", "m"},
     {"mean_overlap", "m"},
     {"upper_punch_force", "N"}}};

std::string si_name(Dimension const& dimension, std::string const& written) {
  for (auto const& known : si_names)
    if (known.dimension == dimension)
      return std::string(known.name);
  return written;
}

} // namespace

SiScale si_scale(std::string const& unit, std::string const& where) {
  if (unit == "1")
    return {1.0, "1"};
  try {
    auto const found = parse_unit(unit);
    auto const factor = found.multiplier * std::pow(10.0, found.decade);
    return {factor, si_name(found.dimension, factor == 1.0 ? unit : "SI of " + unit)};
  } catch (dem::InvalidInput const& problem) {
    throw dem::InvalidInput(fmt::format("{} [{}]: {}", where, unit, problem.what()));
  }
}

PressRecord in_si(PressRecord const& record, std::string const& file) {
  std::vector<double> factors;
  std::vector<PressRecord::Column> columns;
  for (auto const& [name, unit] : record.columns()) {
    auto const si = si_scale(unit, file + ": column " + name);
    for (auto const& [column, needed] : known_columns)
      VALIDATE(
          name != column || si.unit == needed,
          fmt::format(
              "{}: column {} is in {} (it is compared in {}). Is the unit of another column meant?",
              file, name, unit, needed));
    columns.push_back({name, si.unit});
    factors.push_back(si.factor);
  }
  PressRecord converted(std::move(columns));
  for (std::size_t k = 0; k < record.size(); ++k) {
    auto row = record.rows()[k];
    for (std::size_t c = 0; c < row.size(); ++c)
      row[c] *= factors[c];
    converted.add_row(record.stages()[k], std::move(row));
  }
  return converted;
}

} // namespace coupling
