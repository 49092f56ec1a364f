#pragma once

#include "continuum/tool/elastic_tool.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>

namespace crosscode {

/// The 20 nodes of a cell that the peer's element C3D20 has, in its order: of 27 those on edges.
/// Source: CalculiX CrunchiX user's manual 2.20, section 6.2.4.
std::array<std::uint32_t, 20> serendipity_nodes(continuum::ToolMesh const& mesh, std::size_t cell);

/// Nodes of the mesh that the peer has, too.
std::vector<bool> is_shared(continuum::ToolMesh const& mesh);

/// Writes an input deck: mesh, materials, supports and nodal forces [N] (3 x n_nodes) of the tool.
/// Node a is number a + 1. Asks for U of all nodes and for S and the place of all integration
/// points.
/// @throws std::runtime_error if a force acts on a node that the peer does not have
void write_deck(std::filesystem::path const& file, continuum::ElasticTool const& tool,
                Eigen::Matrix3Xd const& loads);

} // namespace crosscode
