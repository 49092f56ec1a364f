#include "coupling/gap_path.hpp"

#include "coupling/compare/si_units.hpp"
#include "coupling/record/curves.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {

GapPath read_gap_path(std::filesystem::path const& file, double time_scale) {
  auto const record = in_si(read_curves(file), file.string());
  for (char const* column : {"time", "punch_gap"})
    VALIDATE(record.has(column),
             fmt::format("{}: no column '{}' (a gap is followed over time). Is it called "
                         "otherwise there?",
                         file.string(), column));
  auto const time = record.column("time"), gap = record.column("punch_gap");
  GapPath path;
  double start = 0.0;
  for (std::size_t row = 0; row < record.size(); ++row) {
    if (std::isnan(time[row]) || std::isnan(gap[row]))
      continue;
    if (path.time.empty())
      start = time[row];
    double const since = time_scale * (time[row] - start);
    VALIDATE(std::isfinite(since) && (path.time.empty() || since > path.time.back()),
             fmt::format("{}: row {}: time = {:.9g} s does not come after the row before it. Is "
                         "the file sorted by time, without repeated rows?",
                         file.string(), row + 1, time[row]));
    VALIDATE(std::isfinite(gap[row]) && gap[row] > 0.0,
             fmt::format("{}: row {}: punch_gap = {:.9g} m, where the punches would meet. Is it "
                         "the distance of the punch faces?",
                         file.string(), row + 1, gap[row]));
    path.time.push_back(since);
    path.gap.push_back(gap[row]);
  }
  VALIDATE(path.time.size() > 1,
           fmt::format("{}: fewer than two rows with a time and a gap: there is no path to follow. "
                       "Is it the right file?",
                       file.string()));
  return path;
}

double gap_at(GapPath const& path, double time) {
  auto const after = std::ranges::upper_bound(path.time, time);
  if (after == path.time.end())
    return path.gap.back();
  auto const k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - path.time.begin(), 1));
  double const s = (time - path.time[k - 1]) / (path.time[k] - path.time[k - 1]);
  return path.gap[k - 1] + s * (path.gap[k] - path.gap[k - 1]);
}

} // namespace coupling
