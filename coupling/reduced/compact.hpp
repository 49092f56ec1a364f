#pragma once

#include "coupling/reduced/causes.hpp"

namespace coupling::reduced {

/// Numbers that are measured once a run:
///   compact_height [m], compact_diameter [m] (that of the bore), compact_mass [kg], porosity [1]
///   of the compact, max_force [N], ejection_force [N] (what the wall holds at rest, mu p pi D h),
///   gap_at_peak [m] (between the faces, at the largest force), dead_weight [N] (what the load cell
///   shows of `dead_weight` newtons).
inline constexpr double dead_weight = 10e3; ///< [N]
bool is_foretold(std::string_view scalar);
double compact_number(std::string_view scalar, Press const& press,
                      std::vector<ChainReading> const& cycle);

} // namespace coupling::reduced
