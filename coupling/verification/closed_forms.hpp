#pragma once

#include <cmath>

/// Answers known on paper, in terms of the mixed quantities of a contact. SI units.
namespace coupling::verification {

inline double const pi = std::acos(-1.0);

/// 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j  [Pa].  Johnson, Contact Mechanics (1985), eq. 4.24.
inline double effective_modulus(double E_i, double nu_i, double E_j, double nu_j) {
  return 1.0 / ((1.0 - nu_i * nu_i) / E_i + (1.0 - nu_j * nu_j) / E_j);
}

/// 1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j,  G = E/(2 (1 + nu))  [Pa].  Mindlin (1949).
inline double effective_shear_modulus(double E_i, double nu_i, double E_j, double nu_j) {
  return 1.0 / (2.0 * (2.0 - nu_i) * (1.0 + nu_i) / E_i + 2.0 * (2.0 - nu_j) * (1.0 + nu_j) / E_j);
}

/// a b / (a + b): effective radius and mass.
inline double reduced(double a, double b) {
  return a * b / (a + b);
}

inline double sphere_mass(double density, double radius) {
  return density * 4.0 / 3.0 * pi * radius * radius * radius;
}

/// Two elastic bodies that meet head-on.
struct HertzImpact {
  double effective_modulus; ///< E* [Pa]
  double effective_radius;  ///< R* [m]
  double effective_mass;    ///< m* [kg]
  double speed;             ///< v [m/s], relative, > 0

  /// K = 4/3 E* sqrt(R*)  [N/m^(3/2)]
  double stiffness() const { return 4.0 / 3.0 * effective_modulus * std::sqrt(effective_radius); }
  /// m* v^2 / 2 = 2/5 K d^(5/2)  [m]
  double max_overlap() const {
    return std::pow(5.0 * effective_mass * speed * speed / (4.0 * stiffness()), 0.4);
  }
  double max_force() const { return stiffness() * std::pow(max_overlap(), 1.5); }
  /// T = 2 d_max/v int_0^1 du / sqrt(1 - u^(5/2)) = (4/5) B(2/5, 1/2) d_max/v = 2.9433 d_max/v [s].
  /// Johnson (1985), eq. 11.24.
  double duration() const {
    double const beta = std::tgamma(0.4) * std::tgamma(0.5) / std::tgamma(0.9);
    return 0.8 * beta * max_overlap() / speed;
  }
  /// Yield pressure [Pa] whose first yield is at the impact speed V_y:
  ///   m* V_y^2 / 2 = 2/5 K d_y^(5/2),  d_y = (pi p_y / 2 E*)^2 R*
  double yield_pressure_of(double yield_speed) const {
    double const overlap =
        std::pow(5.0 * effective_mass * yield_speed * yield_speed / (4.0 * stiffness()), 0.4);
    return 2.0 * effective_modulus / pi * std::sqrt(overlap / effective_radius);
  }
};

/// e = (6 sqrt(3)/5)^(1/2) (1 - s^2/6)^(1/2) (s / (s + 2 sqrt(6/5 - s^2/5)))^(1/4), s = V_y/V.
/// Thornton and Ning, Powder Technol. 99 (1998) 154.
inline double thornton_ning_restitution(double s) {
  return std::sqrt(1.2 * std::sqrt(3.0) * (1.0 - s * s / 6.0)) *
         std::pow(s / (s + 2.0 * std::sqrt(1.2 - 0.2 * s * s)), 0.25);
}

/// Without adhesion:  e^2 = (2/5 (1 - l^(5/3)) - l (1 - l^(2/3))) / (2/5 (1 - l)), l = 1 - k1/k2.
inline double edinburgh_restitution(double l) {
  double const given = 0.4 * (1.0 - std::pow(l, 5.0 / 3.0)) - l * (1.0 - std::pow(l, 2.0 / 3.0));
  return std::sqrt(given / (0.4 * (1.0 - l)));
}

/// Force K d^(3/2) - c d: Hertz with a cohesion proportional to the overlap.
struct LinearCohesion {
  double stiffness; ///< K [N/m^(3/2)]
  double slope;     ///< c [N/m]

  double zero_force_overlap() const { return std::pow(slope / stiffness, 2); }
  double deepest_overlap() const { return 4.0 / 9.0 * zero_force_overlap(); }
  double deepest_force() const { return -4.0 / 27.0 * std::pow(slope, 3) / std::pow(stiffness, 2); }
};

/// Linear spring k and dashpot -2 beta sqrt(k m) with restitution e, from d = 0 back to d = 0.
/// T = pi / (w0 sqrt(1 - z^2)),  z = |ln e| / sqrt(ln^2 e + pi^2): the velocity ratio is exp(-pi z
/// / sqrt(1 - z^2)) = e.
inline double hooke_duration(double stiffness, double effective_mass, double restitution) {
  double const lne = std::log(restitution);
  double const z2 = lne * lne / (lne * lne + pi * pi);
  return pi / std::sqrt(stiffness / effective_mass * (1.0 - z2));
}

/// LIGGGHTS' linear stiffness, which stores at v the energy of Hertz:
/// k = 16/15 sqrt(R*) E* (15 m* v^2 / (16 sqrt(R*) E*))^(1/5)  [N/m]
inline double hooke_stiffness(double modulus, double radius, double mass, double speed) {
  double const s = std::sqrt(radius) * modulus;
  return 16.0 / 15.0 * s * std::pow(15.0 * mass * speed * speed / (16.0 * s), 0.2);
}

/// Johnson, Kendall and Roberts (1971), work of adhesion w [J/m^2].
struct Adhesion {
  double effective_modulus; ///< E* [Pa]
  double effective_radius;  ///< R* [m]
  double work;              ///< w [J/m^2]

  /// -(3/2) pi w R*  [N]
  double pull_off_force() const { return -1.5 * pi * work * effective_radius; }
  /// a0 = (9 pi w R*^2 / (2 E*))^(1/3)  [m]
  double zero_load_contact_radius() const {
    return std::cbrt(4.5 * pi * work * effective_radius * effective_radius / effective_modulus);
  }
  /// d0 = a0^2 / (3 R*)  [m]
  double zero_load_overlap() const {
    return std::pow(zero_load_contact_radius(), 2) / (3.0 * effective_radius);
  }
  /// Where the stable branch ends under displacement control, dd/da = 0: a^(3/2) = s R*/4 with s =
  /// sqrt(2 pi w/E*): d = -(3/4) s (s R*/4)^(1/3)  [m]
  double separation_overlap() const {
    double const s = std::sqrt(2.0 * pi * work / effective_modulus);
    return -0.75 * s * std::cbrt(s * effective_radius / 4.0);
  }
  /// Force there: -(5/6) pi w R*  [N]
  double separation_force() const { return -5.0 / 6.0 * pi * work * effective_radius; }
};

/// Area of the loop force against slip for a spring k_t and Coulomb's limit f, slip amplitude X >
/// f/k_t [J]: a parallelogram of height 2 f and width 2 (X - f/k_t).
inline double friction_loop_area(double limit, double tangential_stiffness, double amplitude) {
  return 4.0 * limit * (amplitude - limit / tangential_stiffness);
}

/// Rigid sphere that slides during the whole impact with impulse P = m (v_n + v_n') on the normal
/// side: the spin gains 5/2 mu (v_n + v_n')/R, the centre loses mu (v_n + v_n'), the contact point
/// 7/2 mu (v_n + v_n'). Foerster, Louge, Chang and Allia, Phys. Fluids 6 (1994) 1108.
struct SlidingImpact {
  double friction;      ///< mu
  double normal_speeds; ///< v_n + v_n' [m/s]
  double radius;        ///< [m]

  double spin_gain() const { return 2.5 * friction * normal_speeds / radius; }
  double centre_loss() const { return friction * normal_speeds; }
  double surface_loss() const { return 3.5 * friction * normal_speeds; }
};

} // namespace coupling::verification
