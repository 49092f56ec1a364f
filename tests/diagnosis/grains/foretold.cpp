#include "tests/diagnosis/grains/foretold.hpp"

#include "tests/diagnosis/grains/strokes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double opened_gap = 8.3 * mm; ///< where the pilot turns that stands for a wider bed
constexpr int n_closing = 24, n_opening = 16, n_channels = 3;
constexpr Eigen::Index n_of_channel = n_closing + n_opening;

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

Foretold::Curves Foretold::pilots(std::string const& change, GrainPress const& press) const {
  Curves curves;
  auto own = press;
  for (int k = 0; k < n_pilots; ++k) {
    own.packing = first_simulated + static_cast<std::uint64_t>(k);
    curves.push_back(simulations_.curve(own, change));
  }
  return curves;
}

VectorXd Foretold::change_of(Curves const& curves, std::size_t k, Effects const& effects,
                             Scatter const& scatter) const {
  return rows(seen_by_machine(curves[k], effects, scatter)) -
         rows(seen_by_machine(clean_[k], {}, {}));
}

VectorXd Foretold::moved(Curves const& curves, Effects const& effects,
                         Scatter const& scatter) const {
  VectorXd sum = VectorXd::Zero(base_.size());
  for (std::size_t k = 0; k < curves.size(); ++k)
    sum += change_of(curves, k, effects, scatter);
  return sum / static_cast<double>(curves.size());
}

MatrixXd Foretold::gauge_covariance() const {
  Gauges const gauges;
  MatrixXd sigma = MatrixXd::Zero(base_.size(), base_.size());
  for (Index i = 0; i < base_.size(); ++i) {
    bool const is_force = i < 2 * n_of_channel;
    auto const& sensor = is_force ? gauges.force : gauges.pressure;
    // Onset and loss of contact are no Gaussian matter: wider there, as in `hide` of the peak.
    double const kink =
        is_force ? 0.004 * peak_ * std::exp(-std::abs(base_[i]) / (0.012 * peak_)) : 0.0;
    sigma(i, i) = std::pow(std::hypot(sensor.at(base_[i]), kink), 2);
  }
  return sigma;
}

MatrixXd Foretold::reading_kernel(double between_channels) const {
  auto const phase = [](Index k) {
    return k < n_closing ? 1.0 - (static_cast<double>(k) + 0.5) / n_closing
                         : 1.0 + (static_cast<double>(k - n_closing) + 0.5) / n_opening;
  };
  MatrixXd kernel = MatrixXd::Zero(base_.size(), base_.size());
  for (Index i = 0; i < base_.size(); ++i)
    for (Index j = 0; j < base_.size(); ++j) {
      double const x =
          std::sqrt(3.0) * std::abs(phase(i % n_of_channel) - phase(j % n_of_channel)) / 0.4;
      double const shared = i / n_of_channel == j / n_of_channel ? 1.0 : between_channels;
      kernel(i, j) = shared * base_[i] * base_[j] * (1.0 + x) * std::exp(-x);
    }
  return kernel;
}

MatrixXd Foretold::repeat_covariance(Curves const& opened, Curves const& rough_wall) const {
  MatrixXd sigma = MatrixXd::Zero(base_.size(), base_.size());
  auto const add = [&](VectorXd const& repeat) { sigma += repeat * repeat.transpose(); };
  double const share = 8 * mm / opened_gap - 1.0, wider = opened_gap - 8 * mm;
  Curves heavier;
  for (auto const& curve : opened)
    heavier.push_back(with_mass(curve, share));
  add(0.003 / share * moved(heavier));
  add(0.03 * 0.2 / 0.2 * moved(rough_wall));
  add(8e-6 / wider * moved(opened, {}, {.zero = wider}));
  VectorXd zero = VectorXd::Zero(base_.size());
  zero.head(n_of_channel).setConstant(0.3);
  add(zero);
  return sigma;
}

void Foretold::find_bed_scatter(MatrixXd const& rest) {
  std::vector<VectorXd> packings;
  VectorXd mean = VectorXd::Zero(base_.size());
  for (int k = 0; k < n_simulated; ++k) {
    auto const press = GrainPress{.packing = first_simulated + static_cast<std::uint64_t>(k)};
    packings.push_back(rows(seen_by_machine(simulations_.curve(press), {}, {})));
    mean += packings.back() / n_simulated;
  }
  double best = -1e300;
  for (double const shared : {0.0, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995}) {
    auto const kernel = reading_kernel(shared);
    for (double share = 2e-3; share < 0.2; share *= 1.15) {
      Eigen::LLT<MatrixXd> const root(rest + share * share * kernel);
      double likelihood =
          -2.0 * (n_simulated - 1) * root.matrixLLT().diagonal().array().log().sum();
      for (auto const& one : packings)
        likelihood -= root.matrixL().solve(one - mean).squaredNorm();
      if (likelihood > best)
        best = likelihood, bed_scatter_ = share, bed_correlation_ = shared;
    }
  }
}

VectorXd Foretold::projected(VectorXd const& change) const {
  VectorXd const white = root_.matrixL().solve(change);
  MatrixXd const absorbed = root_.matrixL().solve(nuisance_);
  // Priors hold E and CED: a ridge instead of a bare projection.
  Eigen::Matrix2d const normal = absorbed.transpose() * absorbed + Eigen::Matrix2d::Identity();
  return white - absorbed * normal.ldlt().solve(absorbed.transpose() * white);
}

Foretold::Foretold(Simulations const& simulations, int n_packings)
    : simulations_(simulations), clean_(pilots("", {})), peak_(clean_.front().peak()),
      closing_(gaps_of(clean_.front().loading, peak_, n_closing)),
      opening_(gaps_of(clean_.front().unloading, peak_, n_opening)),
      base_(rows(seen_by_machine(clean_.front(), {}, {}))) {
  Curves opened;
  for (auto const& curve : clean_)
    opened.push_back(turned_at(curve, opened_gap));
  auto const wall = pilots("wall_friction-0.2", {.wall_friction = 0.4});
  nuisance_.resize(base_.size(), 2);
  nuisance_.col(0) = 0.15 / 0.1 * moved(pilots("young_modulus", {.young_modulus = 275e6}));
  nuisance_.col(1) = 0.3 / 0.2 * moved(pilots("cohesion", {.cohesion_density = 6e6}));
  MatrixXd const rest = gauge_covariance() + repeat_covariance(opened, wall);
  find_bed_scatter(rest + nuisance_ * nuisance_.transpose());
  double const of_means = bed_scatter_ * bed_scatter_ * (1.0 / n_packings + 1.0 / n_simulated);
  root_.compute(rest + 9e-6 * reading_kernel(0.0) + of_means * reading_kernel(bed_correlation_));
  lambda_per_unit_.assign(n_effects, 0.0);
  for (auto const& cause : grain_causes())
    if (simulations.code == Code::own || cause.is_in_peer)
      lambda_per_unit_[static_cast<std::size_t>(cause.effect)] =
          cause.place == Place::grains ? grain_lambda(cause) : machine_lambda(cause.effect, opened);
}

double Foretold::grain_lambda(GrainCause const& cause) const {
  auto const name = fmt::format("{}-{:.3g}", kind_of(cause.effect).name, cause.trial);
  auto const with = pilots(name, with_cause({}, cause.effect, cause.trial));
  // Pressed with an effect the same packing rearranges otherwise, by as much as another packing;
  // the product of two packings has the effect in it and of that nothing but chance.
  double const square =
      projected(change_of(with, 0, {}, {})).dot(projected(change_of(with, 1, {}, {})));
  return square > 0.0 ? std::sqrt(square) / cause.trial : 0.0;
}

double Foretold::machine_lambda(Effect effect, Curves const& opened) const {
  double const wider = opened_gap - 8 * mm, mass = 8 * mm / opened_gap - 1.0;
  double const bore = std::sqrt(opened_gap / (8 * mm)) - 1.0;
  Curves changed;
  for (auto const& curve : opened)
    changed.push_back(effect == Effect::mass_error ? with_mass(curve, mass)
                      : effect == Effect::die_size ? with_bore(curve, bore)
                                                   : curve);
  double const travel = 12 * mm / laboratory_speed;
  double const trial = grain_cause(effect)->trial;
  if (trial != 0.0) // exact, on the same grains
    return projected(moved(clean_, Effects().with(effect, trial))).norm() / trial;
  // The grains turned early: held back by what is to be hidden.
  double size = effect == Effect::mass_error   ? -mass
                : effect == Effect::die_size   ? bore * stated_bore
                : effect == Effect::gap_offset ? wider
                : effect == Effect::frame_compliance
                    ? wider / (1.0227 * opened.front().peak())
                    : wider / (1800.0 * -std::expm1(-travel / 1800.0));
  auto const by_machine =
      grain_cause(effect)->place == Place::machine ? Effects().with(effect, size) : Effects();
  return projected(moved(changed, by_machine)).norm() / size;
}

double Foretold::per_unit(Effect effect) const {
  return lambda_per_unit_[static_cast<std::size_t>(effect)];
}

} // namespace hidden
