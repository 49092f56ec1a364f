#include "coupling/reduced/gap_course.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace coupling::reduced {

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

void validate(GapCourse const& course) {
  VALIDATE(!course.time.empty() && course.time.size() == course.gap.size(),
           fmt::format("gap course: {} times and {} gaps. One gap for each time?",
                       course.time.size(), course.gap.size()));
  VALIDATE(std::ranges::adjacent_find(course.time, std::greater_equal<>()) == course.time.end(),
           "gap course: times do not increase. Are two points swapped?");
  VALIDATE(std::ranges::all_of(course.gap, [](double gap) { return gap > 0.0; }),
           "gap course: a gap is not positive. Is it a travel instead?");
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

Turning turning_of(GapCourse const& course) {
  auto const low = std::ranges::min_element(course.gap);
  auto const k = static_cast<std::size_t>(low - course.gap.begin());
  std::size_t last = k;
  while (last + 1 < course.gap.size() && course.gap[last + 1] == *low)
    ++last;
  return {.closed = course.time[k], .opens = course.time[last], .gap = *low};
}

} // namespace coupling::reduced
