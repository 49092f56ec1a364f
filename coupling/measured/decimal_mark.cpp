#include "coupling/measured/decimal_mark.hpp"

#include "coupling/measured/lab_numbers.hpp"
#include "coupling/measured/limits.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <array>

namespace coupling::measured {
namespace {

/// How often something was seen, and where first.
struct Sighting {
  double n = 0.0;
  std::size_t row = 0;
  std::string cell = {};
};

} // namespace

char decimal_mark_of(std::span<LabRow const> rows, LabHeader const& header,
                     std::string const& path) {
  std::array<Sighting, 5> seen; // by MarkEvidence
  for (auto const& row : rows)
    for (auto const& [channel, column] : header.columns) {
      if (column.field >= row.fields.size())
        continue;
      auto const& cell = row.fields[column.field];
      auto& sighting = seen[static_cast<std::size_t>(mark_evidence(cell))];
      if (sighting.n++ == 0.0) {
        sighting.row = row.number;
        sighting.cell = cell;
      }
    }
  auto const of = [&](MarkEvidence evidence) -> Sighting const& {
    return seen[static_cast<std::size_t>(evidence)];
  };
  auto const &point = of(MarkEvidence::point), &comma = of(MarkEvidence::comma);
  double const few = limits::corrupt_share * (point.n + comma.n);
  VALIDATE(point.n <= few || comma.n <= few,
           fmt::format("{}:{}: '{}' has a decimal point, and '{}' in row {} a decimal comma (both "
                       "cannot be). Were two files joined?",
                       path, point.row, quote(point.cell), quote(comma.cell), comma.row));
  if (point.n + comma.n > 0.0)
    return point.n > comma.n ? '.' : ',';
  auto const& unclear = of(MarkEvidence::ambiguous_point).n > 0.0
                            ? of(MarkEvidence::ambiguous_point)
                            : of(MarkEvidence::ambiguous_comma);
  // Between commas a point is decimal: that is the form that measured data have.
  VALIDATE(unclear.n == 0.0 || header.delimiter == ',',
           fmt::format("{}:{}: '{}' could be a decimal number or thousands (no number of the file "
                       "tells). Set \"decimal_mark\" in measured.json?",
                       path, unclear.row, quote(unclear.cell)));
  return '.';
}

} // namespace coupling::measured
