#pragma once

#include "coupling/diagnosis/observations.hpp"
#include "coupling/reduced/pressed_height.hpp"

#include <string>
#include <vector>

namespace coupling::finding {

/// By how much the punch faces of a pressing stood further apart than the machine takes them to,
///   H / (1 + s) - gap - D_own(F),
/// with the compact's height H as measured or from its porosity, and the uncertainty of springback,
/// density, gap and H.
struct MissingApproach {
  double gap, height;  ///< [m], told by the machine; of the compact
  double value, sd;    ///< [m]
  double least, most;  ///< [m], at the densities sqrt(3) sd above and below: the ends of a range
                       ///< that all are equally likely in; both `value` without a porosity
  double sole_density; ///< [kg/m^3], at which nothing would be missing; 0 without a porosity
};
/// @param row       place of a compact_height or a porosity
/// @param measured  its value
/// @param sd        of that
MissingApproach missing_approach(reduced::PressedHeight const& model, std::size_t row,
                                 double measured, double sd);

/// What gap and compact say to each other, a sentence each, for a press operator.
/// @param is_contradiction  an alarm was raised
std::vector<std::string> height_sentences(reduced::PressedHeight const& model,
                                          reduced::HeightRows const& rows, bool is_contradiction);

} // namespace coupling::finding
