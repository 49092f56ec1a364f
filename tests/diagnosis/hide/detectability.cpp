#include "tests/diagnosis/hide/detectability.hpp"

#include "tests/diagnosis/hide/readings.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

enum class Gauge { upper, lower, radial, ejection, height };

/// Every sixth moment of the cycle stands for the readings around it, all gauges one below another.
struct Observed {
  std::vector<double> value, sd, phase; ///< phase 0 to 1 over the cycle's moments
  std::vector<double> slope;            ///< change of the reading over that of the gap
  std::vector<Gauge> gauge;
  void add(double y, double error, double at, double over_gap, Gauge from) {
    value.push_back(y), sd.push_back(error), phase.push_back(at);
    slope.push_back(over_gap), gauge.push_back(from);
  }
};

/// Of a reading over the gap, from the moment before and, but at the turn, the one after.
double slope_over_gap(std::vector<Moment> const& moments, std::size_t k, double Moment::*reading) {
  auto const& before = moments[k - 1];
  bool const turns = k + 1 == moments.size() ||
                     (moments[k + 1].gap - moments[k].gap) * (moments[k].gap - before.gap) <= 0.0;
  auto const& after = moments[turns ? k : k + 1];
  double const opened = after.gap - before.gap;
  return std::abs(opened) > 1e-9 ? (after.*reading - before.*reading) / opened : 0.0; // a dwell
}

void add_channel(Observed& out, Cycle const& cycle, Sensor const& sensor, double Moment::*reading,
                 Gauge gauge) {
  for (std::size_t k = 3; k < cycle.moments.size(); k += 6) {
    double const y = cycle.moments[k].*reading;
    // Onset and loss of contact are no Gaussian matter: wider there (note 2a).
    double const kink = gauge == Gauge::radial ? 0.0 : 100.0 * std::exp(-std::abs(y) / 300.0);
    out.add(y, std::hypot(sensor.at(y), std::abs(y) > 30.0 ? kink : 0.0),
            static_cast<double>(k) / static_cast<double>(cycle.moments.size()),
            slope_over_gap(cycle.moments, k, reading), gauge);
  }
}

Observed observed(Case const& of, Powder const& powder, Effects const& effects,
                  Repeat const& repeat) {
  Observed out;
  for (auto const& run : of.runs) {
    if (run.is_held_out)
      continue;
    auto const cycle = press_cycle(powder, effects, run.protocol, repeat);
    add_channel(out, cycle, force_sensor, &Moment::upper, Gauge::upper);
    if (has_all_gauges(of.observables)) {
      add_channel(out, cycle, force_sensor, &Moment::lower, Gauge::lower);
      add_channel(out, cycle, pressure_sensor, &Moment::radial, Gauge::radial);
      out.add(cycle.ejection_force, ejection_sd, 0.0, 0.0, Gauge::ejection);
    }
    if (has_compact_height(of.observables))
      out.add(cycle.compact_height, height_sd, 0.0, 0.0, Gauge::height);
  }
  return out;
}

VectorXd values(Observed const& from) {
  return Eigen::Map<VectorXd const>(from.value.data(), static_cast<Index>(from.value.size()));
}

/// Tolerance of every simulator: 0.3 % of a reading, Matern 3/2 over the cycle, 0.8 between runs,
/// each gauge on its own; a height is geometry and has none.
double tolerance(Observed const& base, std::size_t i, std::size_t j, std::size_t rows) {
  if (base.gauge[i] != base.gauge[j] || base.gauge[i] == Gauge::height)
    return 0.0;
  double const d = std::sqrt(3.0) * std::abs(base.phase[i] - base.phase[j]) / 0.2;
  return 0.003 * 0.003 * base.value[i] * base.value[j] * (1.0 + d) * std::exp(-d) *
         (i / rows == j / rows ? 1.0 : 0.8);
}

/// All gauges of a moment are held against one reading of the gap.
double gap_noise(Observed const& base, std::size_t i, std::size_t j, std::size_t rows) {
  bool const is_one_moment = i / rows == j / rows && base.phase[i] == base.phase[j];
  return is_one_moment ? std::pow(gap_sensor.sd, 2) * base.slope[i] * base.slope[j] : 0.0;
}

/// Repeats scatter run by run, so their directions are cut to one run each.
Eigen::MatrixXd covariance(Case const& of, Observed const& base, Index n_runs) {
  auto const n = static_cast<Index>(base.value.size()), rows = n / n_runs;
  VectorXd const y = values(base);
  Eigen::MatrixXd sigma(n, n);
  for (Index i = 0; i < n; ++i) {
    auto const k = static_cast<std::size_t>(i);
    for (Index j = 0; j < n; ++j)
      sigma(i, j) =
          tolerance(base, k, static_cast<std::size_t>(j), static_cast<std::size_t>(rows)) +
          gap_noise(base, k, static_cast<std::size_t>(j), static_cast<std::size_t>(rows));
    sigma(i, i) += base.sd[k] * base.sd[k];
  }
  auto const scale = scatter_scale();
  for (auto part :
       {&Repeat::mass, &Repeat::packing, &Repeat::friction, &Repeat::zero, &Repeat::cell_zero}) {
    Repeat one;
    one.*part = scale.*part;
    VectorXd const moved = values(observed(of, of.powder, {}, one)) - y;
    for (Index run = 0; run < n_runs; ++run)
      sigma.block(run * rows, run * rows, rows, rows) +=
          moved.segment(run * rows, rows) * moved.segment(run * rows, rows).transpose();
  }
  // The simulation that the data will be held against is wrong in all runs alike.
  for (auto const& powder : simulated_departures(of.powder)) {
    VectorXd const moved = values(observed(of, powder, {}, {})) - y;
    sigma += moved * moved.transpose();
  }
  return sigma;
}

} // namespace

Detector::Detector(Case const& of) : case_(of) {
  auto const base = observed(of, of.powder, {}, {});
  base_ = values(base);
  auto const n_runs = std::ranges::count_if(of.runs, [](auto& run) { return !run.is_held_out; });
  root_.compute(covariance(of, base, n_runs));
  Powder stiff = of.powder, sticky = of.powder;
  stiff.young_modulus *= 1.02;
  sticky.cohesion_density *= 1.05;
  modulus_ = 7.5 * (values(observed(of, stiff, {}, {})) - base_);
  cohesion_ = 6.0 * (values(observed(of, sticky, {}, {})) - base_);
}

VectorXd Detector::projected(VectorXd const& moved, VectorXd const& stiffer) const {
  VectorXd const white = root_.matrixL().solve(moved);
  Eigen::MatrixXd const absorbed =
      root_.matrixL().solve((Eigen::MatrixXd(moved.size(), 2) << stiffer, cohesion_).finished());
  // Priors of 15 % and 30 % hold the two: a ridge instead of a bare projection.
  Eigen::Matrix2d const normal = absorbed.transpose() * absorbed + Eigen::Matrix2d::Identity();
  return white - absorbed * normal.ldlt().solve(absorbed.transpose() * white);
}

VectorXd Detector::moved_by(std::vector<HiddenEffect> const& hidden) const {
  Effects effects;
  for (auto const& [effect, size] : hidden)
    effects = effects.with(effect, size);
  return values(observed(case_, case_.powder, effects, {})) - base_;
}

double Detector::lambda(std::vector<HiddenEffect> const& hidden) const {
  return projected(moved_by(hidden), modulus_).norm();
}

double Detector::nearest(VectorXd const& own, Effect effect) const {
  // Some per cent of force bend every signature: a parabola of third order or more through sizes.
  auto const& kind = kind_of(effect);
  std::vector<double> sizes = {0.0, 1.5, 3.0};
  if (kind.is_one_sided)
    sizes.push_back(0.75);
  else
    for (double const share : {0.5, 1.0})
      sizes.push_back(share * std::max(-3.0, least_size(effect) / kind.prior));
  std::vector<VectorXd> moved;
  for (double const size : sizes)
    moved.push_back(size == 0.0 ? VectorXd::Zero(base_.size())
                                : moved_by({{effect, size * kind.prior}}));
  auto const distance = [&](double at) {
    VectorXd rival = VectorXd::Zero(base_.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      double weight = 1.0;
      for (std::size_t j = 0; j < sizes.size(); ++j)
        weight *= j == i ? 1.0 : (at - sizes[j]) / (sizes[i] - sizes[j]);
      rival += weight * moved[i];
    }
    // A modulus acts on the forces that are there.
    VectorXd const scale =
        (base_.array().abs() > 30.0).select((base_ + rival).array() / base_.array(), 1.0);
    return projected(own - rival, modulus_.cwiseProduct(scale)).norm();
  };
  double least = distance(0.0);
  double const lowest = *std::ranges::min_element(sizes);
  for (auto const& [from, to] : {std::pair{lowest, 0.0}, {0.0, 3.0}})
    if (from < to)
      least = std::min(least, boost::math::tools::brent_find_minima(distance, from, to, 12).second);
  return least;
}

std::vector<Detector::Rival> Detector::rivals(HiddenEffect const& hidden) const {
  VectorXd const own = moved_by({hidden});
  std::vector<Rival> all;
  for (int k = 0; k < n_known_effects; ++k)
    if (auto const effect = static_cast<Effect>(k); effect != hidden.effect)
      all.push_back({effect, nearest(own, effect)});
  std::ranges::sort(all, {}, &Rival::separation);
  return all;
}

double Detector::size_for(HiddenEffect const& hidden, double target) const {
  double const sign = hidden.size < 0.0 ? -1.0 : 1.0;
  double const most = sign < 0.0 ? -least_size(hidden.effect) : largest_size(hidden.effect);
  double size = std::abs(hidden.size);
  double power = 1.0, last = size, last_lambda = lambda({{hidden.effect, sign * size}});
  for (int k = 0; k < 6 && std::abs(std::log(last_lambda / target)) > 0.03; ++k) {
    size = std::min(last * std::pow(target / last_lambda, power), most);
    double const now = lambda({{hidden.effect, sign * size}});
    if (size != last && now != last_lambda)
      power = std::clamp(std::log(size / last) / std::log(now / last_lambda), 0.3, 2.0);
    last = size, last_lambda = now;
  }
  return sign * size;
}

} // namespace hidden
