#include "coupling/reduced/measured_course.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace coupling::reduced {
namespace {

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

Line line_through(std::span<Reading const> readings) {
  double t = 0.0, g = 0.0, tt = 0.0, tg = 0.0;
  for (auto const& r : readings)
    t += r.time, g += r.gap;
  auto const n = static_cast<double>(readings.size());
  t /= n, g /= n;
  for (auto const& r : readings)
    tt += (r.time - t) * (r.time - t), tg += (r.time - t) * (r.gap - g);
  return {t, g, tt > 0.0 ? tg / tt : 0.0};
}

/// Straight parts of equal numbers of readings, and where they begin and end.
struct Stroke {
  std::vector<Line> lines;
  std::vector<double> borders; ///< one more than lines [s]
};

double rms_off(std::span<Reading const> readings, Line const& line) {
  double sum = 0.0;
  for (auto const& r : readings)
    sum += std::pow(r.gap - line.gap_at(r.time), 2);
  return std::sqrt(sum / static_cast<double>(readings.size()));
}

/// As few straight parts as follow the readings within their noise, at most 24: a machine that
/// keeps its speed has one, whose place is surer than any reading.
Stroke stroke_of(Readings const& readings, double sd) {
  constexpr double noise = 1.3; // r.m.s. over sd from which a line is none
  Stroke stroke;
  for (std::size_t const n : {1, 2, 3, 4, 6, 8, 12, 16, 24}) {
    if (n > 1 && readings.size() < 4 * n)
      break;
    stroke = {{}, {readings.front().time}};
    bool follows = true;
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t const first = k * readings.size() / n, end = (k + 1) * readings.size() / n;
      auto const part = std::span(readings).subspan(first, end - first);
      stroke.lines.push_back(line_through(part));
      stroke.borders.push_back(end < readings.size()
                                   ? 0.5 * (readings[end - 1].time + readings[end].time)
                                   : readings.back().time);
      follows = follows && rms_off(part, stroke.lines.back()) < noise * sd;
    }
    if (follows)
      break;
  }
  return stroke;
}

double mean_gap(Readings const& readings) {
  double sum = 0.0;
  for (auto const& r : readings)
    sum += r.gap;
  return sum / static_cast<double>(readings.size());
}

/// Lowest gap, and when it is reached and left.
struct Corner {
  double gap, closed, opens;
};

Corner corner_of(Stroke const& closing, std::optional<Stroke> const& opening, double end,
                 std::optional<double> held) {
  Line const& down = closing.lines.back();
  if (!opening) {
    double const lowest = held.value_or(down.gap_at(end));
    return {lowest, std::min(down.time_at(lowest), end), end};
  }
  Line const& up = opening->lines.front();
  if (held)
    return {*held, down.time_at(*held), up.time_at(*held)};
  double const meet = (down.level - down.slope * down.middle - up.level + up.slope * up.middle) /
                      (up.slope - down.slope);
  return {down.gap_at(meet), meet, meet};
}

/// Points of a stroke between two moments: its borders, where two lines are averaged.
void append(GapCourse& course, Stroke const& stroke, double from, double until) {
  for (std::size_t k = 0; k < stroke.borders.size(); ++k) {
    double const t = stroke.borders[k];
    std::size_t const n = stroke.lines.size();
    double const before = stroke.lines[k == 0 ? 0 : k - 1].gap_at(t);
    double const after = stroke.lines[std::min(k, n - 1)].gap_at(t);
    if (t > from && t < until)
      course.time.push_back(t), course.gap.push_back(0.5 * (before + after));
  }
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
  double const stroke = all.front().gap - least->gap;
  // Readings this near to the turn may belong to either side.
  double const near = least->gap + std::max(4.0 * sd, 2e-3 * stroke);
  Readings down, low, up;
  for (auto r = all.begin(); r != all.end(); ++r)
    (r->gap <= near ? low : r < least ? down : up).push_back(*r);
  VALIDATE(down.size() >= 5 && stroke > 20.0 * sd,
           fmt::format("{}: the punch gap never closes ({} readings before its smallest). Does the "
                       "record begin before the pressing?",
                       run.file, down.size()));
  auto const closing = stroke_of(down, sd);
  auto const opening = up.size() >= 5 ? std::optional(stroke_of(up, sd)) : std::nullopt;
  bool const dwells = run.press.dwell.value_or(0.0) > 0.0;
  auto const corner = corner_of(closing, opening, all.back().time,
                                dwells ? std::optional(mean_gap(low)) : std::nullopt);
  GapCourse course;
  append(course, closing, -1e300, corner.closed);
  course.time.push_back(corner.closed), course.gap.push_back(corner.gap);
  if (corner.opens > corner.closed)
    course.time.push_back(corner.opens), course.gap.push_back(corner.gap);
  if (opening)
    append(course, *opening, corner.opens, 1e300);
  validate(course);
  return course;
}

} // namespace coupling::reduced
