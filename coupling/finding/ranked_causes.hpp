#pragma once

#include "coupling/finding/finding_of.hpp"

namespace coupling::finding {

/// Causes by name, in the order of a report. See finding_of.
std::vector<FoundCause> ranked_causes(diagnosis::Diagnosis const& found,
                                      FindingSources const& sources);

/// Names of the group, at least two where there are so many causes. See finding_of.
std::vector<std::string> group_of(diagnosis::Diagnosis const& found, FindingSources const& sources,
                                  std::vector<FoundCause> const& ranked);

/// The calibrated parameters with standard deviations from the curvature of the objective at its
/// least,  C = (J' J + diag(rho^2 / 2)'')^-1 in units of the priors, causes of the best hypothesis
/// free beside them.
std::vector<CalibratedValue> calibrated_values(diagnosis::Diagnosis const& found,
                                               diagnosis::Model const& model);

/// The most probable hypothesis that has a cause; the baseline without one.
diagnosis::Fit const& best_fit(diagnosis::Diagnosis const& found);

/// "cohesion" for "cohesion_energy_density": as the contract calls a calibrated parameter's cause.
std::string cause_name_of(std::string const& parameter);

/// A size beside the largest that a competent laboratory would meet, in words.
/// @param size_in_scales  |size| over the scale of its prior
std::string plausibility_in_words(double size_in_scales);

} // namespace coupling::finding
