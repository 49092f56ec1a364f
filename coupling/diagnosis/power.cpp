#include "coupling/diagnosis/power.hpp"

#include "coupling/diagnosis/fit.hpp"
#include "coupling/diagnosis/tangent.hpp"
#include "dem/expect.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int halvings = 40; // from the largest size down: 1e-12 of it is no size

void validate(PowerSettings const& settings) {
  VALIDATE(settings.detection > 0.0 && settings.separation > 0.0 && settings.most_scales > 0.0 &&
               settings.n_segments > 0,
           fmt::format(
               "power: detection {:g}, separation {:g}, {:g} prior scales, {} segments (all "
               "are positive). Is one left out?",
               settings.detection, settings.separation, settings.most_scales, settings.n_segments));
}

/// Vertices of e(b) for sizes b from 0 to the largest of a sign, n_extended x n.
using Chain = MatrixXd;

/// |point - segment from a to b|
double distance(VectorXd const& point, Eigen::Ref<VectorXd const> const& a,
                Eigen::Ref<VectorXd const> const& b) {
  VectorXd const along = b - a;
  double const length = along.squaredNorm();
  double const s = length > 0.0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - a - s * along).norm();
}

double distance(VectorXd const& point, Chain const& chain) {
  double least = no_bound;
  for (Index k = 0; k + 1 < chain.cols(); ++k)
    least = std::min(least, distance(point, chain.col(k), chain.col(k + 1)));
  return least;
}

/// Signs that a mechanism's size may have.
std::vector<double> signs_of(Mechanism const& one) {
  std::vector<double> signs = {1.0};
  if (!one.is_one_sided && one.low < 0.0)
    signs.push_back(-1.0);
  return signs;
}

/// The largest size of a sign, not beyond its bound.
double most_of(Mechanism const& one, double sign, double scales) {
  return std::min(scales * one.scale, sign > 0.0 ? one.high : -one.low);
}

/// What sizes do to the planned rows, where errors count alike and calibration is taken away.
class Effects {
public:
  Effects(Observations const& planned, Model const& model, ErrorSources const& sources)
      : model_(model), nominal_(nominal_parameters(model)),
        baseline_(predict_rows(model, nominal_, planned.size())),
        comparison_{&model, baseline_,
                    Whitener(error_model(planned, model, sources, nominal_, {}).covariance,
                             sources.tolerances.largest_jitter)},
        tangent_(fit_baseline(comparison_).slopes) {}

  /// e(a) = P L^-1 (f(a) - f(0)), [n_extended]
  VectorXd of(int mechanism, double size, VectorXd const& shapes) const {
    Parameters at = nominal_;
    at.sizes[mechanism] = size;
    at.shapes[static_cast<std::size_t>(mechanism)] = shapes;
    return tangent_.project(
        comparison_.whitener.whiten(predict_rows(model_, at, baseline_.size()) - baseline_));
  }
  VectorXd of(int mechanism, double size) const {
    return of(mechanism, size, nominal_.shapes[static_cast<std::size_t>(mechanism)]);
  }

  /// The curves that a rival can make: each sign, each variant of its shape.
  std::vector<Chain> chains(int mechanism, int n_segments) const {
    auto const place = static_cast<std::size_t>(mechanism);
    auto const& one = model_.mechanisms()[place];
    std::vector<VectorXd> variants = {nominal_.shapes[place]};
    for (std::size_t k = 0; k < one.shapes.size(); ++k)
      for (double const side : {-1.0, 1.0}) {
        auto const& shape = one.shapes[k];
        variants.push_back(nominal_.shapes[place]);
        variants.back()[static_cast<Index>(k)] =
            std::clamp(shape.mean + side * shape.sd, shape.low, shape.high);
      }
    std::vector<Chain> all;
    for (auto const& shapes : variants)
      for (double const sign : signs_of(one)) {
        double const most = sign * most_of(one, sign, rival_scales);
        Chain chain = Chain::Zero(tangent_.n_extended(), n_segments + 1);
        for (int k = 1; k <= n_segments; ++k)
          chain.col(k) = of(mechanism, most * k / n_segments, shapes);
        all.push_back(std::move(chain));
      }
    return all;
  }

private:
  Model const& model_;
  Parameters nominal_;
  VectorXd baseline_;
  Comparison comparison_;
  TangentSpace tangent_;
};

/// The least size from `from` to `most` at which `excess` is not negative: doubled until it is,
/// then TOMS 748. @param from  > 0; where it is enough already, it is the answer
std::optional<double> least_size(auto const& excess, double from, double most) {
  double low = from, at_low = excess(from);
  if (at_low >= 0.0)
    return from;
  while (low < most) {
    double const high = std::min(2.0 * low, most), at_high = excess(high);
    if (at_high >= 0.0) {
      std::uintmax_t n_calls = 30;
      auto const tolerance = [](double a, double b) { return b - a <= 1e-3 * b; };
      auto const [a, b] =
          boost::math::tools::toms748_solve(excess, low, high, at_low, at_high, tolerance, n_calls);
      return 0.5 * (a + b);
    }
    low = high, at_low = at_high;
  }
  return std::nullopt;
}

struct Nearest {
  int rival = -1;
  double distance = no_bound;
};

Nearest nearest_rival(VectorXd const& effect, int own,
                      std::vector<std::vector<Chain>> const& chains) {
  Nearest nearest;
  for (std::size_t j = 0; j < chains.size(); ++j)
    if (static_cast<int>(j) != own)
      for (auto const& chain : chains[j])
        if (double const d = distance(effect, chain); d < nearest.distance)
          nearest = {static_cast<int>(j), d};
  return nearest;
}

/// One sign of one mechanism.
struct SignPower {
  double detected = no_bound, told = no_bound;
  Nearest nearest{};
};

SignPower power_of_sign(Effects const& effects, int mechanism, double sign, double most,
                        std::vector<std::vector<Chain>> const& chains,
                        PowerSettings const& settings) {
  auto const seen = [&](double size) {
    return effects.of(mechanism, sign * size).norm() - settings.detection;
  };
  auto const apart = [&](double size) {
    return nearest_rival(effects.of(mechanism, sign * size), mechanism, chains).distance -
           settings.separation;
  };
  double from = most;
  for (int k = 0; k < halvings && seen(from) >= 0.0; ++k)
    from *= 0.5;
  SignPower power;
  if (auto const detected = least_size(seen, from, most)) {
    power.detected = *detected;
    power.told =
        chains.size() < 2 ? *detected : least_size(apart, *detected, most).value_or(no_bound);
  }
  double const at = std::isfinite(power.told) ? power.told : most;
  power.nearest = nearest_rival(effects.of(mechanism, sign * at), mechanism, chains);
  return power;
}

} // namespace

std::vector<Power> power_of(Observations const& planned, Model const& model,
                            ErrorSources const& sources, PowerSettings const& settings) {
  validate(settings);
  validate(model);
  Effects const effects(planned, model, sources);
  auto const& mechanisms = model.mechanisms();
  auto const n = static_cast<int>(mechanisms.size());
  std::vector<std::vector<Chain>> chains;
  for (int j = 0; j < n; ++j)
    chains.push_back(effects.chains(j, settings.n_segments));
  std::vector<Power> all;
  for (int j = 0; j < n; ++j) {
    auto const& one = mechanisms[static_cast<std::size_t>(j)];
    std::optional<SignPower> harder;
    double detected = 0.0;
    for (double const sign : signs_of(one)) {
      auto const own = power_of_sign(effects, j, sign, most_of(one, sign, settings.most_scales),
                                     chains, settings);
      detected = std::max(detected, own.detected);
      if (!harder || own.told > harder->told)
        harder = own;
    }
    auto const rival = harder->nearest.rival;
    all.push_back({.name = one.name,
                   .unit = one.unit,
                   .scale = one.scale,
                   .detected = detected,
                   .told = std::max(harder->told, detected),
                   .rival = rival < 0 ? "" : mechanisms[static_cast<std::size_t>(rival)].name,
                   .rival_distance = harder->nearest.distance});
  }
  return all;
}

} // namespace coupling::diagnosis
