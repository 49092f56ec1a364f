#include "coupling/reduced/unloading_fit.hpp"

#include "coupling/reduced/bed_forms.hpp"
#include "coupling/reduced/grouped_ratio.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

constexpr std::size_t most_groups = 32;
constexpr int n_knots = 64;
constexpr std::size_t least_records = 8;
constexpr double far_enough = 1.0 / 3.0; // of the largest stress: unloading must fall below
constexpr double grips = 0.02;           // of the largest radial pressure: the wall's turn is seen

bool says_enough(BedFit& fit, CycleRows const& rows, double top) {
  double const lowest = rows.size() > 0 ? *std::ranges::min_element(rows.stress) : top;
  if (rows.size() == 0)
    fit.statements.push_back("the cycle has no unloading: its curves stay the standard ones");
  else if (rows.size() < least_records || lowest > far_enough * top)
    fit.statements.push_back(fmt::format(
        "unloading is recorded {} times, down to {:.0f} % of the largest stress (needed: {} and "
        "{:.0f} %): its curves stay the standard ones",
        rows.size(), 100.0 * lowest / top, least_records, 100.0 * far_enough));
  return fit.statements.empty();
}

/// Shares of the stress over the way gone back, in units of the way to the onset.
WeightedCurve opening_curve(BedLaw const& law, CycleRows const& rows, double most, double top) {
  std::vector<double> gone{0.0}, share{1.0};
  for (std::size_t k = 0; k < rows.size() && gone.back() <= 1.0; ++k) {
    gone.push_back(std::log(most / rows.phi[k]) / std::log(most / law.onset));
    share.push_back(rows.stress[k] / top);
  }
  return weighted(std::move(gone), std::move(share));
}

/// Knots from 0 to 1 that crowd at 1, where unloading begins steeply.
std::vector<double> opening_knots() {
  std::vector<double> knots;
  for (int k = 0; k <= n_knots; ++k)
    knots.push_back(1.0 - std::pow(1.0 - static_cast<double>(k) / n_knots, 1.6));
  return knots;
}

/// A formula plus means of what it misses, over g; 1 at 1.
template <class FormOf>
Table filled(FormOf const& form, Table const& missed, std::vector<double> const& knots) {
  Table table{knots, {}};
  for (double const g : knots)
    table.values.push_back(g < 1.0 ? std::clamp(form(g) + missed.at(g), 0.0, 1.0) : 1.0);
  return table;
}

/// Shares of stress and radial pressure over g.
void fill_opening(BedLaw& law, OpeningForm const& form, CycleRows const& rows,
                  CycleRows const& turn) {
  GroupedRatio stress, radial;
  double const most = turn.phi[0], top = law.loading(most);
  auto const share = [&](double g) { return form.at_way_left(g); };
  auto const root = [&](double g) { return std::sqrt(form.at_way_left(g)); };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    double const g =
        1.0 - std::log(most / rows.phi[k]) / (form.recovery * std::log(most / law.onset));
    if (g < 0.0)
      break;
    stress.add(g, rows.stress[k] / top - share(g));
    radial.add(g, rows.radial[k] / turn.radial[0] - root(g));
  }
  law.unloading = filled(share, stress.table(most_groups, 0.0, 1.0), opening_knots());
  double last = 0.0; // a bed that opens never presses more
  for (double& value : law.unloading.values)
    value = last = std::max(value, last);
  if (turn.radial[0] > 0.0)
    law.radial_unloading = filled(root, radial.table(most_groups, {}, 1.0), opening_knots());
}

/// The wall's turn over h - h_m.
void fill_turn(BedLaw& law, CycleRows const& rows, CycleRows const& turn) {
  double const x = turn.phi[0] - law.onset;
  double const mu = law.wall_friction * (law.wall_loading.empty() ? 1.0 : law.wall_loading.at(x));
  std::vector<double> opened, turned, heavy;
  for (std::size_t k = 0; k < rows.size() && rows.radial[k] > grips * turn.radial[0]; ++k) {
    opened.push_back(rows.height[k] - turn.height[0]);
    heavy.push_back(mu * rows.grip[k]);
    turned.push_back(rows.wall[k] / heavy.back());
  }
  if (!(mu > 0.0) || opened.size() < least_records)
    return;
  auto curve = weighted(opened, turned);
  for (std::size_t k = 0; k < heavy.size(); ++k)
    curve.weight[k] *= std::pow(heavy[k] / heavy[0], 2);
  TurnForm const form = fit_turn_form(curve);
  GroupedRatio missed;
  for (std::size_t k = 0; k < heavy.size(); ++k)
    missed.add(opened[k], heavy[k] * (turned[k] - form.at(opened[k])), heavy[k]);
  auto const rest = missed.table(most_groups, 0.0);
  law.reversal = form.length, law.turn_pressure = turn.radial[0];
  law.turn_friction = law.wall_friction;
  law.wall_turn = {};
  for (int k = 0; k <= n_knots; ++k) { // crowded at 0
    double const z =
        form.length * std::expm1(std::log1p(opened.back() / form.length) * k / n_knots);
    law.wall_turn.knots.push_back(z);
    law.wall_turn.values.push_back(form.at(z) + rest.at(z));
  }
}

/// Root of the mean square of what a curve over g misses.
template <class FormOf>
double missed_by(WeightedCurve const& curve, double recovery, FormOf const& form) {
  double sum = 0.0;
  for (std::size_t k = 0; k < curve.x.size(); ++k)
    sum += std::pow(curve.y[k] - form(1.0 - curve.x[k] / recovery), 2);
  return std::sqrt(sum / static_cast<double>(curve.x.size()));
}

} // namespace

bool fit_unloading(BedFit& fit, CycleRows const& rows, CycleRows const& turn,
                   BedFitOptions const& options) {
  BedLaw& law = fit.law;
  if (options.shape) {
    law.unloading = options.shape->unloading,
    law.radial_unloading = options.shape->radial_unloading;
    law.wall_turn = options.shape->wall_turn, law.opening = options.shape->opening;
    law.recovery = options.shape->recovery, law.reversal = options.shape->reversal;
    law.turn_pressure = options.shape->turn_pressure;
    law.turn_friction = options.shape->turn_friction;
  }
  // A known shape need not meet the largest stress exactly; its own table does.
  double const top = options.shape ? turn.stress[0] : law.loading(turn.phi[0]);
  if (!says_enough(fit, rows, top))
    return false;
  auto const curve = opening_curve(law, rows, turn.phi[0], top);
  if (!law.unloading.empty()) {
    auto const change = fit_stretch(curve, law.unloading);
    law.recovery = change.recovery, law.opening = change.power;
    fit.opening_form = missed_by(curve, change.recovery, [&](double g) {
      return std::pow(law.unloading.at(g), change.power);
    });
    return true;
  }
  OpeningForm const form = fit_opening_form(curve);
  fit.opening_form = missed_by(curve, form.recovery, [&](double g) { return form.at_way_left(g); });
  law.recovery = form.recovery, law.opening = 1.0;
  fill_opening(law, form, rows, turn);
  fill_turn(law, rows, turn);
  return true;
}

} // namespace coupling::reduced
