#include "tests/diagnosis/grains/grain_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace hidden {
namespace {

using enum Place;

constexpr std::array<GrainCause, 14> causes = {{
    {Effect::frame_compliance, machine, 0.0, 1e-6, true, true},
    {Effect::wall_friction, grains, 0.2, 0.2, true, true},
    {Effect::gap_offset, machine, 0.0, 1e-3, true, true},
    {Effect::particle_friction, grains, 0.1, 0.3, true, true},
    {Effect::force_gain, machine, 0.1, 0.3, true, true},
    {Effect::plastic_contacts, grains, 1.0, 2.0, false, false},
    {Effect::mass_error, sheet, 0.0, 0.1, true, true},
    {Effect::multi_contact, grains, 0.3, 1.0, false, false},
    {Effect::force_offset, machine, 30.0, 500.0, true, true},
    {Effect::missing_fines, grains, 0.15, 0.4, false, false},
    {Effect::force_lag, machine, 5.0, 60.0, true, true},
    {Effect::breakage, grains, 1.0, 2.0, false, false},
    {Effect::thermal_drift, machine, 0.0, 2e-6, true, true},
    {Effect::die_size, sheet, 0.0, 1e-3, true, true},
}};

std::string entry(char const* path, double value, char const* unit = "") {
  return fmt::format("{}={:.6g}{}{}", path, value, *unit ? " " : "", unit);
}

} // namespace

std::span<GrainCause const> grain_causes() {
  return causes;
}

std::optional<GrainCause> grain_cause(Effect effect) {
  auto const at = std::ranges::find(causes, effect, &GrainCause::effect);
  return at == causes.end() ? std::nullopt : std::optional(*at);
}

GrainPress with_cause(GrainPress press, Effect effect, double size) {
  auto& more = press.more;
  switch (effect) {
  case Effect::wall_friction:
    press.wall_friction += size;
    break;
  case Effect::particle_friction:
    press.friction += size;
    break;
  case Effect::plastic_contacts:
    // Contacts yield at a pressure that falls with the size, a fifth of E at 1.
    more = {"Contact/Preset=custom", "Contact/Normal law=thornton_ning",
            "Contact/Cohesion law=sjkr2", "Contact/Tangential law=mindlin",
            entry("Contact/Yield pressure", 0.2 * press.young_modulus / size, "Pa")};
    break;
  case Effect::multi_contact:
    more = {entry("Contact/Multi-contact coefficient", size)};
    break;
  case Effect::missing_fines:
    more = {entry("Powder/Added fines/Share", size),
            entry("Powder/Added fines/Diameter", 0.9e-3, "m")};
    break;
  case Effect::breakage:
    // Grains break at a stress that falls with the size, 8 MPa at 1.
    more = {entry("Breakage/Strength", 8e6 / size, "Pa"),
            entry("Breakage/Reference diameter", 2e-3, "m"),
            entry("Breakage/Smallest diameter", 1.1e-3, "m")};
    break;
  default:
    throw std::invalid_argument(
        fmt::format("{} is no cause between grains. Is it the machine's?", kind_of(effect).name));
  }
  return press;
}

} // namespace hidden
