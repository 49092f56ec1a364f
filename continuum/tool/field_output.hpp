#pragma once

#include "continuum/tool/elastic_tool.hpp"

#include <Eigen/Core>

#include <filesystem>

namespace continuum {

/// Writes the tool as VTU (Lagrange hexahedra of second order, ParaView 5.5 or later): point data
/// `displacement` [m], `stress` [Pa] (Cauchy, 3 x 3), `von_mises` [Pa], `principal_stresses` [Pa]
/// (largest first). Single precision: for the eye, not for comparison of digits. Stress is that of
/// each cell, not smoothed, so that jumps between materials and errors of the mesh stay visible.
/// @throws InvalidInput if the file cannot be written
void write_vtu(std::filesystem::path const& file, ElasticTool const& tool,
               Eigen::Matrix3Xd const& displacement);

} // namespace continuum
