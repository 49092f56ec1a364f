#include "coupling/reduced/loading_fit.hpp"

#include "coupling/reduced/bed_forms.hpp"
#include "coupling/reduced/grouped_ratio.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

constexpr std::size_t most_groups = 32;
constexpr double bears = 5e-3; // share of the largest stress from which ratios are taken

/// K, S, phi_c, n.
double fit_stress(BedLaw& law, CycleRows const& rows, BedFitOptions const& options) {
  auto const form = fit_loading_form(
      weighted(rows.phi, rows.stress),
      {options.onset, options.exponent, options.shape ? options.shape->loading_rest : Table{}});
  VALIDATE(form.stiffness > 0.0 && form.onset > 0.0 && form.onset < 1.0,
           fmt::format("simulated cycle: the best stiffness is {} Pa with an onset at {} (a bed "
                       "stiffens from a solid fraction between 0 and 1 on). Is the solid volume "
                       "right?",
                       form.stiffness, form.onset));
  law.stiffness = form.stiffness, law.cohesion = form.cohesion;
  law.onset = form.onset, law.exponent = form.exponent, law.loading_rest = form.rest;
  double sum = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k)
    sum += std::pow(rows.stress[k] - form.at(rows.phi[k]), 2);
  return std::sqrt(sum / static_cast<double>(rows.size())) / rows.largest_stress();
}

/// A table goes on to x as its last two knots say: groups end half a group before the records do.
Table up_to(Table table, double x) {
  if (table.knots.size() < 2 || x <= table.knots.back())
    return table;
  std::size_t const last = table.knots.size() - 1;
  double const slope =
      (table.values[last] - table.values[last - 1]) / (table.knots[last] - table.knots[last - 1]);
  table.values.push_back(table.values[last] + slope * (x - table.knots[last]));
  table.knots.push_back(x);
  return table;
}

/// What the stress's formula misses, from one record before the first that bears.
Table missed_stress(BedLaw const& law, CycleRows const& rows) {
  LoadingForm const form{law.stiffness, law.cohesion, law.onset, law.exponent, {}};
  GroupedRatio missed;
  for (std::size_t k = 0; k < rows.size(); ++k)
    missed.add(rows.phi[k] - law.onset, (rows.stress[k] - form.at(rows.phi[k])) / law.stiffness);
  double const before = 2.0 * rows.phi[0] - rows.phi[1] - law.onset;
  return up_to(missed.table(most_groups, before), rows.phi.back() - law.onset);
}

/// A coefficient and how it changes over x, from numerators and denominators of records.
struct Coefficient {
  double whole = 0.0; ///< [1], >= 0
  Table change;       ///< factor on it [1]
};

/// @param held  factor that is known; empty: it is sought
Coefficient coefficient(BedLaw const& law, CycleRows const& rows, Table const& held,
                        std::vector<double> const& numerator,
                        std::vector<double> const& denominator) {
  GroupedRatio ratio;
  double above = 0.0, below = 0.0;
  double const least = bears * rows.largest_stress();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows.stress[k] < least)
      continue;
    double const x = rows.phi[k] - law.onset;
    ratio.add(x, numerator[k], denominator[k]);
    above += numerator[k];
    below += held.empty() ? denominator[k] : denominator[k] * held.at(x);
  }
  Coefficient found{below > 0.0 ? std::max(above / below, 0.0) : 0.0, held};
  if (found.whole == 0.0 || !held.empty())
    return found;
  found.change = up_to(ratio.table(most_groups), rows.phi.back() - law.onset);
  for (double& value : found.change.values)
    value /= found.whole;
  return found;
}

} // namespace

double fit_loading(BedLaw& law, CycleRows const& rows, BedFitOptions const& options) {
  double const missed = fit_stress(law, rows, options);
  if (!options.shape)
    law.loading_rest = missed_stress(law, rows);
  BedLaw const held = options.shape.value_or(BedLaw{});
  auto const radial = coefficient(law, rows, held.radial_loading, rows.radial, rows.stress);
  auto const wall = coefficient(law, rows, held.wall_loading, rows.wall, rows.grip);
  law.radial_ratio = radial.whole, law.radial_loading = radial.change;
  law.wall_friction = wall.whole, law.wall_loading = wall.change;
  return missed;
}

} // namespace coupling::reduced
