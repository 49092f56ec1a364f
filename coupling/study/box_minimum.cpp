#include "coupling/study/box_minimum.hpp"

#include "coupling/study/design.hpp"
#include "dem/expect.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace coupling::study {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int most_steps = 2000;
constexpr double is_zero = 1e-20;        // a sum of squares in standard deviations
constexpr double least_slope = 1e-11;    // of the value, over the width of the box
constexpr double largest_damping = 1e14; // no step however short goes down: rounding is reached

/// Unknowns that may move downhill.
std::vector<int> free_unknowns(VectorXd const& x, VectorXd const& slope, Box const& box) {
  std::vector<int> free;
  for (Index f = 0; f < x.size(); ++f) {
    bool const is_held = box.low[f] == box.high[f] || (x[f] <= box.low[f] && slope[f] > 0.0) ||
                         (x[f] >= box.high[f] && slope[f] < 0.0);
    if (!is_held)
      free.push_back(static_cast<int>(f));
  }
  return free;
}

VectorXd damped_step(Residuals const& at, VectorXd const& slope, std::vector<int> const& free,
                     double damping) {
  Eigen::MatrixXd const J = at.slopes(Eigen::all, free);
  Eigen::MatrixXd A = J.transpose() * J;
  // Marquardt's scaling, with a floor for unknowns that nothing hangs on.
  A.diagonal().array() +=
      damping * (A.diagonal().array() + 1e-8 * A.diagonal().maxCoeff() + 1e-300);
  return -A.ldlt().solve(VectorXd(slope(free)));
}

Eigen::MatrixXd coded_starts(int n_unknowns) {
  return n_unknowns <= 4 ? full_factorial(std::vector<int>(static_cast<std::size_t>(n_unknowns), 3))
                         : latin_hypercube(n_unknowns, 100, 1);
}

} // namespace

BoxMinimum minimise_from(ResidualsAt const& residuals, Box const& box, VectorXd const& start) {
  VectorXd x = start.cwiseMax(box.low).cwiseMin(box.high);
  Residuals at = residuals(x);
  double value = at.values.squaredNorm(), damping = 1e-3;
  for (int step = 0; step < most_steps; ++step) {
    VectorXd const slope = at.slopes.transpose() * at.values;
    auto const free = free_unknowns(x, slope, box);
    double fall = 0.0; // what a step over the whole box would promise
    for (int const f : free)
      fall = std::max(fall, std::abs(slope[f]) * (box.high[f] - box.low[f]));
    if (value <= is_zero || fall <= least_slope * value || damping > largest_damping)
      return {x, value};
    VectorXd tried = x;
    tried(free) += damped_step(at, slope, free, damping);
    tried = tried.cwiseMax(box.low).cwiseMin(box.high);
    Residuals next = residuals(tried);
    double const next_value = next.values.squaredNorm();
    if (next_value < value) {
      x = std::move(tried);
      at = std::move(next);
      value = next_value;
      damping = std::max(damping / 5.0, 1e-12);
    } else {
      damping *= 4.0;
    }
  }
  throw dem::PhysicsGuard(fmt::format(
      "calibration: has not come to rest after {} steps (sum of squares {:.6g}, damping "
      "{:.2g}). Are the targets' standard deviations of very different size?",
      most_steps, value, damping));
}

BoxMinimum minimise_in(ResidualsAt const& residuals, Box const& box) {
  std::vector<int> free;
  for (int f = 0; f < static_cast<int>(box.low.size()); ++f)
    if (box.low[f] < box.high[f])
      free.push_back(f);
  if (free.empty())
    return minimise_from(residuals, box, box.low);
  Eigen::MatrixXd const starts = coded_starts(static_cast<int>(free.size()));
  BoxMinimum best{{}, std::numeric_limits<double>::infinity()};
  for (Index s = 0; s < starts.rows(); ++s) {
    VectorXd start = box.low;
    VectorXd const share = 0.5 * (starts.row(s).transpose().array() + 1.0);
    start(free) += share.cwiseProduct(VectorXd((box.high - box.low)(free)));
    auto found = minimise_from(residuals, box, start);
    if (found.value < best.value * (1.0 - 1e-12)) // equals differ by rounding
      best = std::move(found);
  }
  return best;
}

} // namespace coupling::study
