#pragma once

#include "coupling/study/response_surface.hpp"

#include <vector>

namespace coupling::study {

/// Whether the runs determine the terms of a model.
/// @throws dem::InvalidInput in this order: tables whose sizes differ or that hold no numbers,
/// terms that are no terms of these factors or lack a linear part, a constant factor, two factors
/// that move together, fewer runs or fewer different points than terms, terms that are sums of
/// others
void validate_estimable(Observations const& data, std::vector<Term> const& terms);

} // namespace coupling::study
