#pragma once

#include "continuum/powder/cap_model.hpp"

namespace continuum {

/// How the deck's hardening is read: its table counts from D = 0.30, its powder starts at 0.3411.
enum class HardeningReading {
  as_filed,  ///< A: eps_v^p = 0 of the table is the start at 0.3411
  consistent ///< B: p_b belongs to the density of its row
};

/// Microcrystalline cellulose Avicel PH-102, density-dependent cap, a = 0.
/// Source: repository taha-re/manuscript-data-density-dependent-friction-tableting, commit 83e1922,
/// c-dpc-table-P.txt, c-cap-table.txt, c-elastic-table.txt; "Panos 2007" there. powder.md 1.3.
DruckerPragerCap avicel_ph102(HardeningReading reading);

/// Wall friction of the same source [-] over D; Michrafy et al. (2003).
enum class WallLubrication { none, powder, die };
PiecewiseLinear avicel_ph102_wall_friction(WallLubrication lubrication);

} // namespace continuum
