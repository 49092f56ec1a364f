#pragma once

#include <string>

namespace dem {

enum class Precision { full, mixed };

/// The contact model of a run, by the names of its laws (see dem/contact/contact_model.hpp for the
/// lists).
struct ContactChoice {
  std::string normal = "hertz";   ///< hertz | hooke | jkr | thornton_ning | edinburgh
  std::string cohesion = "sjkr2"; ///< none | sjkr | sjkr2 | linear_reduced | linear_hertz_circle
  std::string tangential = "mindlin"; ///< frictionless | mindlin | hooke_spring
  std::string rolling = "none";       ///< none | constant_torque
  std::string friction_limit =
      "net"; ///< net: mu |F_H + F_C| (LIGGGHTS 3.3.1); elastic: mu |F_H| (3.8 default)
  bool tangential_damping = true;
  bool clip_attractive_damping = false; ///< LIGGGHTS' limitForce: F_H >= 0
  double characteristic_velocity = 0.2; ///< [m/s], hooke only
  double yield_pressure = 0.0;          ///< p_y [Pa], thornton_ning only
  double plasticity_ratio = 0.0;        ///< lambda [1], edinburgh only
  double adhesion_exponent = 1.5;       ///< chi [1], edinburgh only
  /// A [s] of a dashpot A dF/dd beside each normal law: the viscoelastic sphere of Brilliantov,
  /// Spahn, Hertzsch and Poeschel, Phys. Rev. E 53 (1996) 5382, whose force is F + A dF/dt.
  double viscous_time = 0.0;
  double multi_contact = 0.0; ///< b [1], see multi_contact.hpp; 0: off
  Precision precision = Precision::mixed;
};

} // namespace dem
