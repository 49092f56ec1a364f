#include "coupling/reduced/bed_forms.hpp"

#include "coupling/reduced/difference_slopes.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double unit = 1e-3; // of the largest |y|: what counts as one deviation

Eigen::Map<VectorXd const> view(std::vector<double> const& values) {
  return {values.data(), static_cast<Index>(values.size())};
}

/// Linear coefficient of `basis` in least squares of y, inside bounds.
double coefficient(VectorXd const& basis, VectorXd const& y, double low, double high) {
  double const size = basis.squaredNorm();
  return size > 0.0 ? std::clamp(basis.dot(y) / size, low, high) : low;
}

VectorXd root_weights(WeightedCurve const& curve) {
  return view(curve.weight).cwiseSqrt() /
         (unit * std::max(view(curve.y).cwiseAbs().maxCoeff(), 1e-300));
}

LoadingForm loading_form(WeightedCurve const& curve, VectorXd const& root, LoadingHeld const& held,
                         double c, double n) {
  VectorXd const beyond = (view(curve.x).array() - c).max(0.0);
  VectorXd power = beyond.array().pow(n);
  if (!held.rest.empty())
    for (Index k = 0; k < power.size(); ++k)
      power[k] += held.rest.at(curve.x[static_cast<std::size_t>(k)] - c);
  power.array() *= root.array();
  VectorXd const line = -root.cwiseProduct(beyond);
  VectorXd const y = root.cwiseProduct(view(curve.y));
  Eigen::Matrix2d const A{{power.dot(power), power.dot(line)}, {power.dot(line), line.dot(line)}};
  Eigen::Vector2d const both = A.ldlt().solve(Eigen::Vector2d(power.dot(y), line.dot(y)));
  if (both.allFinite() && both[1] > 0.0)
    return {both[0], both[1], c, n, held.rest};
  return {power.dot(y) / std::max(power.dot(power), 1e-300), 0.0, c, n, held.rest};
}

OpeningForm opening_form(WeightedCurve const& curve, VectorXd const& root, VectorXd const& u) {
  OpeningForm form{u[0], 0.0, u[1], u[2]};
  Eigen::ArrayXd const g = (1.0 - view(curve.x).array() / u[0]).max(0.0);
  Eigen::ArrayXd const quick = g.pow(u[2]);
  form.share = coefficient(root.array() * (g.pow(u[1]) - quick),
                           root.array() * (view(curve.y).array() - quick), 0.0, 1.0);
  return form;
}

TurnForm turn_form(WeightedCurve const& curve, VectorXd const& root, double length) {
  Eigen::ArrayXd const left = (-view(curve.x).array() / length).exp();
  return {coefficient(root.array() * (1.0 - left), root.array() * (view(curve.y).array() - left),
                      -1.0, 0.0),
          length};
}

/// Nonlinear unknowns of least weighted squares in a box.
/// @param form_of  u -> (x -> y)
template <class FormOf>
VectorXd least(WeightedCurve const& curve, VectorXd const& root, study::Box const& box,
               FormOf const& form_of) {
  auto const residual = [&](VectorXd const& u) {
    auto const form = form_of(u);
    VectorXd missed(root.size());
    for (Index k = 0; k < root.size(); ++k) {
      auto const i = static_cast<std::size_t>(k);
      missed[k] = root[k] * (curve.y[i] - form(curve.x[i]));
    }
    return missed;
  };
  return study::minimise_in(with_difference_slopes(residual, box), box).x;
}

} // namespace

double LoadingForm::at(double x) const {
  double const beyond = std::max(x - onset, 0.0);
  double const missed = rest.empty() ? 0.0 : rest.at(x - onset);
  return stiffness * (std::pow(beyond, exponent) + missed) - cohesion * beyond;
}

double OpeningForm::at_way_left(double g) const {
  return g > 0.0 ? share * std::pow(g, slow) + (1.0 - share) * std::pow(g, quick) : 0.0;
}

double TurnForm::at(double z) const {
  return end + (1.0 - end) * std::exp(-z / length);
}

WeightedCurve weighted(std::vector<double> x, std::vector<double> y) {
  std::size_t const last = x.size() - 1;
  std::vector<double> weight(x.size());
  for (std::size_t k = 0; k <= last; ++k)
    weight[k] =
        0.5 * std::abs((x[std::min(k + 1, last)] - x[k > 0 ? k - 1 : 0]) / (x[last] - x[0]));
  return {std::move(x), std::move(y), std::move(weight)};
}

LoadingForm fit_loading_form(WeightedCurve const& curve, LoadingHeld const& held) {
  VectorXd const root = root_weights(curve);
  double const first = curve.x.front(), way = curve.x.back() - first;
  // Where the first point bears, the onset lies behind, unless the rest bears before it.
  study::Box box{Eigen::Vector2d(first - 0.5 * way, 1.05),
                 Eigen::Vector2d(held.rest.empty() ? first : first + 0.25 * way, 4.0)};
  if (held.onset)
    box.low[0] = box.high[0] = *held.onset;
  if (held.exponent)
    box.low[1] = box.high[1] = *held.exponent;
  auto const form = [&](VectorXd const& u) { return loading_form(curve, root, held, u[0], u[1]); };
  return form(least(curve, root, box, [&](VectorXd const& u) {
    return [at = form(u)](double x) { return at.at(x); };
  }));
}

OpeningForm fit_opening_form(WeightedCurve const& curve) {
  VectorXd const root = root_weights(curve);
  study::Box const box{Eigen::Vector3d(0.1, 1.0, 6.0), Eigen::Vector3d(1.4, 6.0, 60.0)};
  return opening_form(curve, root, least(curve, root, box, [&](VectorXd const& u) {
                        return [at = opening_form(curve, root, u)](double z) {
                          return at.at_way_left(1.0 - z / at.recovery);
                        };
                      }));
}

Stretch fit_stretch(WeightedCurve const& curve, Table const& shape) {
  VectorXd const root = root_weights(curve);
  study::Box const box{Eigen::Vector2d(0.1, 0.3), Eigen::Vector2d(1.5, 3.0)};
  VectorXd const u = least(curve, root, box, [&](VectorXd const& at) {
    return [&shape, r = at[0], p = at[1]](double z) { return std::pow(shape.at(1.0 - z / r), p); };
  });
  return {u[0], u[1]};
}

TurnForm fit_turn_form(WeightedCurve const& curve) {
  VectorXd const root = root_weights(curve);
  // In logarithms; between the turn and the first point nothing is known.
  study::Box const box{VectorXd::Constant(1, std::log(0.5 * curve.x.front())),
                       VectorXd::Constant(1, std::log(curve.x.back()))};
  auto const form = [&](VectorXd const& u) { return turn_form(curve, root, std::exp(u[0])); };
  return form(least(curve, root, box, [&](VectorXd const& u) {
    return [at = form(u)](double z) { return at.at(z); };
  }));
}

} // namespace coupling::reduced
