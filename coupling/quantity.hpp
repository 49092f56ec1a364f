#pragma once

#include <string>
#include <string_view>

/// Values with units as a person writes them: `22.05 mm`, `7e6 J/m^3`, `1 mm/min`, `35 %`; a bare
/// number is SI.
namespace coupling {

/// Powers of kilogram, metre and second.
struct Dimension {
  int mass = 0, length = 0, time = 0;
  bool operator==(Dimension const&) const = default;
};

/// What an entry measures. Energy density and modulus share a dimension but not the units people
/// use for them.
enum class Physical {
  ratio,
  length,
  mass,
  time,
  speed,
  acceleration,
  stiffness,
  angular_speed,
  force,
  modulus,
  density,
  energy_density,
  surface_energy,
  force_rate
};

/// A physical quantity in words.
struct PhysicalName {
  std::string_view words;    ///< "a length"
  std::string_view si;       ///< "m"; empty for a ratio
  std::string_view examples; ///< "m, mm, um"
  Dimension dimension;
};

PhysicalName const& describe(Physical physical);

/// A written value in SI units. Powers of ten are applied to the decimal text, so `22.05 mm` is the
/// same double as the literal 22.05e-3.
/// @throws dem::InvalidInput  `problem (why). Way out?`, for the caller to put the place in front
double parse_quantity(std::string_view text, Physical physical);

/// The shortest text that `parse_quantity` reads as the same double: `0.02205 m`.
std::string print_quantity(double value, Physical physical);

/// The same number without a unit.
std::string print_number(double value);

} // namespace coupling
