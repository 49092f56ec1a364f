#include "tests/diagnosis/hide/powder.hpp"

#include <algorithm>
#include <cmath>

namespace hidden {

BedLaw::BedLaw(Powder const& powder, Effects const& effects)
    : stiffness_(4.3e8 * powder.young_modulus / 1375e6 * (1.0 + effects[Effect::young_modulus])),
      cohesion_(0.85e7 * powder.young_modulus / 1375e6 +
                2.5 * powder.cohesion_density * (1.0 + effects[Effect::cohesion])),
      onset_(powder.onset), exponent_(powder.exponent), ratio_(powder.radial_ratio),
      friction_(powder.wall_friction),
      recovery_(powder.recovery - 0.01 * effects[Effect::cohesion]), curvature_(powder.curvature),
      residual_(powder.residual), effects_(effects) {
  // Rougher grains pack looser, press less on the wall and come back less, all saturating.
  double const rough = 0.15 * std::tanh(effects[Effect::particle_friction] / 0.15);
  onset_ -= 0.06 * rough;
  ratio_ -= 0.75 * rough;
  recovery_ += 0.65 * effects[Effect::wall_friction] - 0.15 * rough;
}

double BedLaw::onset(double stress) const {
  double const crushed = 1.0 - std::exp(-std::pow(stress / (25 * MPa), 2));
  double const collapsed = 1.0 / (1.0 + std::pow(8 * MPa / std::max(stress, 1.0), 12));
  return onset_ + effects_[Effect::breakage] * crushed +
         effects_[Effect::agglomerate_collapse] * collapsed -
         effects_[Effect::missing_fines] * (1.0 - 0.3 * stress / (stress + 40 * MPa)) -
         effects_[Effect::fill_state] / (1.0 + stress / (2 * MPa));
}

double BedLaw::densification(double stress) const {
  double const more = 0.3 * effects_[Effect::multi_contact] / std::pow(0.25, 3);
  // Above both the pole of cohesion and the root the function is convex: Newton falls onto it.
  double x = std::pow(stress / stiffness_, 1.0 / exponent_) +
             std::pow(cohesion_ / stiffness_, 1.0 / (exponent_ - 1.0)) + 0.02;
  for (int k = 0; k < 30; ++k) {
    double const power = stiffness_ * std::pow(x, exponent_ - 1.0);
    double const value = x * (power * (1.0 + more * x * x * x) - cohesion_) - stress;
    double const slope = power * (exponent_ + (exponent_ + 3.0) * more * x * x * x) - cohesion_;
    double const step = value / slope;
    x -= step;
    if (std::abs(step) < 1e-9)
      break;
  }
  return x;
}

double BedLaw::loaded(double stress) const {
  // Yielding contacts bear less at the same approach: the elastic law is asked for more.
  double const yielding = 0.3 * effects_[Effect::plastic_contacts];
  double const above = std::max(0.0, stress - 20 * MPa);
  return onset(stress) + densification(stress + yielding * above * above / (above + 30 * MPa));
}

double BedLaw::solid_fraction(double stress, double largest, double most) const {
  if (stress >= largest || largest <= 0.0)
    return loaded(std::max(stress, 0.0));
  double const yielded = effects_[Effect::plastic_contacts] * largest / (largest + 20 * MPa);
  // Grains give back what they were pressed beyond the onset that they have then.
  double const way = recovery_ * (1.0 - yielded) * std::log(most / onset(largest));
  double const bend = curvature_ * (1.0 - 0.4 * effects_[Effect::plastic_contacts]);
  double const share = std::log1p(std::expm1(bend) * std::max(stress, 0.0) / largest) / bend;
  return most * std::exp(-way * (1.0 - share));
}

double BedLaw::radial(double stress, double largest) const {
  if (stress >= largest)
    return ratio_ * stress;
  return ratio_ * (residual_ * largest + (1.0 - residual_) * std::max(stress, 0.0));
}

double BedLaw::friction(double depth, double radial_pressure) const {
  double const own = friction_ + 0.7 * effects_[Effect::wall_friction] * (0.9 + 0.2 * depth);
  double const falls = effects_[Effect::pressure_friction];
  double const p = std::max(radial_pressure, 0.1 * MPa) / (20 * MPa);
  return std::max(own, 0.0) * std::pow(p, -falls);
}

} // namespace hidden
