#pragma once

#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/cycle_rows.hpp"

namespace coupling::reduced {

/// First loading's numbers and tables of a law: K, S, phi_c, n, k, mu.
/// @return  r.m.s. of the stress that the formula misses, share of the largest [1]
/// @throws dem::InvalidInput if no bed bears like this
double fit_loading(BedLaw& law, CycleRows const& rows, BedFitOptions const& options);

} // namespace coupling::reduced
