#include "continuum/powder/loading_path.hpp"

#include "continuum/errors.hpp"
#include "continuum/tool/quote.hpp"

#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <limits>

namespace continuum {
namespace {

void add_row(LoadingPath& path, PowderLaw const& law, PointStep const& step) {
  Eigen::Matrix3d const& s = step.cauchy;
  double const axial = -s(2, 2), radial = -(s(0, 0) + s(1, 1)) / 2.0, p = -s.trace() / 3.0;
  path.height_ratio.push_back(step.point.deformation(2, 2));
  path.relative_density.push_back(relative_density(law, step.point.powder));
  path.axial_stress.push_back(axial);
  path.radial_stress.push_back(radial);
  path.shear_stress.push_back(s(0, 2));
  path.pressure.push_back(p);
  path.deviator.push_back(std::sqrt(1.5) * (s + p * Eigen::Matrix3d::Identity()).norm());
  path.stress_ratio.push_back(axial != 0.0 ? radial / axial
                                           : std::numeric_limits<double>::quiet_NaN());
  path.plastic_work.push_back(step.point.plastic_work);
  path.surface.push_back(step.surface);
}

PointStep require(OrFailure<PointStep> const& step) {
  if (!step)
    throw SolverFailure(step.failure().message());
  return *step;
}

/// Rows of a path whose i-th step, 1 to n, is given.
LoadingPath follow(PowderLaw const& law, PowderPoint& point, int n_steps,
                   std::function<PointStep(int)> const& step) {
  LoadingPath path;
  add_row(path, law, require(advance(law, point, point.deformation)));
  for (int i = 1; i <= n_steps; ++i) {
    PointStep const end = step(i);
    point = end.point;
    add_row(path, law, end);
  }
  return path;
}

Eigen::Matrix3d stretched(Eigen::Matrix3d const& F, double lateral, double axial) {
  return Eigen::Vector3d(std::exp(lateral), std::exp(lateral), std::exp(axial)).asDiagonal() * F;
}

/// A component of stress [Pa] at a stretch, and its slope by the logarithmic stretch.
struct Sample {
  PointStep step;
  double stress, slope;
};

/// Newton's iteration for the logarithmic stretch at which the stress has its target; a step of the
/// law that fails halves the move. Stiffness is bounded below, since a yielding bed may have none.
PointStep solve_for_stress(double target, std::function<OrFailure<PointStep>(double)> const& move,
                           std::function<Sample(PointStep const&)> const& sample) {
  constexpr int n_iterations = 60;
  constexpr double tolerance = 1e-12;
  double x = 0.0, scale = 0.0;
  Sample now = sample(require(move(x)));
  for (int i = 0; i < n_iterations; ++i) {
    double const gap = target - now.stress;
    scale = std::max(scale, std::abs(gap));
    if (std::abs(gap) <= tolerance * std::max(scale, std::abs(target)))
      return now.step;
    double change = gap / now.slope;
    for (int k = 0; k < 30; ++k, change /= 2.0) {
      auto const next = move(x + change);
      if (!next)
        continue;
      Sample const there = sample(*next);
      if (std::abs(target - there.stress) < std::abs(gap) || k == 29) {
        x += change;
        now = there;
        break;
      }
    }
  }
  // Rounding of the stress may end the gain a few digits above the tolerance.
  if (std::abs(target - now.stress) <= 1e-9 * std::max(scale, std::abs(target)))
    return now.step;
  throw SolverFailure("loading path: stress = " + quote(now.stress) + " Pa for a target of " +
                      quote(target) + " Pa after " + std::to_string(n_iterations) +
                      " iterations (the target is not reached). Is it beyond the strength?");
}

} // namespace

void LoadingPath::append(LoadingPath const& next) {
  auto const join = [](auto& all, auto const& more) {
    all.insert(all.end(), more.begin() + 1, more.end());
  };
  join(height_ratio, next.height_ratio);
  join(relative_density, next.relative_density);
  join(axial_stress, next.axial_stress);
  join(radial_stress, next.radial_stress);
  join(shear_stress, next.shear_stress);
  join(pressure, next.pressure);
  join(deviator, next.deviator);
  join(stress_ratio, next.stress_ratio);
  join(plastic_work, next.plastic_work);
  join(surface, next.surface);
}

LoadingPath press_to_height(PowderLaw const& law, PowderPoint& point, double height_ratio,
                            int n_steps) {
  double const start = point.deformation(2, 2);
  return follow(law, point, n_steps, [&](int i) {
    Eigen::Matrix3d F = point.deformation;
    F.row(2) *= (start + (height_ratio - start) * i / n_steps) / F(2, 2);
    return require(advance(law, point, F));
  });
}

LoadingPath press_to_stress(PowderLaw const& law, PowderPoint& point, double axial_stress,
                            int n_steps) {
  double const start = -cauchy_stress(law, point)(2, 2);
  return follow(law, point, n_steps, [&](int i) {
    auto const move = [&](double x) {
      return advance(law, point, stretched(point.deformation, 0.0, x));
    };
    auto const sample = [](PointStep const& step) {
      double const stress = step.cauchy(2, 2), J = step.point.volume_ratio();
      return Sample{step, -stress, -(step.tangent(8, 8) / J - stress)};
    };
    return solve_for_stress(start + (axial_stress - start) * i / n_steps, move, sample);
  });
}

LoadingPath compress_isotropically(PowderLaw const& law, PowderPoint& point, double volume_ratio,
                                   int n_steps) {
  double const step = std::log(volume_ratio / point.volume_ratio()) / (3.0 * n_steps);
  return follow(law, point, n_steps, [&](int) {
    return require(advance(law, point, stretched(point.deformation, step, step)));
  });
}

LoadingPath compress_triaxially(PowderLaw const& law, PowderPoint& point, double axial_strain,
                                int n_steps) {
  double const radial = -cauchy_stress(law, point)(0, 0);
  return follow(law, point, n_steps, [&](int) {
    auto const move = [&](double x) {
      return advance(law, point, stretched(point.deformation, x, -axial_strain / n_steps));
    };
    auto const sample = [](PointStep const& step) {
      double const stress = step.cauchy(0, 0), J = step.point.volume_ratio();
      double const slope = (step.tangent(0, 0) + step.tangent(0, 4)) / J - 2.0 * stress;
      return Sample{step, -stress, -slope};
    };
    return solve_for_stress(radial, move, sample);
  });
}

LoadingPath shear_simply(PowderLaw const& law, PowderPoint& point, double gamma, int n_steps) {
  Eigen::Matrix3d const start = point.deformation;
  return follow(law, point, n_steps, [&](int i) {
    Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
    shear(0, 2) = gamma * i / n_steps;
    return require(advance(law, point, shear * start));
  });
}

} // namespace continuum
