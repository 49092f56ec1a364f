#include "coupling/reduced/grain_effects.hpp"

#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/cycle_rows.hpp"
#include "coupling/reduced/difference_slopes.hpp"
#include "dem/expect.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coupling::reduced {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double rearrangement = 3e-3; // of the largest stress: how two packings depart
constexpr double n_independent = 6.0;  // parts of the way that rearrange on their own
Eigen::Vector4d const spread(0.1, 0.3, 0.005, 0.05); // of ln K, ln S, phi_c, n

/// Residuals of first loading with equal weight along the way, in standard deviations.
VectorXd loading_departure(BedLaw const& law, CycleRows const& rows) {
  double const sigma = rearrangement * rows.largest_stress();
  double const scale = std::sqrt(n_independent / static_cast<double>(rows.size())) / sigma;
  VectorXd departure(static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k)
    departure[static_cast<Index>(k)] = scale * (rows.stress[k] - law.loading(rows.phi[k]));
  return departure;
}

CycleRows first_loading(SimulatedCycle const& cycle, Bed const& bed) {
  return rows_of(cycle, bed, parts_of(cycle).loading);
}

/// r, p, k, mu of a cycle for given phi_c and n.
BedLaw refit(BedLaw const& base, BedLaw const& loading, SimulatedCycle const& cycle,
             Bed const& bed) {
  return fit_bed_law(cycle, bed,
                     {.onset = loading.onset, .exponent = loading.exponent, .shape = base})
      .law;
}

/// Mean square of what a law misses of both forces in both directions, in shares of the peak.
double mean_square(BedLaw const& law, SimulatedCycle const& cycle, Bed const& bed) {
  auto const missed = departures(law, cycle, bed);
  return 0.25 * (std::pow(missed.loading_upper.rms, 2) + std::pow(missed.loading_lower.rms, 2) +
                 std::pow(missed.unloading_upper.rms, 2) + std::pow(missed.unloading_lower.rms, 2));
}

BedNumbers scaled(BedNumbers numbers, double by) {
  for (double& number : numbers)
    number *= by;
  return numbers;
}

} // namespace

BedLaw changed(BedLaw law, BedNumbers const& by) {
  law.stiffness *= std::exp(by[0]);
  law.cohesion *= std::exp(by[1]);
  law.onset += by[2];
  law.exponent = std::max(law.exponent + by[3], 1.0);
  law.recovery += by[4];
  law.opening *= std::exp(by[5]);
  law.wall_friction = std::max(law.wall_friction + by[6], 0.0);
  law.radial_ratio = std::max(law.radial_ratio + by[7], 0.0);
  return law;
}

BedNumbers change_of_numbers(BedLaw const& base, SimulatedCycle const& cycle, Bed const& bed) {
  auto const rows = first_loading(cycle, bed);
  auto const with = [&](VectorXd const& u) {
    return changed(base, {spread[0] * u[0], spread[1] * u[1], spread[2] * u[2], spread[3] * u[3]});
  };
  auto const residual = [&](VectorXd const& u) {
    VectorXd all(static_cast<Index>(rows.size()) + u.size());
    all << loading_departure(with(u), rows), u;
    return all;
  };
  study::Box const box{VectorXd::Constant(4, -6.0), VectorXd::Constant(4, 6.0)};
  VectorXd const u =
      study::minimise_from(with_difference_slopes(residual, box), box, VectorXd::Zero(4)).x;
  BedLaw const own = refit(base, with(u), cycle, bed); // r is of the way to the onset found
  return {spread[0] * u[0],
          spread[1] * u[1],
          spread[2] * u[2],
          spread[3] * u[3],
          own.recovery - base.recovery,
          std::log(own.opening / base.opening),
          own.wall_friction - base.wall_friction,
          own.radial_ratio - base.radial_ratio};
}

PlasticChange plastic_change(BedLaw const& base, SimulatedCycle const& cycle, Bed const& bed) {
  auto const rows = first_loading(cycle, bed);
  auto const with = [&](VectorXd const& u) {
    BedLaw law = base;
    law.yielding = {.size = u[0], .stress = std::exp(u[1])};
    return law;
  };
  double const largest = rows.largest_stress();
  study::Box const box{Eigen::Vector2d(-0.5, std::log(0.02 * largest)),
                       Eigen::Vector2d(1.0, std::log(2.0 * largest))};
  auto const residual = [&](VectorXd const& u) { return loading_departure(with(u), rows); };
  VectorXd const u = study::minimise_from(with_difference_slopes(residual, box), box,
                                          Eigen::Vector2d(0.1, std::log(0.2 * largest)))
                         .x;
  BedLaw const own = refit(base, base, cycle, bed);
  return {.yielding = with(u).yielding,
          .recovery = own.recovery - base.recovery,
          .ln_opening = std::log(own.opening / base.opening)};
}

GrainEffect measure_effect(GrainEffect effect, std::span<PairedCycles const> seeds,
                           Bed const& bed) {
  VALIDATE(seeds.size() >= 2 && effect.low < effect.middle && effect.middle < effect.high,
           fmt::format("grain effect {}: {} seeds at {}, {}, {} (two seeds tell how far to trust "
                       "it, and values rise). Is a run missing?",
                       effect.factor, seeds.size(), effect.low, effect.middle, effect.high));
  double const n = static_cast<double>(seeds.size());
  std::vector<BedLaw> middles;
  std::vector<BedNumbers> slopes;
  for (auto const& seed : seeds) {
    middles.push_back(fit_bed_law(seed.middle, bed).law);
    auto const low = change_of_numbers(middles.back(), seed.low, bed);
    auto slope = change_of_numbers(middles.back(), seed.high, bed);
    for (std::size_t k = 0; k < slope.size(); ++k)
      slope[k] = (slope[k] - low[k]) / (effect.high - effect.low);
    slopes.push_back(slope);
  }
  effect.n_seeds = seeds.size();
  for (std::size_t k = 0; k < bed_numbers.size(); ++k) {
    double sum = 0.0, squares = 0.0;
    for (auto const& slope : slopes)
      sum += slope[k];
    effect.slope[k] = sum / n;
    for (auto const& slope : slopes)
      squares += std::pow(slope[k] - effect.slope[k], 2);
    effect.error[k] = std::sqrt(squares / (n * (n - 1.0)));
  }
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    for (auto const& [cycle, value] :
         {std::pair{&seeds[i].low, effect.low}, std::pair{&seeds[i].high, effect.high}}) {
      before += mean_square(middles[i], *cycle, bed) / (2.0 * n);
      after += mean_square(changed(middles[i], scaled(effect.slope, value - effect.middle)), *cycle,
                           bed) /
               (2.0 * n);
    }
  effect.before = std::sqrt(before), effect.after = std::sqrt(after);
  return effect;
}

} // namespace coupling::reduced
