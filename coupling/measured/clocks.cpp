#include "coupling/measured/clocks.hpp"

#include "coupling/measured/limits.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::measured {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Standard deviation of an instant known to lie between two readings: interval / sqrt(12).
double sampling_sd(std::vector<double> const& time, std::size_t k) {
  double const before = k > 0 ? time[k] - time[k - 1] : 0.0;
  double const after = k + 1 < time.size() ? time[k + 1] - time[k] : 0.0;
  return std::max(before, after) / std::sqrt(12.0);
}

double sd_of(Channel const& channel, double reading) {
  return std::hypot(channel.sd, channel.sd_relative * reading);
}

/// Straight line y = mean_y + slope (t - mean_t) by least squares.
struct Line {
  double mean_t = 0.0, mean_y = 0.0, slope = none;
  std::size_t n = 0;
};

Line fit_line(std::span<double const> t, std::span<double const> y) {
  Line line{.n = t.size()};
  for (std::size_t k = 0; k < t.size(); ++k) {
    line.mean_t += t[k] / static_cast<double>(t.size());
    line.mean_y += y[k] / static_cast<double>(t.size());
  }
  double tt = 0.0, ty = 0.0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    tt += (t[k] - line.mean_t) * (t[k] - line.mean_t);
    ty += (t[k] - line.mean_t) * (y[k] - line.mean_y);
  }
  line.slope = ty / tt;
  return line;
}

/// Place of the smallest reading; the size of the table if there is none.
std::size_t smallest(std::vector<double> const& y) {
  std::size_t found = y.size();
  for (std::size_t k = 0; k < y.size(); ++k)
    if (std::isfinite(y[k]) && (found == y.size() || y[k] < y[found]))
      found = k;
  return found;
}

/// The gap at `time`, straight between the readings; NaN beside a gap or outside the record.
double gap_at(LabTable const& positions, double shift, double time) {
  auto const& t = positions.time;
  auto const& y = positions.series.at("punch_gap");
  auto const after = std::ranges::lower_bound(t, time - shift);
  if (after == t.end())
    return none;
  auto const k = static_cast<std::size_t>(after - t.begin());
  if (*after == time - shift)
    return y[k];
  if (k == 0)
    return none;
  double const share = (time - shift - t[k - 1]) / (t[k] - t[k - 1]);
  return y[k - 1] + share * (y[k] - y[k - 1]);
}

/// Shift of the position's time, by the criterion that was chosen.
Instant shift_of(LabTable const& forces, LabTable const& positions, ClockChoice const& choice,
                 PressProtocol const& press, MeasuredData const& data) {
  if (choice.align == Alignment::common)
    return {0.0, choice.sd};
  if (choice.align == Alignment::stated)
    return {choice.shift, choice.sd};
  auto const& force = *data.channel("upper_punch_force");
  bool const by_turn = choice.align == Alignment::turning_point;
  Instant const of_force = by_turn ? force_turn(forces, force) : force_contact(forces, force);
  Instant const of_gap =
      by_turn ? gap_turn(positions, *data.channel("punch_gap")) : gap_contact(positions, press);
  return {of_force.time - of_gap.time, std::hypot(of_force.sd, of_gap.sd)};
}

std::string in_words(Alignment align) {
  static constexpr char const* words[] = {
      "one clock, as stated", "a shift, as stated",
      "first contact (the gap passes the fill height when the force leaves its noise)",
      "turning point (the closing ends when the force is highest)"};
  return words[static_cast<std::size_t>(align)];
}

void add_decisions(LabTable& joined, LabTable const& positions, Alignment align,
                   Instant const& shift, TableName const& name, std::string const& position_file) {
  joined.decisions.insert(joined.decisions.end(), positions.decisions.begin(),
                          positions.decisions.end());
  bool const is_found = align >= Alignment::first_contact;
  joined.decisions.push_back(
      {name.file, 0,
       fmt::format("the time of {} is shifted by {:.6g} s, with a standard uncertainty of {:.2g} "
                   "s, by {}; the gap is interpolated between its readings{}",
                   position_file, shift.time, shift.sd, in_words(align),
                   is_found ? "; such data cannot tell a lag of the force" : "")});
}

} // namespace

Instant force_turn(LabTable const& forces, Channel const& force) {
  auto const& y = forces.series.at(force.name);
  double highest = -std::numeric_limits<double>::infinity();
  for (double const value : y)
    highest = std::isfinite(value) ? std::max(highest, value) : highest;
  for (std::size_t k = 0; k < y.size(); ++k)
    if (y[k] >= highest - 3.0 * sd_of(force, highest))
      return {forces.time[k], sampling_sd(forces.time, k)};
  return {none, none};
}

Instant gap_turn(LabTable const& positions, Channel const& gap) {
  auto const& y = positions.series.at(gap.name);
  std::size_t const turn = smallest(y);
  if (turn == y.size())
    return {none, none};
  double highest = y[turn];
  for (std::size_t k = 0; k < turn; ++k)
    highest = std::isfinite(y[k]) ? std::max(highest, y[k]) : highest;
  double const travel = highest - y[turn];
  std::vector<double> t_line, y_line;
  for (std::size_t k = 0; k < turn; ++k)
    if (y[k] < highest - 0.5 * travel && y[k] > highest - 0.9 * travel) {
      t_line.push_back(positions.time[k]);
      y_line.push_back(y[k]);
    }
  auto const line = fit_line(t_line, y_line);
  if (line.n < 3 || !(line.slope < 0.0))
    return {positions.time[turn], sampling_sd(positions.time, turn)};
  double const time = line.mean_t + (y[turn] - line.mean_y) / line.slope;
  return {time, std::hypot(sampling_sd(positions.time, turn), sd_of(gap, y[turn]) / line.slope)};
}

Instant force_contact(LabTable const& forces, Channel const& force) {
  auto const& y = forces.series.at(force.name);
  auto const& t = forces.time;
  double const level = limits::noise_sds * force.sd;
  std::size_t first = 0, second = 0;
  while (first + 1 < y.size() && !(y[first] > level && y[first + 1] > level))
    ++first;
  for (second = first; second < y.size() && !(y[second] > 8.0 * level);)
    ++second;
  if (second >= y.size())
    return {none, none};
  double const rise = t[second] - t[first];
  return {t[first] - 2.0 / 3.0 * rise, std::hypot(sampling_sd(t, first), rise / std::sqrt(27.0))};
}

Instant gap_contact(LabTable const& positions, PressProtocol const& press) {
  auto const& y = positions.series.at("punch_gap");
  // How well a bed's height is known, in time.
  double const of_height =
      limits::end_gap_share * (press.fill_height - press.end_gap) / press.speed_down;
  for (std::size_t k = 1; k < y.size(); ++k)
    if (y[k - 1] > press.fill_height && y[k] <= press.fill_height) {
      double const share = (y[k - 1] - press.fill_height) / (y[k - 1] - y[k]);
      double const time =
          positions.time[k - 1] + share * (positions.time[k] - positions.time[k - 1]);
      return {time, of_height};
    }
  return {none, none};
}

LabTable joined_by_time(LabTable forces, LabTable const& positions, ClockChoice const& choice,
                        PressProtocol const& press, MeasuredData const& data, TableName const& name,
                        std::string const& position_file, double& clock_sd) {
  Instant const shift = shift_of(forces, positions, choice, press, data);
  VALIDATE(std::isfinite(shift.time),
           fmt::format("{}: its clock cannot be aligned with that of {} by {}: there is no such "
                       "instant in both. State the shift in measured.json, in \"clock\"?",
                       name.path, position_file, in_words(choice.align)));
  clock_sd = shift.sd;
  std::vector<double> gap;
  std::vector<bool> is_inside;
  for (double const time : forces.time) {
    gap.push_back(gap_at(positions, shift.time, time));
    double const at = time - shift.time;
    is_inside.push_back(at >= positions.time.front() && at <= positions.time.back());
  }
  auto const n_outside = std::ranges::count(is_inside, false);
  VALIDATE(n_outside < std::ssize(is_inside),
           fmt::format("{}: overlaps nowhere with {}, whose time is shifted by {:.6g} s (a force "
                       "needs its gap). State the shift in measured.json, in \"clock\"?",
                       name.path, position_file, shift.time));
  forces.series["punch_gap"] = std::move(gap);
  forces.unit_factors["punch_gap"] = positions.unit_factors.at("punch_gap");
  keep_rows(forces, is_inside);
  add_decisions(forces, positions, choice.align, shift, name, position_file);
  if (n_outside > 0)
    forces.decisions.push_back({name.file, 0,
                                fmt::format("{} rows are left out: {} has no gap at their time",
                                            n_outside, position_file)});
  return forces;
}

} // namespace coupling::measured
