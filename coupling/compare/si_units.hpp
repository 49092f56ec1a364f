#pragma once

#include "coupling/record/press_record.hpp"

#include <string>

namespace coupling {

/// What turns a written number into SI, and the unit that it then has.
struct SiScale {
  double factor;
  std::string unit; ///< N, m, Pa, J, s, kg, 1 ..., or as written where it has no name of its own
};

/// @param where  `file:line: name`, for the message
/// @throws dem::InvalidInput if `unit` is none
SiScale si_scale(std::string const& unit, std::string const& where);

/// The same record in SI units.
/// @throws dem::InvalidInput if a column has no unit of mass, length and time, or a known column
/// the wrong one
PressRecord in_si(PressRecord const& record, std::string const& file);

} // namespace coupling
