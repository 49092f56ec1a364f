#include "coupling/diagnosis/size_interval.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;

constexpr int n_halvings = 12;

/// Profile of one unknown, each point begun at the one before.
class Profile {
public:
  Profile(Comparison const& comparison, Fit best, Index place, double allowed)
      : comparison_(comparison), best_(std::move(best)), place_(place), allowed_(allowed) {}

  bool allows(double u) {
    auto start = near_.value_or(best_).unknowns;
    start[place_] = u;
    Fit fit = fit_hypothesis(comparison_, best_.active, start, {.size_priors = SizePriors::flat},
                             HeldUnknown{place_, u});
    bool const is_allowed = fit.objective() - best_.objective() <= allowed_;
    if (is_allowed)
      near_ = std::move(fit);
    return is_allowed;
  }

  /// The end on one side, and whether it is open at `bound`.
  std::pair<double, bool> end(double first_step, double bound) {
    near_.reset();
    double inside = best_.unknowns[place_], step = first_step;
    double outside = inside;
    for (;;) {
      outside = first_step > 0.0 ? std::min(inside + step, bound) : std::max(inside + step, bound);
      if (outside == inside)
        return {bound, true};
      if (!allows(outside))
        break;
      if (outside == bound)
        return {bound, true};
      inside = outside;
      step *= 2.0;
    }
    for (int k = 0; k < n_halvings; ++k) {
      double const middle = 0.5 * (inside + outside);
      (allows(middle) ? inside : outside) = middle;
    }
    return {0.5 * (inside + outside), false};
  }

private:
  Comparison const& comparison_;
  Fit best_;
  Index place_;
  double allowed_;
  std::optional<Fit> near_;
};

} // namespace

SizeInterval size_interval(Comparison const& comparison, Fit const& fit, int mechanism,
                           double tempering, double rise, double widest) {
  FitSettings const flat{.size_priors = SizePriors::flat};
  Unknowns const unknowns(*comparison.model, fit.active, SizePriors::flat);
  Index const place = unknowns.place_of_size(mechanism);
  Fit best = fit_hypothesis(comparison, fit.active, fit.unknowns, flat);
  double const scale = comparison.model->mechanisms()[static_cast<std::size_t>(mechanism)].scale;
  double const u = best.unknowns[place];
  // One standard uncertainty, were the others known: the profile is wider, so it is a first step.
  double const step =
      std::clamp(1.0 / std::max(best.slopes.col(place).norm(), 1e-12), 1e-6, widest);
  Profile profile(comparison, std::move(best), place, rise * tempering);
  auto const [low, is_open_low] =
      profile.end(-step, std::max(unknowns.low()[place], std::min(u, -widest)));
  auto const [high, is_open_high] =
      profile.end(step, std::min(unknowns.high()[place], std::max(u, widest)));
  return {scale * u, scale * low, scale * high, is_open_low, is_open_high};
}

} // namespace coupling::diagnosis
