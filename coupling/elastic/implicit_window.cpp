#include "coupling/elastic/implicit_window.hpp"

#include "dem/step/advance.hpp"

#include <fmt/format.h>

#include <Eigen/QR>

#include <algorithm>

namespace coupling {
namespace {

constexpr double least_relaxation = 0.05, most_relaxation = 1.5;
constexpr double independent = 1e-7; // a column of V that the others explain but for this share

struct Trial {
  Eigen::VectorXd loads; ///< [N], means over the window
  double length;         ///< [s]
};

/// Runs the window with these loads at its end on a copy of the press.
Trial try_window(Press press, Eigen::VectorXd const& to, double length) {
  press.coupling.choose(press.world, to, length);
  double time = 0.0;
  for (std::uint64_t k = press.coupling.choice().window; k > 0; --k) {
    double const dt = press.programme.command_step(press.world);
    dem::advance_ahead(press.world, dt);
    press.programme.step_done(press.world);
    time += dt;
    if (press.programme.stage_has_ended(press.world))
      break;
  }
  return {.loads = press.coupling.mean_loads(press.world, time), .length = time};
}

} // namespace

Eigen::VectorXd FixedPointAccelerator::next(Eigen::VectorXd const& x, Eigen::VectorXd const& h) {
  Eigen::VectorXd const residual = h - x;
  Eigen::VectorXd const result = kind_ == Accelerator::iqn_ils && !residuals_.empty()
                                     ? quasi_newton(h, residual)
                                     : relaxed(x, residual);
  residuals_.insert(residuals_.begin(), residual);
  values_.insert(values_.begin(), h);
  return result;
}

Eigen::VectorXd FixedPointAccelerator::relaxed(Eigen::VectorXd const& x,
                                               Eigen::VectorXd const& residual) {
  if (!residuals_.empty()) {
    Eigen::VectorXd const change = residual - residuals_.front();
    double const square = change.squaredNorm();
    if (square > 0.0)
      relaxation_ = std::clamp(-relaxation_ * residuals_.front().dot(change) / square,
                               least_relaxation, most_relaxation);
  }
  return x + relaxation_ * residual;
}

Eigen::VectorXd FixedPointAccelerator::quasi_newton(Eigen::VectorXd const& h,
                                                    Eigen::VectorXd const& residual) {
  auto const n = static_cast<Eigen::Index>(residuals_.size());
  Eigen::MatrixXd V(h.size(), n), W(h.size(), n);
  for (Eigen::Index k = 0; k < n; ++k) {
    auto const i = static_cast<std::size_t>(k);
    V.col(k) = residual - residuals_[i];
    W.col(k) = h - values_[i];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(independent);
  qr.compute(V);
  Eigen::VectorXd const c = qr.solve(-residual);
  return h + W * c;
}

void find_course(Press& press) {
  ToolCoupling& tools = press.coupling;
  CouplingChoice const& choice = tools.choice();
  double length = static_cast<double>(choice.window) * press.programme.present_step();
  Eigen::VectorXd to = tools.predicted();
  FixedPointAccelerator accelerator(choice.accelerator, tools.first_relaxation());
  std::uint64_t n = 1;
  double const radius = *std::ranges::min_element(press.world.grains.radius);
  for (;; ++n) {
    Trial const trial = try_window(press, to, length);
    length = trial.length;
    Eigen::VectorXd const wanted = tools.wanted(trial.loads);
    if (tools.is_converged(to, wanted, radius))
      break;
    if (n == choice.most_iterations)
      throw dem::PhysicsGuard(fmt::format(
          "t = {:.6g} s, step {}: the window did not converge in {} iterations (loads change by "
          "{:.3g} of themselves, tolerance {:.3g}). A shorter 'Window', or more iterations?",
          press.world.time, press.world.step, n, (wanted - to).norm() / wanted.norm(),
          choice.tolerance));
    to = accelerator.next(to, wanted);
  }
  tools.choose(press.world, to, length);
  tools.count_iterations(n);
}

} // namespace coupling
