#pragma once

#include "coupling/diagnosis/unexplained.hpp"
#include "coupling/finding/finding_of.hpp"
#include "coupling/reduced/press_plan.hpp"

namespace coupling::finding {

/// When and at which gap each row was measured; that of the turn for what is measured afterwards.
RowPlaces places_of(reduced::PressPlan const& plan);

/// What a misfit may hang on: how far the phase has gone, time, gap, force, speed of closing.
std::vector<diagnosis::RowInput> row_inputs(reduced::PressPlan const& plan,
                                            diagnosis::Observations const& observations,
                                            Eigen::VectorXd const& predicted);

} // namespace coupling::finding
