// clang-format off
// fuzz-build: dem/surface/box_tree.cpp dem/surface/closest_point.cpp dem/surface/curve_sides.cpp
// fuzz-build: dem/surface/fit_shape.cpp dem/surface/rim_contact.cpp dem/surface/smooth_patches.cpp
// fuzz-build: dem/surface/smooth_surface.cpp dem/surface/stl.cpp dem/surface/stl_facets.cpp
// fuzz-build: dem/surface/surface_edges.cpp dem/surface/surface_report.cpp
// fuzz-build: dem/surface/surface_search.cpp dem/surface/weld.cpp
// clang-format on
#include "dem/expect.hpp"
#include "dem/surface/smooth_surface.hpp"
#include "dem/surface/stl.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

/// Any bytes are either refused with InvalidInput, in one line, or make a tool that answers
/// questions.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  try {
    auto const tool = dem::read_stl(std::as_bytes(std::span(data, size)), "fuzz.stl", 1e-3);
    dem::SmoothSurface const surface(tool.surface);
    std::vector<dem::SurfacePoint> found;
    double const reach = 0.1 * tool.report.largest_extent();
    surface.find(tool.surface.vertices.front() + dem::Vec3::Constant(0.3 * reach), reach, found);
    for (auto const& contact : found)
      if (!std::isfinite(contact.distance) || !(std::abs(contact.normal.norm() - 1.0) < 1e-6))
        std::abort();
  } catch (dem::InvalidInput const& error) {
    std::string_view const message = error.what();
    if (message.empty() || message.find('\n') != std::string_view::npos)
      std::abort();
  }
  return 0;
}
