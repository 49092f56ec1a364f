#pragma once

#include <array>
#include <string_view>

namespace hidden {

/// What can be wrong with a simulation of the press. The first twenty are the causes of the outward
/// contract; the rest is in nobody's library.
enum class Effect {
  frame_compliance,
  gap_offset,
  force_gain,
  force_offset,
  force_lag,
  thermal_drift,
  mass_error,
  die_size,
  punch_tilt,
  wall_friction,
  particle_friction,
  young_modulus,
  cohesion,
  plastic_contacts,
  breakage,
  rate_dependence,
  missing_fines,
  fill_state,
  die_compliance,
  multi_contact,
  agglomerate_collapse,
  stick_slip,
  guide_friction,
  cell_nonlinearity,
  pressure_friction
};
constexpr int n_known_effects = 20, n_effects = 25;

/// @param prior  largest size that a competent laboratory would meet, in `unit` (SI)
struct EffectKind {
  std::string_view name;
  double prior;
  std::string_view unit;
  bool is_one_sided; ///< sizes > 0 only
  std::string_view form;
};
/// In the order of Effect. Prior sizes: table 4.2 of the diagnosis note; those it lacks are
/// reasoned in the README.
std::array<EffectKind, n_effects> const& effect_kinds();
inline EffectKind const& kind_of(Effect effect) {
  return effect_kinds()[static_cast<std::size_t>(effect)];
}
/// Sizes that are simulated: five priors, no one-sided effect the other way, and neither E nor
/// cohesion less than a fifth of what it was.
double least_size(Effect effect);
double largest_size(Effect effect);
/// @throws std::invalid_argument for a name that is none
Effect effect_named(std::string_view name);

/// Sizes of all effects [SI]; 0 is off, and off changes no bit.
class Effects {
public:
  double operator[](Effect effect) const { return sizes_[static_cast<std::size_t>(effect)]; }
  Effects with(Effect effect, double size) const {
    Effects changed = *this;
    changed.sizes_[static_cast<std::size_t>(effect)] = size;
    return changed;
  }

private:
  std::array<double, n_effects> sizes_{};
};

} // namespace hidden
