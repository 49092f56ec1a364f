#pragma once

#include "coupling/reduced/bed_fit.hpp"
#include "coupling/reduced/cycle_rows.hpp"

namespace coupling::reduced {

/// Unloading's numbers and tables of the law in `fit`, whose loading is known: r, d (with `shape`
/// r, p).
/// @param turn  the record of the smallest height
/// @return  false, with a statement, if the records do not say enough
bool fit_unloading(BedFit& fit, CycleRows const& rows, CycleRows const& turn,
                   BedFitOptions const& options);

} // namespace coupling::reduced
