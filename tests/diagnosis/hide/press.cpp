#include "tests/diagnosis/hide/press.hpp"

#include "tests/diagnosis/hide/machine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hidden {
namespace {

/// Strips of a tilted punch: they stand side by side and exchange nothing. Gauss-Chebyshev points
/// of the second kind, whose weight is the width of a disc.
struct Strip {
  double offset; ///< [1] of half the tilt
  double weight; ///< share of the area
};
std::vector<Strip> strips(double tilt) {
  if (!(tilt > 0.0))
    return {{0.0, 1.0}};
  constexpr int n = 5;
  std::vector<Strip> all;
  for (int k = 1; k <= n; ++k) {
    double const angle = k * std::numbers::pi / (n + 1);
    all.push_back({std::cos(angle), 2.0 / (n + 1) * std::pow(std::sin(angle), 2)});
  }
  return all;
}

/// The strips under one punch.
class Bed {
public:
  Bed(Powder const& powder, Effects const& effects, Repeat const& repeat)
      : effects_(effects), strips_(strips(effects[Effect::punch_tilt])) {
    Powder own = powder;
    own.onset += repeat.packing;
    own.wall_friction *= 1.0 + repeat.friction;
    double const lost = effects[Effect::mass_error] * (1.0 + repeat.mass_error);
    columns_.assign(strips_.size(),
                    Column(BedLaw(own, effects), stated_mass * (1.0 + repeat.mass) * (1.0 + lost),
                           own.wall_stiffness, effects[Effect::die_compliance]));
  }
  ColumnForces tried(double height) const {
    ColumnForces sum;
    for (std::size_t k = 0; k < strips_.size(); ++k)
      add(columns_[k].tried(own_height(k, height), bore(height)), k, sum);
    return sum;
  }
  ColumnForces press(double height) {
    lowest_ = std::min(lowest_, height);
    ColumnForces sum;
    for (std::size_t k = 0; k < strips_.size(); ++k)
      add(columns_[k].press(own_height(k, height), bore(height)), k, sum);
    return sum;
  }
  /// The bed knows the wear where it was pressed, wherever the punch goes then.
  double bore(double height) const { return bore_at(effects_, std::min(lowest_, height)); }
  Column const& middle() const { return columns_[columns_.size() / 2]; }

private:
  double own_height(std::size_t k, double height) const {
    return height + 0.5 * effects_[Effect::punch_tilt] * strips_[k].offset;
  }
  void add(ColumnForces const& own, std::size_t k, ColumnForces& sum) const {
    double const weight = strips_[k].weight;
    sum.upper += weight * own.upper;
    sum.lower += weight * own.lower;
    sum.radial_top += weight * own.radial_top;
    sum.radial_bottom += weight * own.radial_bottom;
  }
  Effects effects_;
  std::vector<Strip> strips_;
  std::vector<Column> columns_;
  double lowest_ = std::numeric_limits<double>::infinity(); ///< height so far
};

/// Times at which the cycle is solved: fine where the force is, finest where friction turns round.
std::vector<double> solution_times(Protocol const& protocol) {
  std::vector<double> times;
  double const fill = protocol.fill_height, end = protocol.end_gap;
  double const near = std::min(12.5 * mm, fill);
  auto const closing = [&](double gap) { times.push_back((fill - gap) / protocol.speed_down); };
  for (int k = 0; k < 8; ++k)
    closing(fill + (near - fill) * k / 8.0);
  for (int k = 0; k <= 150; ++k)
    closing(near + (end - near) * k / 150.0);
  double const turn = protocol.closing_time(), away = turn + protocol.dwell;
  for (int k = 1; k <= 12 && protocol.dwell > 0.0; ++k)
    times.push_back(turn + protocol.dwell * std::pow(k / 12.0, 2));
  auto const opening = [&](double gap) { times.push_back(away + (gap - end) / protocol.speed_up); };
  for (int k = 1; k <= 100; ++k)
    opening(end + (near - end) * std::pow(k / 100.0, 2));
  for (int k = 1; k <= 8; ++k)
    opening(near + (fill - near) * k / 8.0);
  return times;
}

/// Where frame and bed agree, by regula falsi with Illinois' halving; h - free - D(F(h)) grows.
double agreed_height(Bed const& bed, Effects const& effects, double free, double factor) {
  auto const excess = [&](double height) {
    return height - free - frame_travel(effects, factor * bed.tried(height).upper);
  };
  double low = free, at_low = excess(low);
  if (at_low >= 0.0) // no force, or a frame that does not give way
    return free;
  double high = free - at_low, at_high = excess(high);
  double height = high;
  for (int k = 0; k < 60 && std::abs(at_high) > 1e-10 && high - low > 1e-12; ++k) {
    height = (low * at_high - high * at_low) / (at_high - at_low);
    double const at = excess(height);
    if (std::abs(at) < 1e-10)
      break;
    if (at < 0.0) {
      low = height, at_low = at, at_high *= 0.5;
    } else {
      high = height, at_high = at, at_low *= 0.5;
    }
  }
  return height;
}

} // namespace

double Protocol::gap_at(double time) const {
  double const turn = closing_time();
  if (time <= turn)
    return fill_height - speed_down * time;
  return std::min(end_gap + speed_up * std::max(0.0, time - turn - dwell), fill_height);
}

Cycle press_cycle(Powder const& powder, Effects const& effects, Protocol const& protocol,
                  Repeat const& repeat) {
  Bed bed(powder, effects, repeat);
  Cycle cycle;
  for (double const time : solution_times(protocol)) {
    double const factor = rate_factor(effects, protocol, time);
    double const free = protocol.gap_at(time) + repeat.zero + gap_error(effects, protocol, time);
    double const height = agreed_height(bed, effects, free, factor);
    auto const forces = bed.press(height);
    cycle.moments.push_back({.time = time,
                             .gap = protocol.gap_at(time),
                             .height = height,
                             .upper = factor * forces.upper,
                             .lower = factor * forces.lower,
                             .radial = 0.5 * factor * (forces.radial_top + forces.radial_bottom)});
  }
  double const bore = bed.bore(cycle.moments.back().height);
  cycle.compact_height = bed.middle().free_height(bore);
  cycle.ejection_force = bed.middle().ejection_force(bore);
  show_upper_force(effects, protocol, cycle.moments);
  for (auto& at : cycle.moments)
    at.upper += repeat.cell_zero;
  return cycle;
}

} // namespace hidden
