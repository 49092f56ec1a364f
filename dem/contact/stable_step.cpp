#include "dem/contact/stable_step.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace dem {

namespace {

constexpr int rounds = 30;

/// Velocities and spins of all grains.
struct Motion {
  std::vector<Vec3> velocity, spin;
};

enum class Part { stiffness, dashpot };

/// y = B^T D B x: forces and torques of the springs (or dashpots) under the motion x.
void apply(std::vector<LinearContact> const& contacts, Part part, Motion const& x, Motion& y) {
  std::fill(y.velocity.begin(), y.velocity.end(), Vec3::Zero());
  std::fill(y.spin.begin(), y.spin.end(), Vec3::Zero());
  for (LinearContact const& c : contacts) {
    bool const is_pair = c.j != LinearContact::wall;
    Vec3 turning = c.lever_i * x.spin[c.i];
    Vec3 relative = x.velocity[c.i];
    if (is_pair)
      turning += c.lever_j * x.spin[c.j], relative -= x.velocity[c.j];
    relative -= turning.cross(c.normal);
    double const along = relative.dot(c.normal);
    double const normal = part == Part::stiffness ? c.normal_stiffness : c.normal_dashpot;
    double const tangential =
        part == Part::stiffness ? c.tangential_stiffness : c.tangential_dashpot;
    Vec3 const force = tangential * relative + (normal - tangential) * along * c.normal;
    Vec3 const moment = c.normal.cross(force);
    y.velocity[c.i] += force;
    y.spin[c.i] -= c.lever_i * moment;
    if (!is_pair)
      continue;
    y.velocity[c.j] -= force;
    y.spin[c.j] -= c.lever_j * moment;
  }
}

/// Largest eigenvalue of M^-1 B^T D B. The start is any fixed vector with a share of every mode.
double largest_eigenvalue(Spheres const& g, std::vector<LinearContact> const& contacts, Part part) {
  std::size_t const n = g.size();
  Motion x{std::vector<Vec3>(n), std::vector<Vec3>(n)}, y = x;
  for (std::size_t i = 0; i < n; ++i) {
    double const a = static_cast<double>(i);
    x.velocity[i] = Vec3(std::cos(1.7 * a), std::cos(2.3 * a + 1.0), std::cos(3.1 * a + 2.0));
    x.spin[i] =
        Vec3(std::cos(1.3 * a), std::cos(2.9 * a + 1.0), std::cos(3.7 * a + 2.0)) / g.radius[i];
  }
  double eigenvalue = 0.0;
  for (int k = 0; k < rounds; ++k) {
    apply(contacts, part, x, y);
    double power = 0.0, weight = 0.0, next_weight = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double const inertia = sphere_inertia(g.mass[i], g.radius[i]);
      power += x.velocity[i].dot(y.velocity[i]) + x.spin[i].dot(y.spin[i]);
      weight += g.mass[i] * x.velocity[i].squaredNorm() + inertia * x.spin[i].squaredNorm();
      y.velocity[i] /= g.mass[i];
      y.spin[i] /= inertia;
      next_weight += g.mass[i] * y.velocity[i].squaredNorm() + inertia * y.spin[i].squaredNorm();
    }
    if (power <= 0.0 || next_weight <= 0.0)
      return 0.0;
    eigenvalue = power / weight;
    double const scale = 1.0 / std::sqrt(next_weight);
    for (std::size_t i = 0; i < n; ++i) {
      x.velocity[i] = scale * y.velocity[i];
      x.spin[i] = scale * y.spin[i];
    }
  }
  return eigenvalue;
}

} // namespace

double stable_step(Spheres const& grains, std::vector<LinearContact> const& contacts) {
  double const w2 = largest_eigenvalue(grains, contacts, Part::stiffness);
  if (w2 <= 0.0)
    return std::numeric_limits<double>::infinity();
  double const w = std::sqrt(w2);
  double const z = largest_eigenvalue(grains, contacts, Part::dashpot) / (2.0 * w);
  return 2.0 / w * (std::sqrt(1.0 + z * z) - z);
}

} // namespace dem
