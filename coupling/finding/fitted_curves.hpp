#pragma once

#include "coupling/finding/finding_of.hpp"

namespace coupling::finding {

/// The rows of the fitted runs as curves, a run and channel each, in the order of their first rows:
/// measured, baseline and most probable hypothesis (each with the numerical bias), sd of all
/// errors.
/// @throws dem::InvalidInput for places of another number of rows
std::vector<RunCurve> fitted_curves(diagnosis::Diagnosis const& found,
                                    FindingSources const& sources);

} // namespace coupling::finding
