#pragma once

#include "coupling/study/calibration.hpp"

#include <string>
#include <vector>

namespace coupling::study {

/// What the numbers of a calibration mean: agreement or contradiction, targets out of reach, bounds
/// that are hit, intervals that the bounds end, surfaces without an error, bounds beyond the
/// design.
std::vector<std::string> statements_on(CalibrationProblem const& problem, Calibration const& found);

} // namespace coupling::study
