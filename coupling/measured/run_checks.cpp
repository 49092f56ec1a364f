#include "coupling/measured/run_checks.hpp"

#include "coupling/measured/curve_numbers.hpp"
#include "coupling/measured/limits.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace coupling::measured {
namespace {

constexpr double MPa = 1e6, mm = 1e-3, kN = 1e3;

double area_of(Sample const& sample) {
  return 0.25 * std::numbers::pi * sample.die_diameter.value * sample.die_diameter.value;
}

/// Nearer to a factor of 1000 than to 1.
bool is_off_by_1000(double factor) {
  return !(factor < limits::unit_factor && factor > 1.0 / limits::unit_factor);
}

/// What the frame may stand between a gap at the faces and the commanded one [m].
double frame_yield(RunCheck const& check, double force) {
  return check.data.gap_source == GapSource::measured ? force / limits::frame_stiffness : 0.0;
}

/// Whether gap and force, as given, could be a press's: the smallest gap near the end gap, with a
/// pressure in range.
bool fits(RunCheck const& check, std::vector<double> const& gap, std::vector<double> const& force) {
  auto const low = smallest_of(gap);
  auto const high = largest_of(force);
  if (!low || !high)
    return false;
  double const pressure = high->value / area_of(check.data.sample);
  double const stroke = check.run.press.fill_height - check.run.press.end_gap;
  double const room = limits::turning_share * check.run.press.end_gap +
                      limits::end_gap_share * stroke + frame_yield(check, high->value);
  return std::abs(low->value - check.run.press.end_gap) <= room &&
         pressure >= limits::least_pressure && pressure <= limits::largest_pressure;
}

std::vector<double> scaled(std::span<double const> values, double factor) {
  std::vector<double> result(values.begin(), values.end());
  std::ranges::for_each(result, [&](double& value) { value *= factor; });
  return result;
}

void check_pressure(RunCheck const& check, double highest) {
  double const pressure = highest / area_of(check.data.sample);
  VALIDATE(
      pressure >= limits::least_pressure && pressure <= limits::largest_pressure,
      fmt::format("{}: the largest upper_punch_force, {:.6g} N in row {}, is {:.4g} MPa on the "
                  "die's area of {:.5g} mm^2 (powders are pressed at {:g} to {:g} MPa). Is its "
                  "unit, or that of the die's diameter, wrong by 1000?",
                  check.path, highest,
                  check.run.rows[largest_of(check.run.channel("upper_punch_force"))->place],
                  pressure / MPa, area_of(check.data.sample) / mm / mm,
                  limits::least_pressure / MPa, limits::largest_pressure / MPa));
}

/// Lower force, radial pressure and ejection force come from the same column of powder.
void check_other_channels(RunCheck const& check, double highest) {
  double const pressure = highest / area_of(check.data.sample);
  for (auto const& [name, values] : check.run.series) {
    auto const largest = largest_of(values);
    bool const is_force = name == "lower_punch_force" || name == "ejection_force";
    if (!largest || !(is_force || name == "wall_radial_pressure"))
      continue;
    double const factor = largest->value / (is_force ? highest : pressure);
    // An ejection force may be anything down to none.
    bool const may_be_small = name == "ejection_force" || largest->value <= 0.0;
    VALIDATE(may_be_small ? factor < limits::unit_factor : !is_off_by_1000(factor),
             fmt::format("{}: the largest {}, {:.6g} {} in row {}, is {:.3g} times what the upper "
                         "punch gives, {:.6g} {} (the same powder carries both). Is its unit wrong "
                         "by 1000?",
                         check.path, name, largest->value, is_force ? "N" : "Pa",
                         check.run.rows[largest->place], factor, is_force ? highest : pressure,
                         is_force ? "N" : "Pa"));
  }
}

void check_uncertainties(RunCheck const& check) {
  for (auto const& channel : check.data.channels) {
    auto const found = check.run.series.find(channel.name);
    auto const largest = found == check.run.series.end() ? std::nullopt : largest_of(found->second);
    auto const lowest = largest ? smallest_of(found->second) : std::nullopt;
    // A channel may be still: an ejection force that was not needed, a radial gauge that is loose.
    bool const must_speak = channel.name == "punch_gap" || channel.name == "upper_punch_force";
    if (!largest || !must_speak)
      continue;
    double const range = largest->value - lowest->value;
    bool const speaks = std::max(std::abs(largest->value), range) > channel.sd;
    VALIDATE(speaks, fmt::format("{}: the uncertainty of {}, {:.6g} {}, is above all its readings, "
                                 "up to {:.6g} {} (they say nothing then). Is its unit wrong?",
                                 check.path, channel.name, channel.sd, channel.unit, largest->value,
                                 channel.unit));
  }
}

std::string_view role_of(Run const& run) {
  return run.role == Role::held_out ? "held-out run" : "run";
}

/// How far the punch may have gone on between the reading at `k` and its neighbours [m].
double step_at(Run const& run, std::size_t k) {
  double const before = k > 0 ? run.time[k] - run.time[k - 1] : 0.0;
  double const after = k + 1 < run.time.size() ? run.time[k + 1] - run.time[k] : 0.0;
  return run.press.speed_down * std::max(before, after);
}

void check_end_gap(RunCheck const& check) {
  auto const& press = check.run.press;
  auto const low = *smallest_of(check.run.channel("punch_gap"));
  double const yield =
      frame_yield(check, largest_of(check.run.channel("upper_punch_force"))->value);
  double const room = limits::end_gap_share * (press.fill_height - press.end_gap) +
                      limits::noise_sds * check.data.channel("punch_gap")->sd;
  double const above = room + yield + step_at(check.run, low.place);
  VALIDATE(low.value >= press.end_gap - room && low.value <= press.end_gap + above,
           fmt::format("{}: the {}'s smallest punch_gap is {:.6g} mm, but its press block says "
                       "end_gap = {:.6g} mm (it may be {:.3g} mm below and {:.3g} mm above). Is it "
                       "the file of another run?",
                       check.path, role_of(check.run), low.value / mm, press.end_gap / mm,
                       room / mm, above / mm));
}

void check_speed(RunCheck const& check, Closing const& closing) {
  double const speed = check.run.press.speed_down;
  double const yield =
      frame_yield(check, largest_of(check.run.channel("upper_punch_force"))->value);
  double const fastest = speed * (1.0 + limits::speed_share);
  double const slowest = speed * (1.0 - limits::speed_share) - yield / closing.duration;
  VALIDATE(
      closing.speed <= fastest && closing.speed >= slowest,
      fmt::format(
          "{}: the {}'s gap closes at {:.4g} mm/s, but its press block says speed_down "
          "= {:.4g} mm/s ({:.0f} % may lie between). {}",
          check.path, role_of(check.run), closing.speed / mm, speed / mm, 100 * limits::speed_share,
          is_off_by_1000(closing.speed / speed) ? "Is the unit of the time, or of the speed, wrong?"
                                                : "Is it the file of another run?"));
}

} // namespace

void check_sample(Sample const& sample, PressProtocol const& press, std::string const& where) {
  double const density = sample.mass.value / (area_of(sample) * press.end_gap);
  VALIDATE(
      density >= limits::least_density && density <= limits::largest_density,
      fmt::format("{}: {:.6g} g in a die of {:.6g} mm at the end gap of {:.6g} mm makes {:.4g} "
                  "kg/m^3 (powders have {:g} to {:g}). Is a unit wrong by 1000?",
                  where, sample.mass.value / 1e-3, sample.die_diameter.value / mm,
                  press.end_gap / mm, density, limits::least_density, limits::largest_density));
}

void check_numbers(Sample const& sample, Run const& run, std::string const& where) {
  auto const number = [&](char const* name) {
    auto const found = run.scalars.find(name);
    return found == run.scalars.end() ? nullptr : &found->second;
  };
  auto const* const force = number("max_force");
  auto const *const height = number("compact_height"), *const porosity = number("porosity");
  VALIDATE(force && (height || porosity),
           fmt::format("{}: a run without a file has no {} (a curve is missing, so only numbers "
                       "can be held together: force, gap and compact). Add it to its scalars, or "
                       "a file?",
                       where, force ? "compact_height and no porosity" : "max_force"));
  double const pressure = force->value / area_of(sample);
  VALIDATE(pressure >= limits::least_pressure && pressure <= limits::largest_pressure,
           fmt::format("{}: max_force = {:.6g} N is {:.4g} MPa on the die's area (powders are "
                       "pressed at {:g} to {:g} MPa). Is its unit wrong by 1000?",
                       where, force->value, pressure / MPa, limits::least_pressure / MPa,
                       limits::largest_pressure / MPa));
  VALIDATE(!porosity || (porosity->value > 0.0 && porosity->value < 1.0),
           fmt::format("{}: porosity = {:g} is not between 0 and 1 (a share of the compact's "
                       "volume). Is it in per cent?",
                       where, porosity->value));
  VALIDATE(
      !height ||
          (height->value > 0.5 * run.press.end_gap && height->value < 2.0 * run.press.fill_height),
      fmt::format("{}: compact_height = {:.6g} mm does not belong to a bed of {:.6g} mm that "
                  "is pressed to {:.6g} mm. Is its unit wrong by 1000?",
                  where, height->value / mm, run.press.fill_height / mm, run.press.end_gap / mm));
}

void check_not_swapped(RunCheck const& check) {
  auto const& gap = check.run.series.at("punch_gap");
  auto const& force = check.run.series.at("upper_punch_force");
  if (fits(check, gap, force))
    return;
  double const gap_unit = check.table.unit_factors.at("punch_gap");
  double const force_unit = check.table.unit_factors.at("upper_punch_force");
  auto const other_gap = scaled(force, gap_unit / force_unit);
  auto const other_force = scaled(gap, force_unit / gap_unit);
  if (!fits(check, other_gap, other_force))
    return;
  throw dem::InvalidInput(
      fmt::format("{}: punch_gap goes up to {:.6g} m and upper_punch_force down to {:.6g} N; read "
                  "the other way "
                  "round they are a gap down to {:.6g} mm, where the press block says {:.6g} mm, "
                  "and a force up "
                  "to {:.6g} kN (gap and force are swapped). Swap the two names in the header?",
                  check.path, largest_of(gap)->value, smallest_of(force)->value,
                  smallest_of(other_gap)->value / mm, check.run.press.end_gap / mm,
                  largest_of(other_force)->value / kN));
}

void check_units(RunCheck const& check) {
  auto const low = *smallest_of(check.run.channel("punch_gap"));
  double const end_gap = check.run.press.end_gap;
  VALIDATE(low.value > 0.0,
           fmt::format("{}:{}: punch_gap = {:.6g} m is not positive (powder lies between the "
                       "punches). Is it a travel, or its zero wrong?",
                       check.path, check.run.rows[low.place], low.value));
  VALIDATE(
      !is_off_by_1000(low.value / end_gap),
      fmt::format("{}: the smallest punch_gap, {:.6g} m in row {}, is {:.3g} times the end gap "
                  "of the press block, {:.6g} m. Is its unit wrong by 1000?",
                  check.path, low.value, check.run.rows[low.place], low.value / end_gap, end_gap));
  double const highest = largest_of(check.run.channel("upper_punch_force"))->value;
  double const lowest = smallest_of(check.run.channel("upper_punch_force"))->value;
  VALIDATE(highest > 0.0 && -lowest < highest,
           fmt::format("{}: upper_punch_force goes from {:.6g} to {:.6g} N (compression is "
                       "positive). Is its sign turned?",
                       check.path, lowest, highest));
  check_pressure(check, highest);
  check_other_channels(check, highest);
  check_uncertainties(check);
}

void check_turning(RunCheck const& check) {
  auto const gap = check.run.channel("punch_gap");
  auto const low = *smallest_of(gap);
  auto const high = *largest_of(check.run.channel("upper_punch_force"));
  auto const& press = check.run.press;
  double const stroke = press.fill_height - press.end_gap;
  double const above = gap[high.place] - low.value;
  double const sd =
      std::hypot(check.data.channel("punch_gap")->sd, press.speed_down * check.run.clock_sd);
  VALIDATE(!(above > limits::turning_share * stroke + limits::noise_sds * sd),
           fmt::format("{}: upper_punch_force is highest in row {}, where punch_gap is {:.6g} mm, "
                       "but punch_gap is smallest in row {}, {:.6g} mm (a bed pushes hardest where "
                       "it is pressed most). Do the columns belong to one clock, and is the gap no "
                       "travel?",
                       check.path, check.run.rows[high.place], gap[high.place] / mm,
                       check.run.rows[low.place], low.value / mm));
}

std::string check_protocol(RunCheck const& check) {
  check_end_gap(check);
  auto const closing = closing_of(check.run);
  if (!closing)
    return "too few readings while the gap closes to check the speed";
  check_speed(check, *closing);
  return "";
}

} // namespace coupling::measured
