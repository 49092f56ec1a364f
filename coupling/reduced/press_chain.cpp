#include "coupling/reduced/press_chain.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <functional>

namespace coupling::reduced {
namespace {

void validate(GapCourse const& course) {
  VALIDATE(!course.time.empty() && course.time.size() == course.gap.size(),
           fmt::format("gap course: {} times and {} gaps. One gap for each time?",
                       course.time.size(), course.gap.size()));
  VALIDATE(std::ranges::adjacent_find(course.time, std::greater_equal<>()) == course.time.end(),
           "gap course: times do not increase. Are two points swapped?");
  VALIDATE(std::ranges::all_of(course.gap, [](double gap) { return gap > 0.0; }),
           "gap course: a gap is not positive. Is it a travel instead?");
}

/// The moments at which the chain is solved: samples, and the corners of the course between them.
std::vector<double> moments(GapCourse const& course, std::vector<double> const& samples) {
  std::vector<double> all(samples);
  for (double const corner : course.time)
    if (corner < samples.back())
      all.push_back(corner);
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  return all;
}

/// h with h = at_rest + D(F_upper(h)). F falls as h grows, so that the root lies between at_rest
/// and at_rest + D(F_upper(at_rest)).
double meet(BedLaw const& law, Bed const& bed, FrameLaw const& frame, double at_rest,
            double smallest) {
  auto const departure = [&](double h) {
    double const force = bed_forces(law, bed, h, std::min(smallest, h)).upper;
    return h - at_rest - frame.deflection(force);
  };
  double const lowest = departure(at_rest);
  if (lowest == 0.0)
    return at_rest;
  double const high = at_rest - lowest, highest = departure(high);
  if (highest == 0.0)
    return high;
  std::uintmax_t most = 200;
  auto const [low, up] =
      boost::math::tools::toms748_solve(departure, at_rest, high, lowest, highest,
                                        boost::math::tools::eps_tolerance<double>(50), most);
  return 0.5 * (low + up);
}

} // namespace

double GapCourse::at(double t) const {
  auto const after = std::ranges::upper_bound(time, t);
  if (after == time.begin())
    return gap.front();
  if (after == time.end())
    return gap.back();
  auto const k = static_cast<std::size_t>(after - time.begin());
  double const s = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return gap[k - 1] + s * (gap[k] - gap[k - 1]);
}

GapCourse press_course(double fill_height, double end_gap, double speed_down, double speed_up,
                       double dwell) {
  VALIDATE(speed_down > 0.0 && speed_up > 0.0 && dwell >= 0.0 && end_gap > 0.0 &&
               fill_height > end_gap,
           fmt::format("press course: from {} to {} m at {} and {} m/s with a dwell of {} s. Are "
                       "speeds positive, and the fill height above the end gap?",
                       fill_height, end_gap, speed_down, speed_up, dwell));
  double const stroke = fill_height - end_gap, down = stroke / speed_down;
  GapCourse course{.time = {0.0, down}, .gap = {fill_height, end_gap}};
  if (dwell > 0.0)
    course.time.push_back(down + dwell), course.gap.push_back(end_gap);
  course.time.push_back(down + dwell + stroke / speed_up), course.gap.push_back(fill_height);
  return course;
}

std::vector<ChainReading> press_cycle(BedLaw const& law, Bed const& bed, FrameLaw const& frame,
                                      LoadCellErrors const& load_cell, GapCourse const& course,
                                      std::vector<double> const& samples) {
  validate(law);
  validate(course);
  VALIDATE(bed.solid_area > 0.0 && bed.bore > 0.0,
           fmt::format("bed: {} m of solid in a bore of {} m. Both must be positive?",
                       bed.solid_area, bed.bore));
  VALIDATE(std::ranges::adjacent_find(samples, std::greater_equal<>()) == samples.end(),
           "samples: times do not increase. Are two swapped?");
  std::vector<ChainReading> readings;
  if (samples.empty())
    return readings;
  LoadCell cell(load_cell);
  double const start = std::min(course.time.front(), samples.front());
  double last = start, smallest = course.gap.front() + frame.gap_offset;
  std::size_t next = 0;
  for (double const t : moments(course, samples)) {
    double const told = course.at(t);
    double const at_rest = told + frame.gap_offset + frame.thermal_drift * (t - start);
    VALIDATE(at_rest > 0.0, fmt::format("gap course: the faces meet at {} s. Is the gap offset "
                                        "({} m) right?",
                                        t, frame.gap_offset));
    double const height = meet(law, bed, frame, at_rest, smallest);
    smallest = std::min(smallest, height);
    BedForces const forces = bed_forces(law, bed, height, smallest);
    cell.step_done(forces.upper, t - last);
    last = t;
    if (t != samples[next])
      continue;
    readings.push_back({t, told, height, forces, cell.reading()});
    if (++next == samples.size())
      break;
  }
  return readings;
}

} // namespace coupling::reduced
