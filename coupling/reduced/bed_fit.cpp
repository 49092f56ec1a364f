#include "coupling/reduced/bed_fit.hpp"

#include "coupling/reduced/bed_forms.hpp"
#include "coupling/reduced/grouped_ratio.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

constexpr int most_groups = 32;
constexpr int n_knots = 64;
constexpr double far_enough =
    1.0 / 3.0;                 // share of the largest stress that unloading must fall below
constexpr double bears = 5e-3; // share of the largest stress from which ratios are taken
constexpr std::size_t least_opening = 8;

/// A cycle as the law sees it.
struct Rows {
  std::vector<double> height, phi, stress, wall, radial; ///< [m], [1], [Pa], [N], [Pa]
};

Rows rows_of(SimulatedCycle const& cycle, Bed const& bed, std::vector<std::size_t> const& records) {
  double const area = 0.25 * dem::pi * bed.bore * bed.bore;
  Rows rows;
  for (std::size_t const k : records) {
    rows.height.push_back(cycle.height[k]);
    rows.phi.push_back(bed.solid_area / cycle.height[k]);
    rows.stress.push_back(0.5 * (cycle.upper[k] + cycle.lower[k]) / area);
    rows.wall.push_back(cycle.upper[k] - cycle.lower[k]);
    rows.radial.push_back(cycle.radial_pressure[k]);
  }
  return rows;
}

/// What full friction of coefficient 1 would carry [N].
double grip(Bed const& bed, Rows const& rows, std::size_t k) {
  return rows.radial[k] * dem::pi * bed.bore * rows.height[k];
}

/// K, S, phi_c, n. @returns r.m.s. that the formula misses, share of the largest stress
double fit_stress(BedLaw& law, Rows const& rows, BedFitOptions const& options) {
  auto const form = fit_loading(weighted(rows.phi, rows.stress), options.onset, options.exponent);
  VALIDATE(form.stiffness > 0.0 && form.onset > 0.0 && form.onset < 1.0,
           fmt::format("simulated cycle: the best stiffness is {} Pa with an onset at {} (a bed "
                       "stiffens from a solid fraction between 0 and 1 on). Is the solid volume "
                       "right?",
                       form.stiffness, form.onset));
  law.stiffness = form.stiffness, law.cohesion = form.cohesion;
  law.onset = form.onset, law.exponent = form.exponent;
  double sum = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    double const missed = rows.stress[k] - form.at(rows.phi[k]);
    sum += missed * missed, largest = std::max(largest, rows.stress[k]);
  }
  return std::sqrt(sum / static_cast<double>(rows.phi.size())) / largest;
}

/// A table goes on to x as its last two knots say: groups end half a group before the records do.
Table up_to(Table table, double x) {
  std::size_t const last = table.knots.size() - 1;
  if (table.knots.size() < 2 || x <= table.knots[last])
    return table;
  double const slope =
      (table.values[last] - table.values[last - 1]) / (table.knots[last] - table.knots[last - 1]);
  table.values.push_back(table.values[last] + slope * (x - table.knots[last]));
  table.knots.push_back(x);
  return table;
}

Table relative(Table table, double to) {
  for (double& value : table.values)
    value /= to;
  return table;
}

/// What the stress's formula misses, from one record before the first that bears.
void fill_rest(BedLaw& law, Rows const& rows) {
  GroupedRatio missed;
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    double const x = rows.phi[k] - law.onset, beyond = std::max(x, 0.0);
    double const form = law.stiffness * std::pow(beyond, law.exponent) - law.cohesion * beyond;
    missed.add(x, (rows.stress[k] - form) / law.stiffness);
  }
  double const before = 2.0 * rows.phi[0] - rows.phi[1] - law.onset;
  law.loading_rest = up_to(missed.table(most_groups, before), rows.phi.back() - law.onset);
}

/// k, mu and how they change over x.
void fill_wall(BedLaw& law, Bed const& bed, Rows const& rows) {
  GroupedRatio radial, wall;
  double radial_sum = 0.0, stress_sum = 0.0, wall_sum = 0.0, grip_sum = 0.0;
  double const least = bears * *std::ranges::max_element(rows.stress);
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    if (rows.stress[k] < least)
      continue;
    double const x = rows.phi[k] - law.onset;
    radial.add(x, rows.radial[k], rows.stress[k]);
    wall.add(x, rows.wall[k], grip(bed, rows, k));
    radial_sum += rows.radial[k], stress_sum += rows.stress[k];
    wall_sum += rows.wall[k], grip_sum += grip(bed, rows, k);
  }
  double const end = rows.phi.back() - law.onset;
  law.radial_ratio = std::max(radial_sum / stress_sum, 0.0);
  law.wall_friction = grip_sum > 0.0 ? std::max(wall_sum / grip_sum, 0.0) : 0.0;
  if (law.radial_ratio > 0.0)
    law.radial_loading = relative(up_to(radial.table(most_groups), end), law.radial_ratio);
  if (law.wall_friction > 0.0)
    law.wall_loading = relative(up_to(wall.table(most_groups), end), law.wall_friction);
}

/// Knots from 0 to 1 that crowd at 1, where unloading begins steeply.
std::vector<double> opening_knots() {
  std::vector<double> knots;
  for (int k = 0; k <= n_knots; ++k)
    knots.push_back(1.0 - std::pow(1.0 - static_cast<double>(k) / n_knots, 1.6));
  return knots;
}

/// Shares of stress and radial pressure over g: formulas, plus means of what they miss.
void fill_opening(BedLaw& law, OpeningForm const& form, Rows const& rows, double most,
                  double radial_most) {
  GroupedRatio stress, radial;
  double const top = law.loading(most);
  auto const radial_form = [&](double g) { return std::sqrt(form.at_way_left(g)); };
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    double const g = 1.0 - (most - rows.phi[k]) / (form.recovery * (most - law.onset));
    if (g < 0.0)
      break;
    stress.add(g, rows.stress[k] / top - form.at_way_left(g));
    radial.add(g, rows.radial[k] / radial_most - radial_form(g));
  }
  auto const stress_rest = stress.table(most_groups, 0.0, 1.0);
  auto const radial_rest = radial.table(most_groups, {}, 1.0);
  double last = 0.0;
  for (double const g : opening_knots()) {
    last = g < 1.0 ? std::clamp(form.at_way_left(g) + stress_rest.at(g), last, 1.0) : 1.0;
    law.unloading.knots.push_back(g), law.unloading.values.push_back(last);
    law.radial_unloading.knots.push_back(g);
    law.radial_unloading.values.push_back(
        g < 1.0 ? std::max(radial_form(g) + radial_rest.at(g), 0.0) : 1.0);
  }
}

/// The wall's turn over h - h_m: formula, plus means of what it misses.
void fill_turn(BedLaw& law, Bed const& bed, Rows const& rows, double least_height, double most) {
  double const mu =
      law.wall_friction * (law.wall_loading.empty() ? 1.0 : law.wall_loading.at(most - law.onset));
  double const least = 0.02 * *std::ranges::max_element(rows.radial);
  std::vector<double> opened, turned, heavy;
  for (std::size_t k = 0; k < rows.phi.size() && rows.radial[k] > least; ++k) {
    opened.push_back(rows.height[k] - least_height);
    heavy.push_back(mu * grip(bed, rows, k));
    turned.push_back(rows.wall[k] / heavy.back());
  }
  if (!(mu > 0.0) || opened.size() < least_opening)
    return;
  auto curve = weighted(opened, turned);
  for (std::size_t k = 0; k < heavy.size(); ++k)
    curve.weight[k] *= heavy[k] * heavy[k] / (heavy[0] * heavy[0]);
  TurnForm const form = fit_turn(curve);
  GroupedRatio missed;
  for (std::size_t k = 0; k < heavy.size(); ++k)
    missed.add(opened[k], heavy[k] * (turned[k] - form.at(opened[k])), heavy[k]);
  auto const rest = missed.table(most_groups, 0.0);
  law.reversal = form.length;
  for (int k = 0; k <= n_knots; ++k) {
    // From 0 to the end, crowded at 0.
    double const z =
        form.length * std::expm1(std::log1p(opened.back() / form.length) * k / n_knots);
    law.wall_turn.knots.push_back(z);
    law.wall_turn.values.push_back(form.at(z) + rest.at(z));
  }
}

/// Everything about unloading. @returns false if the records do not say enough
bool fit_unloading(BedFit& fit, Bed const& bed, Rows const& rows, Rows const& turn) {
  BedLaw& law = fit.law;
  double const most = turn.phi[0], top = law.loading(most);
  if (rows.phi.empty()) {
    fit.statements.push_back("the cycle has no unloading: its curves stay the standard ones");
    return false;
  }
  double const lowest = *std::ranges::min_element(rows.stress);
  if (rows.phi.size() < least_opening || lowest > far_enough * top) {
    fit.statements.push_back(fmt::format(
        "unloading is recorded {} times, down to {:.0f} % of the largest stress (needed: {} and "
        "{:.0f} %): its curves stay the standard ones",
        rows.phi.size(), 100.0 * lowest / top, least_opening, 100.0 * far_enough));
    return false;
  }
  std::vector<double> gone{0.0}, share{1.0};
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    gone.push_back((most - rows.phi[k]) / (most - law.onset));
    share.push_back(rows.stress[k] / top);
    if (gone.back() > 1.0)
      break;
  }
  auto const curve = weighted(std::move(gone), std::move(share));
  OpeningForm const form = fit_opening(curve);
  double sum = 0.0;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    double const missed = curve.y[k] - form.at_way_left(1.0 - curve.x[k] / form.recovery);
    sum += missed * missed;
  }
  fit.opening_form = std::sqrt(sum / static_cast<double>(curve.x.size()));
  law.recovery = form.recovery, law.opening = form.slow;
  fill_opening(law, form, rows, most, turn.radial[0]);
  fill_turn(law, bed, rows, turn.height[0], most);
  return true;
}

/// Departures of both forces over some records; those where neither bears do not count.
void judge(BedLaw const& law, Bed const& bed, Rows const& rows, double smallest, double peak,
           Departure& upper, Departure& lower) {
  double const area = 0.25 * dem::pi * bed.bore * bed.bore;
  double squares_upper = 0.0, squares_lower = 0.0;
  int n = 0;
  for (std::size_t k = 0; k < rows.phi.size(); ++k) {
    auto const forces = bed_forces(law, bed, rows.height[k], std::min(smallest, rows.height[k]));
    double const measured = area * rows.stress[k];
    if (std::max(measured, 0.5 * (forces.upper + forces.lower)) < 1e-3 * peak)
      continue;
    double const u = (forces.upper - measured - 0.5 * rows.wall[k]) / peak;
    double const l = (forces.lower - measured + 0.5 * rows.wall[k]) / peak;
    squares_upper += u * u, squares_lower += l * l, ++n;
    upper.largest = std::max(upper.largest, std::abs(u));
    lower.largest = std::max(lower.largest, std::abs(l));
  }
  upper.rms = std::sqrt(squares_upper / std::max(n, 1));
  lower.rms = std::sqrt(squares_lower / std::max(n, 1));
}

} // namespace

BedFit fit_bed_law(SimulatedCycle const& cycle, Bed const& bed, BedFitOptions const& options) {
  VALIDATE(bed.solid_area > 0.0 && bed.bore > 0.0,
           fmt::format("bed: {} m of solid in a bore of {} m. Both must be positive?",
                       bed.solid_area, bed.bore));
  auto const parts = parts_of(cycle);
  auto const closing = rows_of(cycle, bed, parts.loading);
  auto const opening = rows_of(cycle, bed, parts.unloading);
  auto const turn = rows_of(cycle, bed, {parts.turn});
  BedFit fit;
  fit.n_loading = closing.phi.size();
  fit.loading_form = fit_stress(fit.law, closing, options);
  fill_rest(fit.law, closing);
  fill_wall(fit.law, bed, closing);
  double const peak = cycle.upper[parts.turn];
  judge(fit.law, bed, closing, cycle.height[0], peak, fit.loading_upper, fit.loading_lower);
  if (fit_unloading(fit, bed, opening, turn)) {
    fit.n_unloading = opening.phi.size();
    judge(fit.law, bed, opening, turn.height[0], peak, fit.unloading_upper, fit.unloading_lower);
  }
  validate(fit.law);
  return fit;
}

} // namespace coupling::reduced
