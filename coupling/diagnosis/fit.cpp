#include "coupling/diagnosis/fit.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double largest_damping = 1e8; // no step however short goes down: rounding is reached

/// The search's view of a hypothesis: residuals, slopes and which unknowns may move.
class Search {
public:
  Search(Comparison const& comparison, Unknowns const& unknowns, FitSettings const& settings,
         std::optional<HeldUnknown> held)
      : comparison_(comparison), unknowns_(unknowns), settings_(settings), low_(unknowns.low()),
        high_(unknowns.high()) {
    if (held)
      low_[held->place] = high_[held->place] = held->value;
  }

  VectorXd inside(VectorXd const& u) const { return u.cwiseMax(low_).cwiseMin(high_); }

  VectorXd predict(VectorXd const& u) const {
    return predict_rows(*comparison_.model, unknowns_.parameters(u), comparison_.target.size());
  }
  VectorXd residual(VectorXd const& predicted) const {
    return comparison_.whitener.whiten(comparison_.target - predicted);
  }

  MatrixXd slopes(VectorXd const& u) const {
    MatrixXd changes(comparison_.target.size(), u.size());
    for (Index k = 0; k < u.size(); ++k) {
      VectorXd more = u, less = u;
      // A held unknown's slope is wanted, too: it is differenced inside its own bounds.
      more[k] = std::min(u[k] + settings_.difference, unknowns_.high()[k]);
      less[k] = std::max(u[k] - settings_.difference, unknowns_.low()[k]);
      changes.col(k) = (predict(more) - predict(less)) / (more[k] - less[k]);
    }
    return comparison_.whitener.whiten(changes);
  }

  std::vector<Index> free(VectorXd const& u, VectorXd const& gradient) const {
    std::vector<Index> places;
    for (Index k = 0; k < u.size(); ++k)
      if (low_[k] < high_[k] && !(u[k] <= low_[k] && gradient[k] > 0.0) &&
          !(u[k] >= high_[k] && gradient[k] < 0.0))
        places.push_back(k);
    return places;
  }

private:
  Comparison const& comparison_;
  Unknowns const& unknowns_;
  FitSettings const& settings_;
  VectorXd low_, high_;
};

Fit at_start(Search const& search, Unknowns const& unknowns, VectorXd const& start) {
  Fit fit{};
  fit.active = unknowns.active();
  fit.unknowns = search.inside(start);
  fit.predicted = search.predict(fit.unknowns);
  fit.residual = search.residual(fit.predicted);
  fit.chi_squared = fit.residual.squaredNorm();
  fit.prior_sum = unknowns.prior_residual(fit.unknowns).squaredNorm();
  return fit;
}

/// One step downhill. @returns false if none can be made: the search is at rest
bool step_down(Search const& search, Unknowns const& unknowns, FitSettings const& settings,
               Fit& fit, double& damping) {
  VectorXd const& u = fit.unknowns;
  VectorXd const slope = unknowns.prior_slope(u);
  MatrixXd H = fit.slopes.transpose() * fit.slopes;
  H.diagonal() += slope.cwiseAbs2();
  VectorXd const gradient =
      slope.cwiseProduct(unknowns.prior_residual(u)) - fit.slopes.transpose() * fit.residual;
  auto const free = search.free(u, gradient);
  if (free.empty())
    return false;
  MatrixXd const A = H(free, free);
  VectorXd const g = gradient(free);
  for (; damping <= largest_damping; damping *= 4.0) {
    MatrixXd damped = A;
    damped.diagonal() *= 1.0 + damping;
    damped.diagonal().array() += 1e-12 * A.diagonal().maxCoeff() + 1e-300;
    VectorXd tried = u;
    tried(free) -= damped.ldlt().solve(g);
    tried = search.inside(tried);
    VectorXd const step = (tried - u)(free);
    if (-2.0 * g.dot(step) - step.dot(A * step) < settings.least_fall)
      return false;
    Fit next = at_start(search, unknowns, tried);
    if (next.objective() < fit.objective()) {
      fit = std::move(next);
      damping = std::max(damping / 10.0, 1e-8);
      return true;
    }
  }
  return false;
}

} // namespace

Fit fit_hypothesis(Comparison const& comparison, std::vector<int> const& active,
                   VectorXd const& start, FitSettings const& settings,
                   std::optional<HeldUnknown> held) {
  Unknowns const unknowns(*comparison.model, active, settings.size_priors);
  Search const search(comparison, unknowns, settings, held);
  Fit fit = at_start(search, unknowns, start);
  double damping = 1e-4;
  for (int step = 0; step < settings.most_steps && !fit.has_come_to_rest; ++step) {
    fit.slopes = search.slopes(fit.unknowns);
    fit.has_come_to_rest = !step_down(search, unknowns, settings, fit, damping);
  }
  if (fit.slopes.rows() == 0) // the last step moved away from where its slopes were taken
    fit.slopes = search.slopes(fit.unknowns);
  fit.at = unknowns.parameters(fit.unknowns);
  return fit;
}

Fit fit_baseline(Comparison const& comparison, FitSettings const& settings) {
  return fit_hypothesis(comparison, {},
                        VectorXd::Zero(static_cast<Index>(comparison.model->calibrated().size())),
                        settings);
}

} // namespace coupling::diagnosis
