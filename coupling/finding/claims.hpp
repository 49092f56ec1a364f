#pragma once

#include "coupling/diagnosis/diagnose.hpp"
#include "coupling/diagnosis/next_measurement.hpp"

#include <vector>

/// Which of the fitted hypotheses a verdict speaks of.
namespace coupling::finding {

/// The one that the verdict claims; nullptr if it names nothing.
diagnosis::Hypothesis const* claimed_hypothesis(diagnosis::Diagnosis const& found);

/// The most probable single cause that the verdict does not claim: the placebo. nullptr if none was
/// fitted.
diagnosis::Hypothesis const* best_wrong_hypothesis(diagnosis::Diagnosis const& found);

/// Members of the group that were fitted alone, the most probable first, five at most.
std::vector<diagnosis::PossibleCause> possible_causes(diagnosis::Diagnosis const& found);

} // namespace coupling::finding
