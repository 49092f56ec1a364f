#include "coupling/stl_tools.hpp"

#include "dem/expect.hpp"
#include "dem/surface/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// A bore that differs from the case's by more is another die, or another unit.
constexpr double size_tolerance = 0.01;

bool is_bore(dem::SmoothPatch const& patch, double radius) {
  return patch.kind == dem::PatchKind::cylinder && patch.side < 0.0 &&
         std::abs(patch.radius - radius) < size_tolerance * radius &&
         std::hypot(patch.origin.x(), patch.origin.y()) < size_tolerance * radius;
}

bool is_level(dem::SmoothPatch const& patch) {
  return patch.kind == dem::PatchKind::plane && std::abs(patch.direction.z()) > 1.0 - 1e-6;
}

/// Number of the level plane at the end of the tool that its normal points to.
std::size_t end_plane(dem::SmoothSurface const& surface, double sign) {
  std::size_t found = surface.patches().size();
  for (std::size_t p = 0; p < surface.patches().size(); ++p) {
    dem::SmoothPatch const& patch = surface.patches()[p];
    bool const is_further = found == surface.patches().size() ||
                            sign * patch.origin.z() > sign * surface.patches()[found].origin.z();
    if (is_level(patch) && sign * patch.direction.z() > 0.0 && is_further)
      found = p;
  }
  return found;
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
    if (is_bore(patch, radius))
      return;
    if (patch.kind == dem::PatchKind::cylinder && patch.side < 0.0)
      found = patch.radius;
  }
  VALIDATE(found == 0.0, fmt::format("{}: its bore of {:.6g} m diameter is not 'Tooling/Bore "
                                     "diameter' = {:.6g} m about the z axis. Is "
                                     "'STL scale' = {:.6g} m right?",
                                     file, 2.0 * found, tooling.bore_diameter, tooling.stl_scale));
}

void check_punch(dem::SurfaceReport const& report, std::string const& file, Case const& setup) {
  dem::Vec3 const size = report.high - report.low;
  dem::Vec3 const middle = 0.5 * (report.high + report.low);
  double const bore = setup.tooling.bore_diameter;
  double const width = std::max(size.x(), size.y());
  VALIDATE(width > 0.5 * bore && width < 2.0 * bore &&
               std::hypot(middle.x(), middle.y()) < size_tolerance * bore,
           fmt::format("{}: a punch {:.6g} m wide about ({:.3g}, {:.3g}) m does not fit a bore of "
                       "{:.6g} m about the z "
                       "axis. Is 'STL scale' = {:.6g} m right?",
                       file, width, middle.x(), middle.y(), bore, setup.tooling.stl_scale));
}

} // namespace

std::vector<continuum::NamedShape> StlTool::shapes() const {
  std::vector<continuum::NamedShape> shapes;
  for (std::size_t p = 0; p < names.size(); ++p) {
    dem::SmoothPatch const& patch = surface.patches()[p];
    dem::Vec3 const origin = patch.origin + height * dem::Vec3::UnitZ();
    if (patch.kind == dem::PatchKind::plane)
      shapes.push_back({names[p], continuum::PlaneShape{origin, patch.direction}});
    else if (patch.kind == dem::PatchKind::cylinder)
      shapes.push_back({names[p], continuum::CylinderShape{origin, patch.direction, patch.radius}});
  }
  return shapes;
}

StlTool read_stl_die(Case const& setup) {
  auto read = dem::read_stl(setup.tooling.die_file, setup.tooling.stl_scale);
  dem::SmoothSurface die(std::move(read.surface));
  check_die(die, read.report, setup);
  std::vector<std::string> names;
  for (dem::SmoothPatch const& patch : die.patches())
    names.push_back(is_bore(patch, 0.5 * setup.tooling.bore_diameter)
                        ? "bore"
                        : fmt::format("patch {}", names.size() + 1));
  if (std::size_t const bottom = end_plane(die, -1.0); bottom < names.size())
    names[bottom] = "bottom";
  return {.surface = std::move(die), .names = std::move(names), .height = 0.0};
}

StlTool read_stl_punch(Case const& setup, continuum::PunchPlace place) {
  bool const is_upper = place == continuum::PunchPlace::upper;
  auto const& file = is_upper ? setup.tooling.upper_punch_file : setup.tooling.lower_punch_file;
  auto read = dem::read_stl(file, setup.tooling.stl_scale);
  check_punch(read.report, file.string(), setup);
  double const height = is_upper ? read.report.low.z() : read.report.high.z();
  for (dem::Vec3& vertex : read.surface.vertices)
    vertex.z() -= height;
  dem::SmoothSurface punch(std::move(read.surface));
  std::vector<std::string> names(punch.patches().size(), "face");
  if (std::size_t const back = end_plane(punch, is_upper ? 1.0 : -1.0); back < names.size())
    names[back] = "back";
  double widest = 0.0;
  std::size_t side = names.size();
  for (std::size_t p = 0; p < names.size(); ++p)
    if (dem::SmoothPatch const& patch = punch.patches()[p];
        patch.kind == dem::PatchKind::cylinder && patch.side > 0.0 && patch.radius > widest)
      widest = patch.radius, side = p;
  if (side < names.size())
    names[side] = "side";
  return {.surface = std::move(punch), .names = std::move(names), .height = height};
}

dem::SmoothSurface moved_along_axis(dem::SmoothSurface const& surface, double z) {
  dem::TriangleSurface triangles = surface.triangles();
  for (dem::Vec3& vertex : triangles.vertices)
    vertex.z() += z;
  return dem::SmoothSurface(std::move(triangles));
}

} // namespace coupling
