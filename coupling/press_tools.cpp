#include "coupling/press_tools.hpp"

#include "coupling/elastic/tool_meshes.hpp"
#include "dem/surface/tool_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// Analytic walls reach this many bores and heights beyond the powder.
constexpr double beyond = 2.0;

dem::TriangleSurface shifted(dem::TriangleSurface surface, double z) {
  for (dem::Vec3& vertex : surface.vertices)
    vertex.z() += z;
  return surface;
}

/// The trace of a body's mesh, in the tool's own frame.
dem::TriangleSurface trace_of(ToolBody const& body, Tooling const& tooling) {
  return surface_of(body.mesh.boundary().triangulate(tooling.chordal_tolerance),
                    {0.0, 0.0, -body.height});
}

dem::SmoothSurface make_die_surface(Case const& setup) {
  Tooling const& t = setup.tooling;
  if (t.walls == WallKind::analytic) {
    double const height = std::max(t.die_height, setup.powder.fill_height);
    return dem::SmoothSurface(shifted(dem::make_die(t.bore_diameter, (1.0 + 2.0 * beyond) * height,
                                                    t.bore_diameter, t.chordal_tolerance),
                                      -beyond * height));
  }
  if (!t.die_file.empty())
    return read_stl_die(setup).surface;
  if (!setup.elastic.shapes.die_file.empty())
    return dem::SmoothSurface(trace_of(make_die_body(setup), t));
  return dem::SmoothSurface(
      dem::make_die(t.bore_diameter, t.die_height, t.wall_thickness, t.chordal_tolerance));
}

/// A punch with its face at z = 0.
dem::SmoothSurface make_punch_surface(Case const& setup, continuum::PunchPlace place) {
  Tooling const& t = setup.tooling;
  ElasticToolShapes const& shapes = setup.elastic.shapes;
  bool const is_upper = place == continuum::PunchPlace::upper;
  auto const face = is_upper ? dem::PunchFace::down : dem::PunchFace::up;
  if (t.walls == WallKind::analytic)
    return dem::SmoothSurface(dem::make_punch((1.0 + 2.0 * beyond) * t.bore_diameter,
                                              t.bore_diameter, t.chordal_tolerance, face));
  if (!(is_upper ? t.upper_punch_file : t.lower_punch_file).empty())
    return read_stl_punch(setup, place).surface;
  bool const is_plain = std::holds_alternative<continuum::FlatFace>(shapes.punch_face) &&
                        (is_upper ? shapes.upper_punch_file : shapes.lower_punch_file).empty();
  if (!is_plain)
    return dem::SmoothSurface(trace_of(make_punch_body(setup, place), t));
  return dem::SmoothSurface(
      dem::make_punch(t.bore_diameter, t.punch_length, t.chordal_tolerance, face));
}

/// Sheared along the axis, so that the face leans and the side stays upright in the bore.
dem::SmoothSurface tilted(dem::SmoothSurface surface, double slope) {
  if (slope == 0.0)
    return surface;
  dem::TriangleSurface triangles = surface.triangles();
  for (dem::Vec3& vertex : triangles.vertices)
    vertex.z() += slope * vertex.x();
  return dem::SmoothSurface(std::move(triangles));
}

} // namespace

PunchFaces starting_faces(Case const& setup) {
  return {.lower = 0.0, .upper = setup.powder.fill_height, .drop = 0.5 * setup.tooling.punch_tilt};
}

double tool_share(Case const& setup) {
  auto const compliance = [](dem::Material const& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus;
  };
  double const tool = compliance(setup.tooling.material);
  double share = 0.0;
  for (Component const& component : setup.powder.components)
    share = std::max(share, tool / (tool + compliance(component.material)));
  return share;
}

std::vector<dem::Tool> make_tools(Case const& setup, std::uint8_t material) {
  auto const named = [&](std::string name, dem::SmoothSurface surface) {
    return dem::Tool{.name = std::move(name), .surface = std::move(surface), .material = material};
  };
  std::vector<dem::Tool> tools;
  tools.push_back(named("die", make_die_surface(setup)));
  auto upper =
      tilted(make_punch_surface(setup, continuum::PunchPlace::upper), setup.tooling.punch_slope());
  tools.push_back(named("upper_punch", moved_along_axis(upper, setup.powder.fill_height)));
  tools.push_back(named("lower_punch", make_punch_surface(setup, continuum::PunchPlace::lower)));
  return tools;
}

} // namespace coupling
