#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

/// An independent restatement of the contact law and of its integration, written from the equations
/// alone and in extended precision, all pairs against all pairs. It shares no code with dem/: where
/// the two agree, either both are right or two people misread the same line. Sources: Di Renzo and
/// Di Maio, Chem. Eng. Sci. 59 (2004) 525; Johnson, Contact Mechanics (1985), 4.2, 5.5;
/// LIGGGHTS-PUBLIC manual (models hertz, tangential history, sjkr, sjkr2, rolling_friction cdt);
/// powder-pressing paper of Ramirez-Aragon et al. (2020).
namespace oracle {

using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;

inline Real const pi = std::acos(Real(-1));

struct Elastic {
  Real young, poisson;
};

enum class Normal { hertz, hooke };
enum class Cohesion { none, sjkr, sjkr2, linear_reduced, linear_hertz_circle };
enum class Tangential { frictionless, history };

/// The laws of one pair of materials, with every switch.
struct Law {
  Elastic i, j;
  Real restitution, friction, rolling_friction, cohesion_energy_density;
  Normal normal = Normal::hertz;
  Cohesion cohesion = Cohesion::none;
  Tangential tangential = Tangential::history;
  bool cohesion_limits_friction = true; ///< mu |F_H + F_C| (true) or mu |F_H|
  bool tangential_dashpot = true;
  bool clip_tension = false;           ///< F_H >= 0
  Real characteristic_velocity = 0.2L; ///< [m/s], hooke
};

struct Body {
  Vec x, v, w;
  Real R, m;
  int material = 0;
  Vec F = Vec::Zero(), T = Vec::Zero();
  Real inertia() const { return Real(0.4L) * m * R * R; }
};

/// An infinite rigid plane; grains live on the side that `normal` points to.
struct Plane {
  Vec point, normal, v;
  int material = 1;
  Vec F = Vec::Zero(); ///< on the plane
};

/// What one contact does: on i directly, on j by reaction.
struct Action {
  Vec force;
  Vec torque_i, torque_j;
};

inline Real shear_modulus(Elastic const& e) {
  return e.young / (2 * (1 + e.poisson));
}

/// Area to which the linear cohesion applies [m^2].
inline Real cohesive_area(Cohesion law, Real d, Real Rred, Real Ri, Real Rj) {
  switch (law) {
  case Cohesion::none:
    return 0;
  // 2 pi (2 R*) d between grains; at a wall the code takes the grain's radius itself, not twice it.
  case Cohesion::sjkr2:
    return (Rj > 0 ? 4 : 2) * pi * Rred * d;
  case Cohesion::linear_reduced:
    return 2 * pi * Rred * d;
  case Cohesion::linear_hertz_circle:
    return pi * Rred * d;
  case Cohesion::sjkr:
    break;
  }
  if (Rj <= 0)
    return pi * d * (2 * Ri - d); // a plane cuts the sphere in a circle of radius^2 = d (2 R - d)
  Real const r = Ri + Rj - d;
  Real const outer = (Ri + Rj) * (Ri + Rj) - r * r;
  Real const inner = r * r - (Ri - Rj) * (Ri - Rj);
  return pi * outer * inner / (4 * r * r);
}

/// A meeting of sphere i with sphere j, or with a plane (Rj = 0, mj = 0: wall).
struct Meeting {
  Real Ri, Rj, mi, mj, d;
  Vec n, vi, vj, wi, wj;
};

/// The force law. `xi` is the tangential history; it advances by dt * slip velocity (dt = 0 leaves
/// it alone).
inline Action act(Law const& law, Meeting const& c, Vec& xi, Real dt) {
  bool const wall = c.Rj <= 0;
  Real const Rred = wall ? c.Ri : c.Ri * c.Rj / (c.Ri + c.Rj);
  Real const mred = wall ? c.mi : c.mi * c.mj / (c.mi + c.mj);
  Real const Estar = 1 / ((1 - law.i.poisson * law.i.poisson) / law.i.young +
                          (1 - law.j.poisson * law.j.poisson) / law.j.young);
  Real const Gstar =
      1 / ((2 - law.i.poisson) / shear_modulus(law.i) + (2 - law.j.poisson) / shear_modulus(law.j));
  Real const lne = std::log(law.restitution);
  Real const zeta = -lne / std::sqrt(lne * lne + pi * pi); // >= 0

  Real const ci = c.Ri - c.d / 2;
  Real const cj = wall ? Real(0) : c.Rj - c.d / 2;
  Vec const rel = c.vi - c.vj;
  Real const vn = rel.dot(c.n);
  Vec const slip = rel - vn * c.n - (ci * c.wi + cj * c.wj).cross(c.n);

  Real kn, kt, cn, ct;
  if (law.normal == Normal::hertz) {
    Real const a = std::sqrt(Rred * c.d);
    kn = 4 * Estar * a / 3;
    kt = 8 * Gstar * a;
    cn = 2 * std::sqrt(Real(5) / 6) * zeta * std::sqrt(2 * Estar * a * mred);
    ct = 2 * std::sqrt(Real(5) / 6) * zeta * std::sqrt(kt * mred);
  } else {
    Real const V = law.characteristic_velocity;
    Real const s = std::sqrt(Rred) * Estar;
    kn = Real(16) / 15 * s * std::pow(15 * mred * V * V / (16 * s), Real(0.2L));
    kt = kn;
    cn = 2 * zeta * std::sqrt(mred * kn);
    ct = cn;
  }
  if (!law.tangential_dashpot)
    ct = 0;

  Real FH = kn * c.d - cn * vn;
  if (law.clip_tension)
    FH = std::max(FH, Real(0));
  Real const FC = -law.cohesion_energy_density * cohesive_area(law.cohesion, c.d, Rred, c.Ri, c.Rj);

  Vec Ft = Vec::Zero();
  if (law.tangential == Tangential::history) {
    xi += slip * dt;
    xi -= xi.dot(c.n) * c.n;
    Real const limit = law.friction * std::abs(law.cohesion_limits_friction ? FH + FC : FH);
    Vec const spring = -kt * xi;
    if (spring.norm() > limit) {
      Ft = spring * (limit / spring.norm());
      xi = -Ft / kt;
    } else {
      Ft = spring - ct * slip;
    }
  }

  Action action;
  action.force = (FH + FC) * c.n + Ft;
  action.torque_i = -ci * c.n.cross(Ft);
  action.torque_j = -cj * c.n.cross(Ft);
  // Rolling: a constant torque mu_r R* times the elastic normal force against the relative rolling
  // spin (the part of w_i - w_j across the normal).
  Vec roll = c.wi - c.wj;
  roll -= roll.dot(c.n) * c.n;
  if (law.rolling_friction > 0 && roll.norm() > 0) {
    Vec const brake = law.rolling_friction * Rred * kn * c.d * roll / roll.norm();
    action.torque_i -= brake;
    action.torque_j += brake;
  }
  return action;
}

/// Many bodies and planes, every pair tried at every step.
class System {
public:
  std::vector<Body> bodies;
  std::vector<Plane> planes;
  std::map<std::pair<int, int>, Law> laws; ///< by (smaller, larger) material
  Vec gravity = Vec::Zero();

  /// Forces of the present state; history advances by `dt` (0: not at all).
  void gather(Real dt) {
    for (Body& b : bodies) {
      b.F = b.m * gravity;
      b.T.setZero();
    }
    for (Plane& p : planes)
      p.F.setZero();
    for (int i = 0; i < int(bodies.size()); ++i) {
      for (int j = i + 1; j < int(bodies.size()); ++j)
        meet(i, j, dt);
      for (int k = 0; k < int(planes.size()); ++k)
        meet_plane(i, k, dt);
    }
  }

  /// Kick, drift, forces from the half-step velocities, kick.
  void step(Real dt) {
    for (Body& b : bodies) {
      kick(b, dt / 2);
      b.x += dt * b.v;
    }
    for (Plane& p : planes)
      p.point += dt * p.v;
    gather(dt);
    for (Body& b : bodies)
      kick(b, dt / 2);
  }

  int n_contacts() const { return int(history_.size()); }

private:
  std::map<std::pair<int, int>, Vec> history_; // (i, j), or (i, -1 - plane)

  static void kick(Body& b, Real h) {
    b.v += h / b.m * b.F;
    b.w += h / b.inertia() * b.T;
  }

  Law const& law_of(int a, int b) const { return laws.at({std::min(a, b), std::max(a, b)}); }

  Vec& history(int i, int j) { return history_.try_emplace({i, j}, Vec::Zero()).first->second; }

  void meet(int i, int j, Real dt) {
    Body &a = bodies[i], &b = bodies[j];
    Vec const across = a.x - b.x;
    Real const r = across.norm(), d = a.R + b.R - r;
    if (d <= 0) {
      history_.erase({i, j});
      return;
    }
    Action const f =
        act(law_of(a.material, b.material), {a.R, b.R, a.m, b.m, d, across / r, a.v, b.v, a.w, b.w},
            history(i, j), dt);
    a.F += f.force;
    b.F -= f.force;
    a.T += f.torque_i;
    b.T += f.torque_j;
  }

  void meet_plane(int i, int k, Real dt) {
    Body& a = bodies[i];
    Plane& p = planes[k];
    Real const d = a.R - (a.x - p.point).dot(p.normal);
    if (d <= 0) {
      history_.erase({i, -1 - k});
      return;
    }
    Action const f =
        act(law_of(a.material, p.material),
            {a.R, 0, a.m, 0, d, p.normal, a.v, p.v, a.w, Vec::Zero()}, history(i, -1 - k), dt);
    a.F += f.force;
    a.T += f.torque_i;
    p.F -= f.force;
  }
};

} // namespace oracle
