#include "coupling/compare/force_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coupling {
namespace {

constexpr std::size_t n_grid = 400;
constexpr double carries = 1e-3; // of the peak

ForceBranch known_rows(PressRecord const& record) {
  auto const gap = record.column("punch_gap");
  auto const force = record.column("upper_punch_force");
  ForceBranch known;
  for (std::size_t k = 0; k < gap.size(); ++k) {
    if (!std::isfinite(gap[k]) || !std::isfinite(force[k]))
      continue;
    known.gap.push_back(gap[k]);
    known.force.push_back(force[k]);
  }
  return known;
}

/// Integral of F dgap over rows first..last.
double work(ForceBranch const& rows, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t k = first; k < last; ++k)
    sum += 0.5 * (rows.force[k] + rows.force[k + 1]) * (rows.gap[k + 1] - rows.gap[k]);
  return sum;
}

/// Rows first..last whose gap lies beyond all gaps before them, on the way that `sign` gives.
ForceBranch monotonic(ForceBranch const& rows, std::size_t first, std::size_t last, double sign) {
  ForceBranch branch;
  for (std::size_t k = first; k <= last; ++k) {
    if (!branch.gap.empty() && sign * (rows.gap[k] - branch.gap.back()) <= 0.0)
      continue;
    branch.gap.push_back(rows.gap[k]);
    branch.force.push_back(rows.force[k]);
  }
  return branch;
}

double interpolate(ForceBranch const& branch, double gap) {
  auto const above = std::ranges::upper_bound(branch.gap, gap);
  auto const k =
      std::clamp<std::ptrdiff_t>(above - branch.gap.begin(), 1, std::ssize(branch.gap) - 1);
  auto const i = static_cast<std::size_t>(k);
  double const fraction = (gap - branch.gap[i - 1]) / (branch.gap[i] - branch.gap[i - 1]);
  return branch.force[i - 1] + fraction * (branch.force[i] - branch.force[i - 1]);
}

/// The largest gap at which a branch still carries something; its smallest if it never does.
double carries_up_to(ForceBranch const& branch, double threshold) {
  for (std::size_t k = branch.gap.size(); k-- > 0;)
    if (std::abs(branch.force[k]) >= threshold)
      return branch.gap[std::min(k + 1, branch.gap.size() - 1)];
  return branch.gap.front();
}

} // namespace

std::optional<ForceCurve> force_curve(PressRecord const& record) {
  if (!record.has("punch_gap") || !record.has("upper_punch_force"))
    return std::nullopt;
  auto const rows = known_rows(record);
  if (rows.gap.size() < 2)
    return std::nullopt;
  auto const last = rows.gap.size() - 1;
  // With a dwell the smallest gap is held: loading ends where it is first reached, unloading starts
  // there too, and the held rows add no work. Of the force that relaxes meanwhile each branch keeps
  // its own end.
  auto const turn = static_cast<std::size_t>(std::ranges::min_element(rows.gap) - rows.gap.begin());
  auto leave = turn;
  while (leave < last && rows.gap[leave + 1] <= rows.gap[turn])
    ++leave;
  ForceCurve curve{.loading = monotonic(rows, 0, turn, -1.0),
                   .unloading = monotonic(rows, leave, last, 1.0),
                   .loading_work = -work(rows, 0, turn),
                   .unloading_work = work(rows, turn, last),
                   .smallest_gap = rows.gap[turn],
                   .peak = std::ranges::max(rows.force)};
  std::ranges::reverse(curve.loading.gap);
  std::ranges::reverse(curve.loading.force);
  return curve;
}

std::optional<BranchDifference> difference(ForceBranch const& reference, ForceBranch const& other,
                                           double peak) {
  if (reference.gap.size() < 2 || other.gap.size() < 2 || !(peak > 0.0))
    return std::nullopt;
  double const low = std::max(reference.gap.front(), other.gap.front());
  double const carried =
      std::max(carries_up_to(reference, carries * peak), carries_up_to(other, carries * peak));
  double const high = std::min({reference.gap.back(), other.gap.back(), carried});
  if (!(low < high))
    return std::nullopt;
  BranchDifference found{0.0, low, 0.0};
  for (std::size_t k = 0; k <= n_grid; ++k) {
    double const gap = low + (high - low) * static_cast<double>(k) / n_grid;
    double const apart = std::abs(interpolate(other, gap) - interpolate(reference, gap)) / peak;
    if (apart > found.largest)
      found = {apart, gap, found.rms};
    found.rms += apart * apart;
  }
  found.rms = std::sqrt(found.rms / (n_grid + 1));
  return found;
}

} // namespace coupling
