#include "tests/diagnosis/hide/detectability.hpp"

#include "tests/diagnosis/hide/readings.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {
namespace {

enum class Gauge { upper, lower, radial, ejection, height };

/// Every sixth moment of the cycle stands for the readings around it, all gauges one below another.
struct Observed {
  std::vector<double> value, sd, phase; ///< phase 0 to 1 over the cycle's moments
  std::vector<Gauge> gauge;
  void add(double y, double error, double at, Gauge from) {
    value.push_back(y), sd.push_back(error), phase.push_back(at), gauge.push_back(from);
  }
};

void add_channel(Observed& out, Cycle const& cycle, Sensor const& sensor, double Moment::*reading,
                 Gauge gauge) {
  for (std::size_t k = 3; k < cycle.moments.size(); k += 6) {
    double const y = cycle.moments[k].*reading;
    // Onset and loss of contact are no Gaussian matter: wider there (note 2a).
    double const kink = gauge == Gauge::radial ? 0.0 : 100.0 * std::exp(-std::abs(y) / 300.0);
    out.add(y, std::hypot(sensor.at(y), std::abs(y) > 30.0 ? kink : 0.0),
            static_cast<double>(k) / static_cast<double>(cycle.moments.size()), gauge);
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
      out.add(cycle.ejection_force, ejection_sd, 0.0, Gauge::ejection);
    }
    if (has_compact_height(of.observables))
      out.add(cycle.compact_height, height_sd, 0.0, Gauge::height);
  }
  return out;
}

Eigen::VectorXd values(Observed const& from) {
  return Eigen::Map<Eigen::VectorXd const>(from.value.data(),
                                           static_cast<Eigen::Index>(from.value.size()));
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

/// Repeats scatter run by run, so their directions are cut to one run each.
Eigen::MatrixXd covariance(Case const& of, Observed const& base, Eigen::Index n_runs) {
  auto const n = static_cast<Eigen::Index>(base.value.size()), rows = n / n_runs;
  Eigen::VectorXd const y = values(base);
  Eigen::MatrixXd sigma(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    auto const k = static_cast<std::size_t>(i);
    for (Eigen::Index j = 0; j < n; ++j)
      sigma(i, j) = tolerance(base, k, static_cast<std::size_t>(j), static_cast<std::size_t>(rows));
    sigma(i, i) += base.sd[k] * base.sd[k];
  }
  auto const scale = scatter_scale();
  for (auto part :
       {&Repeat::mass, &Repeat::packing, &Repeat::friction, &Repeat::zero, &Repeat::cell_zero}) {
    Repeat one;
    one.*part = scale.*part;
    Eigen::VectorXd const moved = values(observed(of, of.powder, {}, one)) - y;
    for (Eigen::Index run = 0; run < n_runs; ++run)
      sigma.block(run * rows, run * rows, rows, rows) +=
          moved.segment(run * rows, rows) * moved.segment(run * rows, rows).transpose();
  }
  // The simulation that the data will be held against is wrong in all runs alike.
  for (auto const& powder : simulated_departures(of.powder)) {
    Eigen::VectorXd const moved = values(observed(of, powder, {}, {})) - y;
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
  nuisance_.resize(base_.size(), 2);
  nuisance_.col(0) = 7.5 * (values(observed(of, stiff, {}, {})) - base_);
  nuisance_.col(1) = 6.0 * (values(observed(of, sticky, {}, {})) - base_);
  nuisance_ = root_.matrixL().solve(nuisance_).eval();
}

Eigen::VectorXd Detector::projected(Eigen::VectorXd const& moved) const {
  Eigen::VectorXd const white = root_.matrixL().solve(moved);
  // Priors of 15 % and 30 % hold the two: a ridge instead of a bare projection.
  Eigen::Matrix2d const normal = nuisance_.transpose() * nuisance_ + Eigen::Matrix2d::Identity();
  return white - nuisance_ * normal.ldlt().solve(nuisance_.transpose() * white);
}

Eigen::VectorXd Detector::signature(std::vector<HiddenEffect> const& hidden) const {
  Effects effects;
  for (auto const& [effect, size] : hidden)
    effects = effects.with(effect, size);
  return projected(values(observed(case_, case_.powder, effects, {})) - base_);
}

double Detector::lambda(std::vector<HiddenEffect> const& hidden) const {
  return signature(hidden).norm();
}

std::vector<Detector::Rival> Detector::rivals(HiddenEffect const& hidden) const {
  Eigen::VectorXd const own = signature({hidden});
  std::vector<Rival> all;
  for (int k = 0; k < n_known_effects; ++k) {
    auto const effect = static_cast<Effect>(k);
    if (effect == hidden.effect)
      continue;
    // A third of the prior: where it is small the signature is a line.
    Eigen::VectorXd const other = 3.0 * signature({{effect, kind_of(effect).prior / 3.0}});
    double const share = own.dot(other) / std::max(other.squaredNorm(), 1e-300);
    double const least = kind_of(effect).is_one_sided ? 0.0 : -3.0;
    all.push_back({effect, (own - std::clamp(share, least, 3.0) * other).norm()});
  }
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
