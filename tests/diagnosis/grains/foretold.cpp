#include "tests/diagnosis/grains/foretold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

using Eigen::VectorXd;

constexpr double opened_gap = 8.3 * mm; ///< where the pilot turns that stands for a wider bed
constexpr int n_closing = 24, n_opening = 16, n_channels = 3;

/// Readings of one channel at given gaps, linear between the moments of a stroke.
VectorXd at_gaps(std::vector<Moment> const& stroke, double Moment::*reading,
                 std::vector<double> const& gaps) {
  VectorXd values(static_cast<Eigen::Index>(gaps.size()));
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    // By falling gap.
    auto const after =
        std::ranges::lower_bound(stroke, -gaps[k], {}, [](auto& at) { return -at.gap; });
    auto const next = std::clamp(after, stroke.begin() + 1, stroke.end() - 1), before = next - 1;
    double const share =
        std::clamp((before->gap - gaps[k]) / std::max(before->gap - next->gap, 1e-12), 0.0, 1.0);
    values[static_cast<Eigen::Index>(k)] =
        (*before).*reading + share * ((*next).*reading - (*before).*reading);
  }
  return values;
}

/// Gaps at equal distances from where the upper force is 1 % of its peak to the turn.
std::vector<double> gaps_of(std::vector<Pressed> const& stroke, double peak, int n) {
  double widest = 0.0, least = stroke.front().height;
  for (auto const& at : stroke) {
    least = std::min(least, at.height);
    if (at.upper > 0.01 * peak)
      widest = std::max(widest, at.height);
  }
  std::vector<double> gaps;
  for (int k = 0; k < n; ++k)
    gaps.push_back(least + (widest - least) * (k + 0.5) / n);
  return gaps;
}

/// The same bed with another mass: stresses hang on the solid fraction alone.
Curve with_mass(Curve curve, double share) {
  for (auto* stroke : {&curve.loading, &curve.unloading})
    for (auto& at : *stroke)
      at.height *= 1.0 + share;
  return curve;
}

/// The same in a bore that is wider by a share: less solid at a gap, on more area.
Curve with_bore(Curve curve, double share) {
  double const area = (1.0 + share) * (1.0 + share);
  for (auto* stroke : {&curve.loading, &curve.unloading})
    for (auto& at : *stroke)
      at.height /= area, at.upper *= area, at.lower *= area;
  return curve;
}

GrainPress pilot_press() {
  return {.packing = 900};
}

} // namespace

VectorXd Foretold::rows(std::vector<Moment> const& moments) const {
  auto const turn = std::ranges::min_element(moments, {}, &Moment::gap);
  std::vector<Moment> const closing(moments.begin(), turn + 1);
  std::vector<Moment> const opening(moments.rbegin(), std::make_reverse_iterator(turn));
  VectorXd all(n_channels * (n_closing + n_opening));
  Eigen::Index row = 0;
  for (auto const reading : {&Moment::upper, &Moment::lower, &Moment::radial}) {
    all.segment(row, n_closing) = at_gaps(closing, reading, closing_);
    all.segment(row + n_closing, n_opening) = at_gaps(opening, reading, opening_);
    row += n_closing + n_opening;
  }
  return all;
}

VectorXd Foretold::rows(Curve const& curve) const {
  return rows(seen_by_machine(curve, {}, {}));
}

void Foretold::weigh(Curve const& opened, Curve const& rough_wall) {
  Gauges const gauges;
  constexpr Eigen::Index n = n_closing + n_opening;
  auto const phase = [](Eigen::Index k) {
    return k < n_closing ? 1.0 - (k + 0.5) / n_closing : 1.0 + (k - n_closing + 0.5) / n_opening;
  };
  Eigen::MatrixXd sigma = Eigen::MatrixXd::Zero(base_.size(), base_.size());
  for (Eigen::Index i = 0; i < base_.size(); ++i) {
    auto const& sensor = i < 2 * n ? gauges.force : gauges.pressure;
    double const kink =
        i < 2 * n ? 0.004 * clean_.peak() * std::exp(-std::abs(base_[i]) / (0.012 * clean_.peak()))
                  : 0.0;
    sigma(i, i) = std::pow(std::hypot(sensor.at(base_[i]), kink), 2);
  }
  // Every simulator: 0.3 % of a reading, Matern 3/2 over the cycle.
  for (Eigen::Index i = 0; i < base_.size(); ++i)
    for (Eigen::Index j = 0; j < base_.size(); ++j)
      if (i / n == j / n) {
        double const x = std::sqrt(3.0) * std::abs(phase(i % n) - phase(j % n)) / 0.4;
        sigma(i, j) += 9e-6 * base_[i] * base_[j] * (1.0 + x) * std::exp(-x);
      }
  auto const add = [&](VectorXd const& repeat) { sigma += repeat * repeat.transpose(); };
  double const share = 8 * mm / opened_gap - 1.0;
  VectorXd const by_mass = (rows(with_mass(opened, share)) - base_) / share;
  add(0.003 * by_mass);
  add(0.0012 / 0.54 * by_mass); // an onset of the bed is a mass that counts for more
  add((rows(rough_wall) - base_) * (0.03 * 0.2 / 0.1));
  VectorXd const by_gap =
      (rows(seen_by_machine(opened, {}, {.zero = opened_gap - 8 * mm})) - base_) /
      (opened_gap - 8 * mm);
  add(8e-6 * by_gap);
  VectorXd zero = VectorXd::Zero(base_.size());
  zero.head(n).setConstant(0.3);
  add(zero);
  root_.compute(sigma);
}

double Foretold::length(VectorXd const& moved) const {
  VectorXd const white = root_.matrixL().solve(moved);
  // Priors hold E and CED: a ridge instead of a bare projection.
  Eigen::Matrix2d const normal = nuisance_.transpose() * nuisance_ + Eigen::Matrix2d::Identity();
  return (white - nuisance_ * normal.ldlt().solve(nuisance_.transpose() * white)).norm();
}

Foretold::Foretold(Simulations const& simulations)
    : simulations_(simulations), clean_(simulations.curve("pilot-clean", pilot_press())),
      closing_(gaps_of(clean_.loading, clean_.peak(), n_closing)),
      opening_(gaps_of(clean_.unloading, clean_.peak(), n_opening)), base_(rows(clean_)) {
  auto const pilot = [&](std::string const& name, auto change) {
    auto press = pilot_press();
    change(press);
    return simulations_.curve("pilot-" + name, press);
  };
  auto const opened = pilot("opened", [](auto& press) { press.end_gap = opened_gap; });
  auto const wall = pilot("wall_friction", [](auto& press) { press.wall_friction = 0.3; });
  weigh(opened, wall);
  auto const stiff = pilot("young_modulus", [](auto& press) { press.young_modulus *= 1.1; });
  auto const sticky = pilot("cohesion", [](auto& press) { press.cohesion_density *= 1.2; });
  nuisance_.resize(base_.size(), 2);
  nuisance_.col(0) = 0.15 / 0.1 * (rows(stiff) - base_);
  nuisance_.col(1) = 0.3 / 0.2 * (rows(sticky) - base_);
  nuisance_ = root_.matrixL().solve(nuisance_).eval();
  chaos_ = length(rows(pilot("again", [](auto& press) { press.end_gap = 8.001 * mm; })) - base_);
  for (int k = 1; k <= 5; ++k) {
    auto const other = pilot(fmt::format("packing-{}", k),
                             [&](auto& press) { press.packing = 900u + static_cast<unsigned>(k); });
    packings_ += std::pow(length(rows(other) - base_), 2) / 5.0;
  }
  packings_ = std::sqrt(packings_);
  lambda_per_unit_.assign(n_effects, 0.0);
  for (auto const& cause : grain_causes()) {
    if (simulations.code == Code::liggghts && !cause.is_in_peer)
      continue;
    double& found = lambda_per_unit_[static_cast<std::size_t>(cause.effect)];
    if (cause.place != Place::grains) {
      found = machine_lambda(cause.effect, opened);
      continue;
    }
    auto const name = std::string(kind_of(cause.effect).name);
    auto const with =
        simulations_.curve("pilot-" + name, with_cause(pilot_press(), cause.effect, cause.trial));
    double const seen = length(rows(with) - base_);
    found = seen > 2.0 * chaos_ ? std::sqrt(seen * seen - chaos_ * chaos_) / cause.trial : 0.0;
  }
}

double Foretold::machine_lambda(Effect effect, Curve const& opened) const {
  double const wider = opened_gap - 8 * mm;
  double size = grain_cause(effect)->trial;
  VectorXd moved;
  if (effect == Effect::mass_error) {
    size = 8 * mm / opened_gap - 1.0;
    moved = rows(with_mass(opened, size));
  } else if (effect == Effect::die_size) {
    double const share = std::sqrt(opened_gap / (8 * mm)) - 1.0;
    size = share * stated_bore;
    moved = rows(with_bore(opened, share));
  } else {
    bool const opens = size == 0.0; // the pilot is one in which the punch was held back
    if (opens) {
      auto const travel = 12 * mm / laboratory_speed;
      size = effect == Effect::gap_offset ? wider
             : effect == Effect::frame_compliance
                 ? wider / (1.0227 * opened.peak())
                 : wider / (1800.0 * -std::expm1(-travel / 1800.0));
    }
    moved = rows(seen_by_machine(opens ? opened : clean_, Effects().with(effect, size), {}));
  }
  double const seen = length(moved - base_);
  double const noise = grain_cause(effect)->trial == 0.0 ? chaos_ : 0.0;
  return seen > 2.0 * noise ? std::sqrt(seen * seen - noise * noise) / std::abs(size) : 0.0;
}

double Foretold::per_unit(Effect effect) const {
  return lambda_per_unit_[static_cast<std::size_t>(effect)];
}

} // namespace hidden
