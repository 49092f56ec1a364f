#include "coupling/reduced/measured_course.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace coupling::reduced {
namespace {

constexpr std::size_t n_points = 24; ///< of each stroke
constexpr double near_share = 0.15;  ///< of the stroke, where its end is taken to be straight

struct Reading {
  double time, gap;
};
using Readings = std::vector<Reading>;

/// gap = level + slope (t - middle)
struct Line {
  double middle, level, slope;
  double time_at(double gap) const { return middle + (gap - level) / slope; }
  double gap_at(double time) const { return level + slope * (time - middle); }
};

std::optional<Line> line_through(Readings const& readings) {
  if (readings.size() < 3)
    return {};
  double t = 0.0, g = 0.0, tt = 0.0, tg = 0.0;
  for (auto const& r : readings)
    t += r.time, g += r.gap;
  auto const n = static_cast<double>(readings.size());
  t /= n, g /= n;
  for (auto const& r : readings)
    tt += (r.time - t) * (r.time - t), tg += (r.time - t) * (r.gap - g);
  if (tg == 0.0)
    return {};
  return Line{t, g, tg / tt};
}

/// Readings between two heights above the lowest gap.
Readings between(Readings const& all, double low, double high) {
  Readings some;
  for (auto const& r : all)
    if (r.gap > low && r.gap < high)
      some.push_back(r);
  return some;
}

double mean_gap(Readings const& readings) {
  double sum = 0.0;
  for (auto const& r : readings)
    sum += r.gap;
  return sum / static_cast<double>(readings.size());
}

Readings while_true(Readings const& all, auto const& holds_at) {
  Readings some;
  for (auto const& r : all)
    if (holds_at(r.time))
      some.push_back(r);
  return some;
}

/// Means of equal parts.
void append(GapCourse& course, Readings const& readings) {
  std::size_t const n = std::min(n_points, readings.size());
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t const first = k * readings.size() / n, end = (k + 1) * readings.size() / n;
    double t = 0.0, g = 0.0;
    for (std::size_t i = first; i < end; ++i)
      t += readings[i].time, g += readings[i].gap;
    course.time.push_back(t / static_cast<double>(end - first));
    course.gap.push_back(g / static_cast<double>(end - first));
  }
}

/// Lowest gap, and when it is reached and left.
struct Corner {
  double gap, closed, opens;
};

Corner corner_of(Readings const& closing, Readings const& opening, double lowest, double sd,
                 bool dwells) {
  double const stroke = closing.front().gap - lowest;
  auto const room = std::pair{lowest + std::max(4.0 * sd, 0.01 * stroke),
                              lowest + std::max(8.0 * sd, near_share * stroke)};
  auto const down = line_through(between(closing, room.first, room.second));
  auto const up = line_through(between(opening, room.first, room.second));
  if (!down || down->slope >= 0.0)
    return {lowest, closing.back().time, closing.back().time};
  if (!up || up->slope <= 0.0)
    return {lowest, down->time_at(lowest), std::max(down->time_at(lowest), closing.back().time)};
  if (dwells)
    return {lowest, down->time_at(lowest), up->time_at(lowest)};
  double const meet =
      (down->level - down->slope * down->middle - up->level + up->slope * up->middle) /
      (up->slope - down->slope);
  return {down->gap_at(meet), meet, meet};
}

} // namespace

GapCourse measured_course(measured::MeasuredData const& data, measured::Run const& run) {
  auto const gap = run.channel("punch_gap");
  Readings all;
  for (std::size_t k = 0; k < run.time.size(); ++k)
    if (std::isfinite(gap[k]))
      all.push_back({run.time[k], gap[k]});
  double const sd = data.channel("punch_gap")->sd;
  auto const least = std::ranges::min_element(all, {}, &Reading::gap);
  VALIDATE(least - all.begin() >= 5 && all.front().gap - least->gap > 20.0 * sd,
           fmt::format("{}: the punch gap never closes ({} readings before the smallest). Does the "
                       "record begin before the pressing?",
                       run.file, least - all.begin()));
  bool const dwells = run.press.dwell.value_or(0.0) > 0.0;
  double const lowest = dwells ? mean_gap(between(all, 0.0, least->gap + 6.0 * sd)) : least->gap;
  auto const corner = corner_of({all.begin(), least + 1}, {least, all.end()}, lowest, sd, dwells);
  GapCourse course;
  append(course, while_true(all, [&](double t) { return t < corner.closed; }));
  course.time.push_back(corner.closed), course.gap.push_back(corner.gap);
  if (corner.opens > corner.closed)
    course.time.push_back(corner.opens), course.gap.push_back(corner.gap);
  append(course, while_true(all, [&](double t) { return t > corner.opens; }));
  validate(course);
  return course;
}

} // namespace coupling::reduced
