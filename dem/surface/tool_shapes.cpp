#include "dem/surface/tool_shapes.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>

namespace dem {

namespace {

void expect_positive(std::string const& tool,
                     std::initializer_list<std::pair<char const*, double>> dimensions) {
  for (auto const& [name, value] : dimensions) {
    std::ostringstream message;
    message << tool << ": " << name << " = " << value
            << " m: must be a positive length. Correct it?";
    VALIDATE(value > 0.0 && std::isfinite(value), message.str());
  }
}

/// Adds n vertices on a circle about the z axis. @returns the row of the first
std::uint32_t add_circle(TriangleSurface& surface, std::uint32_t n, double radius, double z) {
  auto const first = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    double const angle = 2.0 * pi * k / n;
    surface.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return first;
}

/// Two triangles a facet between two circles of n vertices. Seen from outside, `lower` runs
/// anticlockwise along the bottom.
void add_band(TriangleSurface& surface, std::uint32_t n, std::uint32_t lower, std::uint32_t upper) {
  for (std::uint32_t k = 0; k < n; ++k) {
    auto const next = (k + 1) % n;
    surface.triangles.push_back({lower + k, lower + next, upper + next});
    surface.triangles.push_back({lower + k, upper + next, upper + k});
  }
}

enum class Looks { up, down };

void add_disc(TriangleSurface& surface, std::uint32_t n, std::uint32_t circle, Looks looks) {
  auto const centre = static_cast<std::uint32_t>(surface.vertices.size());
  surface.vertices.emplace_back(0.0, 0.0, surface.vertices[circle].z());
  for (std::uint32_t k = 0; k < n; ++k) {
    auto const here = circle + k, next = circle + (k + 1) % n;
    if (looks == Looks::up)
      surface.triangles.push_back({centre, here, next});
    else
      surface.triangles.push_back({centre, next, here});
  }
}

} // namespace

std::uint32_t n_facets(double diameter, double chordal_tolerance) {
  constexpr double fewest = 24.0, most = 1e5;
  expect_positive("tool", {{"diameter", diameter}, {"chordal tolerance", chordal_tolerance}});
  double const cosine = std::max(1.0 - 2.0 * chordal_tolerance / diameter, -1.0);
  double const n =
      std::ceil(pi / std::acos(cosine)); // infinite when the tolerance is lost in rounding
  return static_cast<std::uint32_t>(std::clamp(n, fewest, most));
}

TriangleSurface make_die(double bore_diameter, double height, double wall_thickness,
                         double chordal_tolerance) {
  expect_positive("die", {{"bore diameter", bore_diameter},
                          {"height", height},
                          {"wall thickness", wall_thickness},
                          {"chordal tolerance", chordal_tolerance}});
  auto const n = n_facets(bore_diameter, chordal_tolerance);
  double const inner = 0.5 * bore_diameter, outer = inner + wall_thickness;
  TriangleSurface die{.name = "die", .vertices = {}, .triangles = {}};
  auto const inner_low = add_circle(die, n, inner, 0.0);
  auto const inner_high = add_circle(die, n, inner, height);
  auto const outer_low = add_circle(die, n, outer, 0.0);
  auto const outer_high = add_circle(die, n, outer, height);
  add_band(die, n, inner_high, inner_low); // upside down: its normals look at the axis
  add_band(die, n, outer_high, inner_high);
  add_band(die, n, outer_low, outer_high);
  add_band(die, n, inner_low, outer_low);
  return die;
}

TriangleSurface make_punch(double diameter, double length, double chordal_tolerance,
                           PunchFace face) {
  expect_positive(
      "punch",
      {{"diameter", diameter}, {"length", length}, {"chordal tolerance", chordal_tolerance}});
  auto const n = n_facets(diameter, chordal_tolerance);
  bool const is_lower = face == PunchFace::up;
  TriangleSurface punch{
      .name = is_lower ? "lower_punch" : "upper_punch", .vertices = {}, .triangles = {}};
  auto const low = add_circle(punch, n, 0.5 * diameter, is_lower ? -length : 0.0);
  auto const high = add_circle(punch, n, 0.5 * diameter, is_lower ? 0.0 : length);
  add_band(punch, n, low, high);
  add_disc(punch, n, low, Looks::down);
  add_disc(punch, n, high, Looks::up);
  return punch;
}

} // namespace dem
