#pragma once

#include "coupling/diagnosis/next_measurement.hpp"
#include "coupling/reduced/pressed_height.hpp"

#include <vector>

namespace coupling::finding {

/// What a laboratory that knows single numbers of a pressing could measure next, foretold at the
/// fitted baseline: another force, the bare punches, the opening, gauge and caliper. Costs are
/// minutes.
std::vector<diagnosis::CandidateMeasurement>
height_candidates(reduced::PressedHeight const& model, diagnosis::Parameters const& baseline,
                  diagnosis::Tolerances const& tolerances);

} // namespace coupling::finding
