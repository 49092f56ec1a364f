#include "tests/diagnosis/hide/detectability.hpp"

#include "tests/diagnosis/hide/readings.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace hidden {
namespace {

/// Every sixth moment of the cycle stands for the readings around it, all gauges one below another.
struct Observed {
  std::vector<double> value, sd, phase;
};

void add_channel(Observed& out, Cycle const& cycle, Sensor const& sensor, double Moment::*gauge) {
  for (std::size_t k = 3; k < cycle.moments.size(); k += 6) {
    double const y = cycle.moments[k].*gauge;
    // Onset and loss of contact are no Gaussian matter: wider there (note 2a).
    double const kink = gauge == &Moment::radial ? 0.0 : 100.0 * std::exp(-std::abs(y) / 300.0);
    out.value.push_back(y);
    out.sd.push_back(std::hypot(sensor.at(y), std::abs(y) > 30.0 ? kink : 0.0));
    out.phase.push_back(static_cast<double>(k) / static_cast<double>(cycle.moments.size()));
  }
}

Observed observed(Case const& of, Powder const& powder, Effects const& effects,
                  Repeat const& repeat) {
  Observed out;
  for (auto const& run : of.runs) {
    if (run.is_held_out)
      continue;
    auto const cycle = press_cycle(powder, effects, run.protocol, repeat);
    add_channel(out, cycle, force_sensor, &Moment::upper);
    if (has_all_gauges(of.observables)) {
      add_channel(out, cycle, force_sensor, &Moment::lower);
      add_channel(out, cycle, pressure_sensor, &Moment::radial);
      out.value.push_back(cycle.ejection_force), out.sd.push_back(ejection_sd);
      out.phase.push_back(-1.0);
    }
    if (has_compact_height(of.observables)) {
      out.value.push_back(cycle.compact_height), out.sd.push_back(height_sd);
      out.phase.push_back(-1.0);
    }
  }
  return out;
}

Eigen::VectorXd values(Observed const& from) {
  return Eigen::Map<Eigen::VectorXd const>(from.value.data(),
                                           static_cast<Eigen::Index>(from.value.size()));
}

/// Rows of a run: repeats scatter run by run, so their directions are cut to one run each.
Eigen::MatrixXd covariance(Case const& of, Observed const& base, Eigen::Index n_runs) {
  auto const n = static_cast<Eigen::Index>(base.value.size()), rows = n / n_runs;
  Eigen::VectorXd const y = values(base);
  Eigen::MatrixXd sigma = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    auto const k = static_cast<std::size_t>(i);
    sigma(i, i) = base.sd[k] * base.sd[k];
    for (Eigen::Index j = 0; j < n; ++j) { // Matern 3/2 over the cycle, 0.8 between runs
      double const d = std::sqrt(3.0) * std::abs(base.phase[k] - base.phase[std::size_t(j)]) / 0.2;
      double const kernel = (1.0 + d) * std::exp(-d) * (i / rows == j / rows ? 1.0 : 0.8);
      sigma(i, j) += 0.003 * 0.003 * y(i) * y(j) * kernel;
    }
  }
  auto const scale = scatter_scale();
  for (auto part : {&Repeat::mass, &Repeat::packing, &Repeat::friction, &Repeat::zero,
                    &Repeat::cell_zero}) {
    Repeat one;
    one.*part = scale.*part;
    Eigen::VectorXd const moved = values(observed(of, of.powder, {}, one)) - y;
    for (Eigen::Index run = 0; run < n_runs; ++run)
      sigma.block(run * rows, run * rows, rows, rows) +=
          moved.segment(run * rows, rows) * moved.segment(run * rows, rows).transpose();
  }
  return sigma;
}

} // namespace

double Signatures::lambda() const { return effects.rowwise().sum().norm(); }

Signatures signatures_of(Case const& of) {
  auto const base = observed(of, of.powder, {}, {});
  Eigen::Index n_runs = 0;
  for (auto const& run : of.runs)
    n_runs += run.is_held_out ? 0 : 1;
  Eigen::LLT<Eigen::MatrixXd> const root(covariance(of, base, n_runs));
  auto const whitened = [&](Powder const& powder, Effects const& effects) {
    Eigen::VectorXd const moved = values(observed(of, powder, effects, {})) - values(base);
    return Eigen::VectorXd(root.matrixL().solve(moved));
  };
  Signatures result;
  Powder stiff = of.powder, sticky = of.powder;
  stiff.young_modulus *= 1.02;
  sticky.cohesion_density *= 1.05;
  result.nuisance.resize(static_cast<Eigen::Index>(base.value.size()), 2);
  result.nuisance << 7.5 * whitened(stiff, {}), 6.0 * whitened(sticky, {});
  auto const count = static_cast<Eigen::Index>(of.hidden.size());
  Eigen::MatrixXd plain(result.nuisance.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    auto const& [effect, size] = of.hidden[static_cast<std::size_t>(k)];
    plain.col(k) = whitened(of.powder, Effects{}.with(effect, size));
  }
  // Priors of 15 % and 30 % hold the two: ridge instead of a bare projection.
  Eigen::Matrix2d const normal =
      result.nuisance.transpose() * result.nuisance + Eigen::Matrix2d::Identity();
  result.effects =
      plain - result.nuisance * normal.ldlt().solve(result.nuisance.transpose() * plain);
  return result;
}

} // namespace hidden
