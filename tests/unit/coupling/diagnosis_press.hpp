#pragma once

#include "coupling/diagnosis/diagnose.hpp"
#include "tests/unit/coupling/diagnosis_linear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// A toy of a press for the diagnosis's own tests: 9.13 g in a die of 22.05 mm. Not the simulator.
namespace diagnosis_support {

/// What is read in a cycle.
enum class Gauges { upper, all };

struct ToyRun {
  std::string name;
  double end_gap; ///< [m]
  double speed;   ///< over that of the first run
};

/// Solid fraction phi = m / (rho A h),  sigma = K (phi - phi_c)^1.5 - S (phi - phi_c) in loading,
/// a stiffer branch in unloading; upper force A sigma exp(2 k mu h / D), lower with the other
/// sign, both reversed in unloading; frame, travel, load cell around it.
struct ToyPress : Model {
  static constexpr double area = 3.8187e-4, density = 3300.0, mass = 9.13e-3, phi_c = 0.5;
  static constexpr double diameter = 22.05e-3, top = 14.4e-3; ///< [m]
  static constexpr Index n_points = 14;

  std::vector<ToyRun> runs{{"run1", 9.5e-3, 1.0}};
  Gauges gauges = Gauges::all;
  std::vector<CalibratedParameter> parameters{
      {.name = "young_modulus", .unit = "Pa", .mean = 487e6, .sd = 0.3, .is_logarithmic = true},
      {.name = "cohesion", .unit = "Pa", .mean = 15e6, .sd = 10e6}};
  std::vector<Mechanism> causes{
      {.name = "frame_compliance", .unit = "m/N", .scale = 2e-8, .is_one_sided = true},
      {.name = "gap_offset", .unit = "m", .scale = 1e-4},
      {.name = "force_gain", .unit = "1", .scale = 0.04, .low = -0.5},
      {.name = "force_offset", .unit = "N", .scale = 100.0},
      {.name = "wall_friction", .unit = "1", .scale = 0.06, .low = -0.15},
      {.name = "mass_error", .unit = "1", .scale = 0.015, .low = -0.2, .high = 0.2},
      {.name = "plastic_contacts", .unit = "1", .scale = 0.3, .is_one_sided = true, .high = 0.9},
      {.name = "breakage",
       .unit = "1",
       .scale = 0.01,
       .is_one_sided = true,
       .high = 0.1,
       .shapes = {
           {.name = "strength", .unit = "Pa", .mean = 25e6, .sd = 8e6, .low = 5e6, .high = 60e6}}}};
  std::vector<Scatter> repeats{{"mass", "1", 0.001}, {"fill", "1", 0.0004}, {"zero", "m", 4e-6}};

  std::vector<CalibratedParameter> const& calibrated() const override { return parameters; }
  std::vector<Mechanism> const& mechanisms() const override { return causes; }
  std::vector<Scatter> const& scatters() const override { return repeats; }

  struct Powder {
    double K, S, phi0, breakage, strength, plasticity, mu, solid; ///< solid = m / (rho A) [m]
  };

  Powder powder(Parameters const& at) const {
    double const stiffer = at.sizes.size() > 8 ? 1.0 + at.sizes[8] : 1.0;
    return {stiffer * at.calibrated[0],
            at.calibrated[1],
            phi_c + at.scatter[1],
            at.sizes[7],
            at.shapes[7][0],
            at.sizes[6],
            0.2 + at.sizes[4],
            mass * (1.0 + at.sizes[5]) * (1.0 + at.scatter[0]) / (density * area)};
  }
  static double loading(Powder const& p, double phi) {
    double const x = phi - p.phi0;
    if (x <= 0.0)
      return 0.0;
    auto const law = [&](double d) { return std::max(0.0, d * (p.K * std::sqrt(d) - p.S)); };
    double const sigma = law(x), broken = sigma / p.strength;
    // Fragments fill voids: the bed answers as if it were looser, smoothly from zero.
    return law(std::max(0.0, x - p.breakage * (1.0 - std::exp(-broken * broken))));
  }
  static double exponent(Powder const& p, double h) { return 0.8 * p.mu * h / diameter; }

  /// Force on the upper punch with the frame giving way: F = A sigma(h + z + C F) exp(..).
  static double upper(Powder const& p, double h, double compliance, auto const& stress,
                      double sign) {
    auto const at = [&](double gap) {
      return area * stress(p.solid / gap) * std::exp(sign * exponent(p, gap));
    };
    double F = at(h);
    if (compliance <= 0.0)
      return F;
    double low = 0.0, high = F;
    for (int k = 0; k < 40 && high - low > 1e-7 * high; ++k) { // the fall of at() is monotone
      double const middle = 0.5 * (low + high);
      (at(h + compliance * middle) > middle ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  void append_run(ToyRun const& run, Parameters const& at, std::vector<double>& rows) const {
    Powder const p = powder(at);
    double const zero = at.sizes[1] + at.scatter[2], C = at.sizes[0];
    auto const load = [&](double phi) { return loading(p, phi); };
    double const F_max = upper(p, run.end_gap + zero, C, load, 1.0);
    double const phi_max = p.solid / (run.end_gap + zero + C * F_max), peak = load(phi_max);
    double const phi_left = phi_max - 0.02 * (1.0 - p.plasticity);
    auto const unload = [&](double phi) {
      double const x = std::max(0.0, (phi - phi_left) / (phi_max - phi_left));
      return peak * x * std::sqrt(x);
    };
    auto const cell = [&](double F) { return (1.0 + at.sizes[2]) * F + at.sizes[3]; };
    std::vector<double> up[2], down[2];
    for (int phase = 0; phase < 2; ++phase)
      for (Index k = 0; k < n_points; ++k) {
        double const s = static_cast<double>(k) / static_cast<double>(n_points - 1);
        double const h = zero + (phase == 0 ? top + (run.end_gap - top) * std::sqrt(s)
                                            : run.end_gap * (1.0 + 0.03 * s));
        double const sign = phase == 0 ? 1.0 : -1.0;
        double const F = phase == 0 ? upper(p, h, C, load, sign) : upper(p, h, C, unload, sign);
        up[phase].push_back(cell(F));
        down[phase].push_back(F * std::exp(-2.0 * sign * exponent(p, h + C * F)));
      }
    for (auto const& one : up)
      rows.insert(rows.end(), one.begin(), one.end());
    if (gauges == Gauges::all) {
      for (auto const& one : down)
        rows.insert(rows.end(), one.begin(), one.end());
      rows.push_back(p.solid / phi_left);
    }
  }

  VectorXd predict(Parameters const& at) const override {
    std::vector<double> rows;
    for (auto const& run : runs)
      append_run(run, at, rows);
    return Eigen::Map<VectorXd>(rows.data(), static_cast<Index>(rows.size()));
  }

  /// The rows as observations.
  Observations observe(VectorXd const& rows) const {
    std::vector<ChannelBlock> blocks;
    Index next = 0;
    auto const take = [&](std::string const& run, std::string const& channel, Phase phase,
                          Index n) {
      blocks.push_back(block(run, channel, phase, rows.segment(next, n)));
      next += n;
    };
    for (auto const& run : runs) {
      take(run.name, "upper_punch_force", Phase::loading, n_points);
      take(run.name, "upper_punch_force", Phase::unloading, n_points);
      if (gauges == Gauges::upper)
        continue;
      take(run.name, "lower_punch_force", Phase::loading, n_points);
      take(run.name, "lower_punch_force", Phase::unloading, n_points);
      take(run.name, "compact_height", Phase::after, 1);
    }
    return Observations(blocks);
  }
};

/// The same with a modulus that the case fixes: its departure is a cause like any other.
inline ToyPress with_fixed_modulus(ToyPress press) {
  press.parameters[0].sd = 1e-6;
  press.parameters[0].name = "modulus_of_the_case";
  press.causes.push_back({.name = "young_modulus", .unit = "1", .scale = 0.15, .low = -0.8});
  return press;
}

inline ErrorSources toy_errors() {
  return {.channels = {{.channel = "upper_punch_force", .sd = 10.0, .has_kink = true},
                       {.channel = "lower_punch_force", .sd = 10.0, .has_kink = true},
                       {.channel = "compact_height", .sd = 1e-5, .model_share = 0.001}}};
}

/// A hidden truth: calibrated parameters off their means, one size, errors drawn from Sigma.
struct HiddenTruth {
  std::vector<std::pair<std::string, double>> sizes; ///< in prior scales
  double young = 0.4, cohesion = -0.5;               ///< in prior sds
};

inline Parameters hidden_parameters(ToyPress const& press, HiddenTruth const& truth) {
  Parameters at = nominal_parameters(press);
  at.calibrated[0] *= std::exp(press.parameters[0].sd * truth.young);
  at.calibrated[1] += press.parameters[1].sd * truth.cohesion;
  for (auto const& [name, size] : truth.sizes) {
    auto const j = std::ranges::find(press.causes, name, &Mechanism::name) - press.causes.begin();
    at.sizes[j] = size * press.causes[static_cast<std::size_t>(j)].scale;
  }
  return at;
}

inline Observations hidden_data(ToyPress const& press, HiddenTruth const& truth,
                                std::uint64_t seed) {
  auto const at = hidden_parameters(press, truth);
  VectorXd const f = press.predict(at);
  auto const errors = error_model(press.observe(f), press, toy_errors(), at, {});
  Whitener const whitener(errors.covariance, 1e-9);
  return press.observe(f + whitener.unwhiten(normals(seed, f.size(), 1)));
}

/// Names of the mechanisms with these numbers, sorted.
inline std::vector<std::string> names_of(ToyPress const& press, std::vector<int> const& causes) {
  std::vector<std::string> names;
  for (int const j : causes)
    names.push_back(press.causes[static_cast<std::size_t>(j)].name);
  std::ranges::sort(names);
  return names;
}

inline Diagnosis diagnose_hidden(ToyPress const& press, HiddenTruth const& truth,
                                 std::uint64_t seed) {
  return diagnose(hidden_data(press, truth, seed), press, toy_errors(),
                  {.misfit = {.n_draws = 999, .seed = seed + 1}});
}

/// Detectability of each mechanism, per prior scale.
inline std::vector<double> detectabilities(ToyPress const& press) {
  auto const found = diagnose_hidden(press, {}, 1);
  std::vector<double> all;
  for (auto const& one : found.library.signatures)
    all.push_back(one.detectability());
  return all;
}

} // namespace diagnosis_support
