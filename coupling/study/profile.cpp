#include "coupling/study/profile.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace coupling::study {
namespace {

constexpr int n_steps = 32;
constexpr double precision = 1e-8; // of the box's width

struct End {
  double value;
  bool is_open;
};

/// One unknown's profile: the least sum of squares with it fixed.
class Profile {
public:
  Profile(ResidualsAt const& residuals, Box box, int unknown, double limit)
      : residuals_(residuals), box_(std::move(box)), unknown_(unknown), limit_(limit) {}

  /// The valley through `start`.
  std::optional<Eigen::VectorXd> inside_near(double value, Eigen::VectorXd const& start) const {
    return below_limit(minimise_from(residuals_, fixed(value), start));
  }
  /// That valley first, then all others.
  std::optional<Eigen::VectorXd> inside(double value, Eigen::VectorXd const& start) const {
    auto const near = inside_near(value, start);
    return near ? near : below_limit(minimise_in(residuals_, fixed(value)));
  }

private:
  Box fixed(double value) const {
    Box box = box_;
    box.low[unknown_] = box.high[unknown_] = value;
    return box;
  }
  std::optional<Eigen::VectorXd> below_limit(BoxMinimum const& found) const {
    return found.value <= limit_ ? std::optional(found.x) : std::nullopt;
  }

  ResidualsAt const& residuals_;
  Box box_;
  int unknown_;
  double limit_;
};

/// From the bound inwards to the first point inside, then back by bisection.
End find_end(Profile const& profile, Eigen::VectorXd const& best, double middle, double bound,
             double width) {
  double outside = bound, inside = middle;
  Eigen::VectorXd at_inside = best;
  for (int step = 0; step < n_steps; ++step) {
    double const value = bound + (middle - bound) * step / n_steps;
    if (auto const found = profile.inside(value, best)) {
      if (step == 0)
        return {bound, true};
      inside = value;
      at_inside = *found;
      break;
    }
    outside = value;
  }
  while (std::abs(inside - outside) > precision * width) {
    double const between = 0.5 * (inside + outside);
    if (auto const found = profile.inside_near(between, at_inside)) {
      inside = between;
      at_inside = *found;
    } else {
      outside = between;
    }
  }
  return {0.5 * (inside + outside), false};
}

} // namespace

ProfileInterval profile_interval(ResidualsAt const& residuals, Box const& box,
                                 BoxMinimum const& best, int unknown, double rise) {
  Profile const profile(residuals, box, unknown, best.value + rise);
  double const low_bound = box.low[unknown], high_bound = box.high[unknown];
  double const middle = best.x[unknown], width = high_bound - low_bound;
  auto const low = find_end(profile, best.x, middle, low_bound, width);
  auto const high = find_end(profile, best.x, middle, high_bound, width);
  return {low.value, high.value, low.is_open, high.is_open};
}

} // namespace coupling::study
