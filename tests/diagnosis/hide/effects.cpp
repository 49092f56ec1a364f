#include "tests/diagnosis/hide/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace hidden {

std::array<EffectKind, n_effects> const& effect_kinds() {
  static std::array<EffectKind, n_effects> const all = {{
      {"frame_compliance", 20e-9, "m/N", true, "C (F + 0.25 F_s F / (F + F_s)), F_s = 3 kN"},
      {"gap_offset", 1e-4, "m", false, "z (1 + 0.1 (gap - 8 mm) / 12 mm)"},
      {"force_gain", 0.04, "1", false, "F g (1 + 0.1 (F / 30 kN - 0.5))"},
      {"force_offset", 100.0, "N", false, "o (1 + 0.1 exp(-t / 200 s))"},
      {"force_lag", 1.5, "s", true, "two first-order stages of half the lag"},
      {"thermal_drift", 10e-6 / 60.0, "m/s", false, "e T (1 - exp(-t / T)), T = 1800 s"},
      {"mass_error", 0.015, "1", false, "relative, 10 % of itself different from run to run"},
      {"die_size", 8e-5, "m", false, "on the diameter, a (1 - 0.3 (h / 20 mm)^2)"},
      {"punch_tilt", 2.5e-4, "m", true, "across the diameter, five strips side by side"},
      {"wall_friction", 0.06, "1", false,
       "0.7 a (0.9 + 0.2 depth / height), slice by slice; recovery + 0.65 a"},
      {"particle_friction", 0.06, "1", false, "0.15 tanh(a / 0.15) on onset, ratio, recovery"},
      {"young_modulus", 0.25, "1", false, "K (1 + a)"},
      {"cohesion", 0.5, "1", false, "S (1 + a), and recovery less by 0.01 a"},
      {"plastic_contacts", 0.3, "1", true, "softer above 20 MPa, less and straighter recovery"},
      {"breakage", 0.01, "1", true, "onset + a (1 - exp(-(s / 25 MPa)^2))"},
      {"rate_dependence", 0.02, "1", true, "(1 + rate / 1e-4 1/s)^a, hyperbolic in a dwell"},
      {"missing_fines", 0.008, "1", true, "onset - a (1 - 0.3 s / (s + 40 MPa))"},
      {"fill_state", 0.008, "1", true, "onset - a / (1 + s / 2 MPa)"},
      {"die_compliance", 5e-13, "m/Pa", true, "diameter + a p, slice by slice"},
      {"multi_contact", 0.3, "1", true, "K (1 + 0.3 a ((phi - phi_c) / 0.25)^3)"},
      {"agglomerate_collapse", 0.01, "1", true, "onset + a / (1 + (8 MPa / s)^12)"},
      {"stick_slip", 0.2, "1", true, "saw-tooth of 0.15 mm on the wall's force"},
      {"guide_friction", 150.0, "N", true, "with the direction of travel"},
      {"cell_nonlinearity", 0.03, "1", false, "F a (F / 30 kN)^2"},
      {"pressure_friction", 0.3, "1", false, "mu (p / 20 MPa)^-a"},
  }};
  return all;
}

double least_size(Effect effect) {
  auto const& kind = kind_of(effect);
  double const least = kind.is_one_sided ? 0.0 : -5.0 * kind.prior;
  bool const is_factor = effect == Effect::young_modulus || effect == Effect::cohesion;
  return is_factor ? std::max(least, -0.8) : least;
}
double largest_size(Effect effect) {
  return 5.0 * kind_of(effect).prior;
}

Effect effect_named(std::string_view name) {
  for (int k = 0; k < n_effects; ++k)
    if (effect_kinds()[static_cast<std::size_t>(k)].name == name)
      return static_cast<Effect>(k);
  throw std::invalid_argument(
      fmt::format("cause '{}' is no effect (the README lists them). Is it misspelt?", name));
}

} // namespace hidden
