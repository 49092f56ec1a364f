#include "coupling/press_tools.hpp"

#include "dem/expect.hpp"
#include "dem/surface/stl.hpp"
#include "dem/surface/tool_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// Analytic walls reach this many bores and heights beyond the powder.
constexpr double beyond = 2.0;

// A bore that differs from the case's by more is another die, or another unit.
constexpr double size_tolerance = 0.01;

dem::TriangleSurface shifted(dem::TriangleSurface surface, double z) {
  for (dem::Vec3& vertex : surface.vertices)
    vertex.z() += z;
  return surface;
}

/// The die's bore must be the case's, about the press axis, and reach down to the lower punch.
void check_die(dem::SmoothSurface const& die, dem::SurfaceReport const& report, Case const& setup) {
  Tooling const& tooling = setup.tooling;
  std::string const file = tooling.die_file.string();
  double const radius = 0.5 * tooling.bore_diameter;
  VALIDATE(report.low.z() <= size_tolerance * radius && report.high.z() > 0.0,
           fmt::format("{}: the die stands from z = {:.6g} m to {:.6g} m (the lower punch's face "
                       "is z = 0). Move the "
                       "drawing's origin?",
                       file, report.low.z(), report.high.z()));
  double found = 0.0;
  for (dem::SmoothPatch const& patch : die.patches()) {
    if (patch.kind != dem::PatchKind::cylinder || patch.side > 0.0)
      continue;
    bool const is_on_axis =
        std::hypot(patch.origin.x(), patch.origin.y()) < size_tolerance * radius;
    if (std::abs(patch.radius - radius) < size_tolerance * radius && is_on_axis)
      return;
    found = patch.radius;
  }
  VALIDATE(found == 0.0, fmt::format("{}: its bore of {:.6g} m diameter is not 'Tooling/Bore "
                                     "diameter' = {:.6g} m about the z axis. Is "
                                     "'STL scale' = {:.6g} m right?",
                                     file, 2.0 * found, tooling.bore_diameter, tooling.stl_scale));
}

dem::SmoothSurface read_die(Case const& setup) {
  auto read = dem::read_stl(setup.tooling.die_file, setup.tooling.stl_scale);
  dem::SmoothSurface die(std::move(read.surface));
  check_die(die, read.report, setup);
  return die;
}

dem::TriangleSurface read_punch(std::filesystem::path const& file, Case const& setup) {
  auto const read = dem::read_stl(file, setup.tooling.stl_scale);
  dem::Vec3 const size = read.report.high - read.report.low;
  dem::Vec3 const middle = 0.5 * (read.report.high + read.report.low);
  double const bore = setup.tooling.bore_diameter;
  double const width = std::max(size.x(), size.y());
  VALIDATE(width > 0.5 * bore && width < 2.0 * bore &&
               std::hypot(middle.x(), middle.y()) < size_tolerance * bore,
           fmt::format("{}: a punch {:.6g} m wide about ({:.3g}, {:.3g}) m does not fit a bore of "
                       "{:.6g} m about the z "
                       "axis. Is 'STL scale' = {:.6g} m right?",
                       file.string(), width, middle.x(), middle.y(), bore,
                       setup.tooling.stl_scale));
  return read.surface;
}

double extreme_z(dem::TriangleSurface const& surface, bool highest) {
  double z = surface.vertices.front().z();
  for (dem::Vec3 const& vertex : surface.vertices)
    z = highest ? std::max(z, vertex.z()) : std::min(z, vertex.z());
  return z;
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
    return read_die(setup);
  return dem::SmoothSurface(
      dem::make_die(t.bore_diameter, t.die_height, t.wall_thickness, t.chordal_tolerance));
}

/// A punch with its face at z = 0.
dem::TriangleSurface make_punch_surface(Case const& setup, std::filesystem::path const& file,
                                        dem::PunchFace face) {
  Tooling const& t = setup.tooling;
  if (t.walls == WallKind::analytic)
    return dem::make_punch((1.0 + 2.0 * beyond) * t.bore_diameter, t.bore_diameter,
                           t.chordal_tolerance, face);
  if (file.empty())
    return dem::make_punch(t.bore_diameter, t.punch_length, t.chordal_tolerance, face);
  auto punch = read_punch(file, setup);
  double const z = extreme_z(punch, face == dem::PunchFace::up);
  return shifted(std::move(punch), -z);
}

} // namespace

PunchFaces starting_faces(Case const& setup) {
  return {.lower = 0.0, .upper = setup.powder.fill_height};
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
  auto upper = make_punch_surface(setup, setup.tooling.upper_punch_file, dem::PunchFace::down);
  auto lower = make_punch_surface(setup, setup.tooling.lower_punch_file, dem::PunchFace::up);
  std::vector<dem::Tool> tools;
  tools.push_back(named("die", make_die_surface(setup)));
  tools.push_back(named("upper_punch",
                        dem::SmoothSurface(shifted(std::move(upper), setup.powder.fill_height))));
  tools.push_back(named("lower_punch", dem::SmoothSurface(std::move(lower))));
  return tools;
}

} // namespace coupling
