#pragma once

#include "coupling/elastic/tool_coupling.hpp"
#include "coupling/record/press_record.hpp"

#include <filesystem>

namespace coupling {

/// Loads spread over the surface with Lucy's kernel of the radius w [m],
///   f'_a = sum_b W(|x_a - x_b| / w) f_b / sum_c W(|x_c - x_b| / w),
/// W(q) = (1 + 3 q)(1 - q)^3 for q < 1: their sum is kept.
Eigen::Matrix3Xd smoothed(continuum::SurfaceTrace const& trace, Eigen::Matrix3Xd const& loads,
                          double width);

/// Largest von Mises stress of a tool under nodal loads of its pressed surface, where it is, how
/// much of the yield strength it uses, and the depth below which stresses do not depend on how
/// single contacts are spread: where loads smoothed over one and over two cells differ by less than
/// 5 % of the largest stress.
ToolSummary tool_stress(YieldingTool const& tool, Eigen::Matrix3Xd const& loads, double cell_size);

/// Writes displacement and stress under these loads as VTU.
void write_tool_stress(std::filesystem::path const& file, YieldingTool const& tool,
                       Eigen::Matrix3Xd const& loads);

} // namespace coupling
