#pragma once

#include "coupling/case_file.hpp"
#include "coupling/press_set_up.hpp"
#include "dem/step/advance.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include <fstream>
#include <numbers>
#include <string>
#include <vector>

/// Seven equal spheres between elastic punches, one in the middle and six around it, none at the
/// die: a bed whose answer is Hertz's, with nothing that could fall one way or the other.
namespace layer {

constexpr double radius = 2.95e-3;                            // [m]
constexpr double spacing = 6.2e-3;                            // [m]
constexpr double stroke = 0.1e-3;                             // [m]
constexpr double grain_modulus = 250e6, wall_modulus = 200e6; // [Pa]
constexpr double grain_ratio = 0.25, wall_ratio = 0.29;

/// 1 / E* = (1 - nu_1^2) / E_1 + (1 - nu_2^2) / E_2
inline double effective_modulus() {
  return 1.0 / ((1.0 - grain_ratio * grain_ratio) / grain_modulus +
                (1.0 - wall_ratio * wall_ratio) / wall_modulus);
}

/// K of F = K overlap^(3/2) at a punch: 4/3 E* sqrt(R) [N/m^1.5].
inline double stiffness() {
  return 4.0 / 3.0 * effective_modulus() * std::sqrt(radius);
}

inline std::vector<dem::Vec3> centres() {
  std::vector<dem::Vec3> points{{0.0, 0.0, radius}};
  for (int k = 0; k < 6; ++k) {
    double const angle = (k + 0.25) * std::numbers::pi / 3.0;
    points.emplace_back(spacing * std::cos(angle), spacing * std::sin(angle), radius);
  }
  return points;
}

/// Pressed by `stroke` in 2 ms, then held for as long as the spheres need to come to rest.
inline coupling::Press press(support::ScratchFolder const& scratch,
                             std::vector<std::string> const& changes) {
  auto const file = scratch / "layer.csv";
  std::ofstream out(file);
  out << "x [m],y [m],z [m],diameter [m],component\n";
  for (dem::Vec3 const& x : centres())
    out << fmt::format("{},{},{},{},MgO\n", x.x(), x.y(), x.z(), 2.0 * radius);
  out.close();
  std::vector<std::string> entries{"Powder/Fill method=file",
                                   "Powder/Fill file=" + file.string(),
                                   fmt::format("Powder/Fill height={} m", 2.0 * radius),
                                   "Tooling/Punch length=400 mm",
                                   "Deformable tools/Cell size=8 mm",
                                   "Deformable tools/Punch support=guided",
                                   "Deformable tools/Window=10",
                                   "Contact/Particle-particle/Cohesion energy density=0 J/m^3",
                                   "Contact/Particle-wall/Cohesion energy density=0 J/m^3",
                                   "Contact/Precision=double",
                                   "Gravity/z=0 m/s^2",
                                   "Output/Snapshot interval=0 s",
                                   "Press programme/Stage 1/Speed=-0.05 m/s",
                                   "Press programme/Stage 1/Until=time",
                                   "Press programme/Stage 1/Duration=2 ms",
                                   "Press programme/Stage 2/Kind=hold",
                                   "Press programme/Stage 2/Name=rest",
                                   "Press programme/Stage 2/Duration=20 ms",
                                   "Press programme/Stage 3/Kind=none",
                                   "Press programme/Stage 4/Kind=none"};
  entries.insert(entries.end(), changes.begin(), changes.end());
  return coupling::set_up_press(coupling::parse_case("set Title = Layer\n", "layer.prm", entries));
}

/// Force on the punches with the spheres at rest between elastic punches: for every sphere
///   2 (F_i / (4/3 E* sqrt(R)))^(2/3) + sum_j (C_u + C_l)_ij F_j = stroke,
/// C_ij the retreat at sphere i under a unit force at sphere j, by Newton's method.
inline double series_force(coupling::Press const& press, double approach) {
  auto const points = centres();
  auto const n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t t : {1u, 2u}) {
    auto const& tool = press.coupling.tool(t);
    double const into = t == 1 ? 1.0 : -1.0;
    coupling::FaceLocator const locator(tool.surface->trace());
    std::vector<dem::SurfacePlace> places;
    for (dem::Vec3 const& x : points)
      places.push_back(locator.nearest({x.x(), x.y(), 0.0}).place);
    for (Eigen::Index j = 0; j < n; ++j) {
      auto const at = [&](Eigen::Index k) { return places[static_cast<std::size_t>(k)]; };
      dem::WallImpulse const unit{static_cast<std::uint32_t>(t), at(j), {0.0, 0.0, into}};
      auto const u = tool.compliance.displacement(tool.surface->nodal(std::span(&unit, 1), t));
      for (Eigen::Index i = 0; i < n; ++i) {
        auto const shape = continuum::face_shape(at(i).xi, at(i).eta);
        for (int a = 0; a < 9; ++a)
          C(i, j) +=
              into * shape[a] * u(2, tool.surface->trace().faces[at(i).face].nodes[std::size_t(a)]);
      }
    }
  }
  Eigen::VectorXd F = Eigen::VectorXd::Constant(n, 1e-3 * stiffness() * std::pow(approach, 1.5));
  for (int k = 0; k < 60; ++k) {
    Eigen::VectorXd const overlap = (F / stiffness()).array().pow(2.0 / 3.0);
    Eigen::MatrixXd slope = C;
    slope.diagonal().array() += 4.0 / 3.0 * overlap.array() / F.array();
    Eigen::VectorXd const step =
        slope.partialPivLu().solve(Eigen::VectorXd::Constant(n, approach) - 2.0 * overlap - C * F);
    for (Eigen::Index i = 0; i < n; ++i)
      F[i] = std::max(F[i] + step[i], 0.1 * F[i]);
  }
  return F.sum();
}

} // namespace layer
