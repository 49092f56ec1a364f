#pragma once

#include "dem/surface/surface_report.hpp"
#include "dem/surface/triangle_surface.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace dem {

/// A tool's surface as read from a file, and what it measures.
struct StlTool {
  TriangleSurface surface; ///< [m], vertices welded
  SurfaceReport report;
};

/// Corners nearer than this fraction of the box's diagonal are one vertex.
inline constexpr double weld_distance = 1e-7;

/// Reads a tool from an STL file, ASCII or binary. The size decides which (84 + 50 n bytes with n
/// at byte 80 is binary), not the word "solid", with which binary files may start as well. Stated
/// facet normals are ignored: the order of the corners says where the outside is. Several solids in
/// one ASCII file make one surface.
/// @param scale  [m] per unit of the file ("STL scale"), 0.001 for millimetres
/// @throws InvalidInput, with file and line or triangle (counted from 1), if the file is missing,
/// empty, truncated,
///   has a count that does not match its size, a coordinate that is not finite, a degenerate
///   triangle, an edge of three triangles, neighbours that disagree about the outside, a closed
///   surface that is inside out, or a largest extent outside 10 um .. 1 m. Open edges are allowed;
///   the report counts them.
StlTool read_stl(std::filesystem::path const& file, double scale = 1.0);

/// The same from bytes in memory; `name` stands for the file in messages and names the surface.
StlTool read_stl(std::span<std::byte const> bytes, std::string const& name, double scale = 1.0);

enum class StlFormat : std::uint8_t { ascii, binary };

/// Writes a surface, in units of `scale` [m], under a temporary name that is renamed at the end.
/// ASCII keeps every digit; binary STL holds single precision.
/// @throws InvalidInput if the file cannot be written
void write_stl(std::filesystem::path const& file, TriangleSurface const& surface,
               StlFormat format = StlFormat::ascii, double scale = 1.0);

} // namespace dem
