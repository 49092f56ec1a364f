#include "coupling/study/calibration.hpp"

#include "coupling/study/calibration_misfit.hpp"
#include "coupling/study/calibration_words.hpp"
#include "coupling/study/distributions.hpp"
#include "coupling/study/profile.hpp"
#include "coupling/study/surface_extremes.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double at_bound = 1e-9; // of the range between the bounds

/// Where one target alone is met best: from the common optimum if that leads there, else anywhere.
BoxMinimum best_alone(CalibrationTarget const& target, SurfaceSpread spread, Box const& box,
                      VectorXd const& common) {
  auto const residuals = residuals_of(target, spread);
  auto near = minimise_from(residuals, box, common);
  auto best = minimise_in(residuals, box);
  return near.value <= best.value + 1e-9 ? near : best;
}

CalibratedTarget judge(CalibrationProblem const& problem, CalibrationTarget const& target,
                       Box const& box, VectorXd const& x) {
  auto const at = residual_of(target, problem.spread, x);
  auto const reach = extremes_of(target.surface, box.low, box.high);
  auto const alone = best_alone(target, problem.spread, box, x);
  return {.response = target.surface.data.response_name,
          .target = target.value,
          .target_sd = target.sd,
          .value = target.surface.value(x),
          .combined_sd = at.combined_sd,
          .residual = at.value,
          .lowest = reach.lowest,
          .highest = reach.highest,
          .is_reachable = reach.lowest <= target.value && target.value <= reach.highest,
          .residual_alone = residual_of(target, problem.spread, alone.x).value,
          .wanted = natural_of(problem.factors, alone.x)};
}

CalibratedFactor locate(CalibrationProblem const& problem, Box const& box, BoxMinimum const& best,
                        int f, int n_free) {
  auto const& factor = problem.factors[static_cast<std::size_t>(f)];
  double const value = natural_of(problem.factors, best.x)[static_cast<std::size_t>(f)];
  CalibratedFactor found{.name = factor.range.name,
                         .value = value,
                         .lower = value,
                         .upper = value,
                         .region_lower = value,
                         .region_upper = value,
                         .is_held = factor.held.has_value(),
                         .is_at_bound = false,
                         .is_open_low = false,
                         .is_open_high = false};
  if (factor.held)
    return found;
  auto const residuals = residuals_of(problem);
  auto const natural = [&](double coded) {
    return std::clamp(factor.range.to_natural(coded), factor.lowest, factor.highest);
  };
  auto const alone = profile_interval(residuals, box, best, f, chi_squared_quantile(0.95, 1));
  auto const joint = profile_interval(residuals, box, best, f, chi_squared_quantile(0.95, n_free));
  double const margin = at_bound * (box.high[f] - box.low[f]);
  found.lower = natural(alone.low);
  found.upper = natural(alone.high);
  found.region_lower = natural(joint.low);
  found.region_upper = natural(joint.high);
  found.is_at_bound = best.x[f] <= box.low[f] + margin || best.x[f] >= box.high[f] - margin;
  found.is_open_low = alone.is_open_low;
  found.is_open_high = alone.is_open_high;
  return found;
}

} // namespace

Calibration calibrate(CalibrationProblem const& problem) {
  validate_calibration(problem);
  Box const box = box_of(problem.factors);
  auto const best = minimise_in(residuals_of(problem), box);
  auto const n_free = static_cast<int>(
      std::ranges::count_if(problem.factors, [](auto const& one) { return !one.held; }));
  int const df = static_cast<int>(problem.targets.size()) - n_free;
  Calibration found{.factors = {},
                    .targets = {},
                    .chi_squared = best.value,
                    .df = df,
                    .p = chi_squared_p(best.value, df),
                    .region_threshold = best.value + chi_squared_quantile(0.95, n_free),
                    .contradicts = false,
                    .statements = {}};
  for (int f = 0; f < static_cast<int>(problem.factors.size()); ++f)
    found.factors.push_back(locate(problem, box, best, f, n_free));
  for (auto const& target : problem.targets)
    found.targets.push_back(judge(problem, target, box, best.x));
  found.contradicts =
      found.p < 0.05 || std::ranges::any_of(found.targets, [](CalibratedTarget const& one) {
        return std::abs(one.residual_alone) > normal_quantile(0.95);
      });
  found.statements = statements_on(problem, found);
  return found;
}

} // namespace coupling::study
