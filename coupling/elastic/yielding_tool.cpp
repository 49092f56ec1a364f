#include "coupling/elastic/yielding_tool.hpp"

#include "continuum/errors.hpp"
#include "coupling/elastic/session.hpp"
#include "coupling/elastic/smooth_rim.hpp"
#include "coupling/elastic/tool_meshes.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace coupling {
namespace {

constexpr std::uintmax_t most_cached = 500'000'000; // bytes

/// Where operators are kept between runs: $PRESSCHECK_CACHE, or the user's cache folder.
std::optional<std::filesystem::path> cache_folder() {
  if (char const* const own = std::getenv("PRESSCHECK_CACHE"))
    return own;
  if (char const* const cache = std::getenv("XDG_CACHE_HOME"))
    return std::filesystem::path(cache) / "presscheck";
  if (char const* const home = std::getenv("HOME"))
    return std::filesystem::path(home) / ".cache" / "presscheck";
  return std::nullopt;
}

/// Removes the oldest files of the folder until the rest takes no more than `most_cached`.
void prune(std::filesystem::path const& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::directory_entry> files;
  for (auto const& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error))
      files.push_back(entry);
  std::ranges::sort(files, std::ranges::greater(),
                    [&](auto const& file) { return file.last_write_time(error); });
  std::uintmax_t total = 0;
  for (auto const& file : files)
    if ((total += file.file_size(error)) > most_cached)
      fs::remove(file.path(), error);
}

continuum::InterfaceCompliance condensed(continuum::ElasticTool const& body,
                                         std::string const& surface) {
  auto const folder = cache_folder();
  std::error_code error;
  if (folder)
    std::filesystem::create_directories(*folder, error);
  if (!folder || error)
    return continuum::InterfaceCompliance::condense(body, surface);
  try {
    auto compliance = continuum::InterfaceCompliance::cached(body, surface, *folder);
    prune(*folder);
    return compliance;
  } catch (continuum::InvalidInput const&) {
    // A damaged file or a full disk costs seconds, not the run.
    return continuum::InterfaceCompliance::condense(body, surface);
  }
}

/// The patches whose triangles lie on the named surface of the trace.
std::vector<std::uint32_t> patches_on(std::string const& name, dem::SmoothSurface const& touched,
                                      continuum::SurfaceTrace const& boundary,
                                      continuum::TraceTriangles const& mesh) {
  std::vector<std::uint32_t> patches;
  for (std::uint32_t patch = 0; patch < touched.patches().size(); ++patch) {
    auto const triangle = touched.triangle_at(patch, touched.patches()[patch].origin);
    if (boundary.surfaces[boundary.faces[mesh.faces[triangle]].surface] == name)
      patches.push_back(patch);
  }
  return patches;
}

/// What grains touch of a tool, and which of its patches stand for the pressed surface.
struct Touched {
  dem::SmoothSurface surface;
  std::vector<std::uint32_t> patches;
};

Touched touched_trace(Case const& setup, std::string const& name, std::string const& pressed,
                      continuum::ToolMesh const& mesh, dem::Vec3 const& offset) {
  auto const boundary = mesh.boundary();
  auto const triangles = boundary.triangulate(setup.tooling.chordal_tolerance);
  dem::SmoothSurface surface(surface_of(triangles, offset));
  refuse_smooth_rim(fmt::format("{}: deformable tools: {}", setup.file.string(), name), pressed,
                    boundary, triangles);
  auto patches = patches_on(pressed, surface, boundary, triangles);
  return {.surface = std::move(surface), .patches = std::move(patches)};
}

Touched touched_stl(StlTool const& stl, std::string const& pressed, double z) {
  Touched touched{.surface = moved_along_axis(stl.surface, z), .patches = {}};
  for (std::uint32_t patch = 0; patch < stl.names.size(); ++patch)
    if (stl.names[patch] == pressed)
      touched.patches.push_back(patch);
  return touched;
}

/// The STL may be another tool's than the mesh behind it.
void check_gap(Case const& setup, ToolBody const& from, std::string const& name,
               std::string const& pressed, double gap) {
  double const allowed = setup.elastic.shapes.largest_gap;
  VALIDATE(!from.stl || gap <= allowed,
           fmt::format("{}: deformable tools: {}: the mesh and Tooling's STL are {:.3g} m apart on "
                       "'{}' (Largest gap = {:.3g} m; grains would touch another shape than the "
                       "one that yields). Are they the same tool, in the same unit?",
                       setup.file.string(), name, gap, pressed, allowed));
}

ElasticPair make_pair(Case const& setup, std::string name, std::string pressed,
                      ToolBody const& from, continuum::Supports const& supports, double z) {
  continuum::ToolMesh const& mesh = from.mesh;
  dem::Vec3 const offset(0.0, 0.0, z - from.height);
  Touched touched = from.stl ? touched_stl(*from.stl, pressed, z)
                             : touched_trace(setup, name, pressed, mesh, offset);
  continuum::ElasticTool body(mesh, from.materials, supports);
  auto surface =
      std::make_shared<ElasticSurface>(mesh.trace(pressed), offset, std::move(touched.patches));
  Eigen::Matrix3Xd const pressure_loads = surface->trace().pressure_loads(1.0);
  double const area = surface->trace().area();
  double const gap = largest_gap(touched.surface, *surface, offset);
  check_gap(setup, from, name, pressed, gap);
  auto compliance = condensed(body, pressed);
  auto tool = std::make_shared<YieldingTool>(YieldingTool{.name = std::move(name),
                                                          .pressed = std::move(pressed),
                                                          .body = std::move(body),
                                                          .compliance = std::move(compliance),
                                                          .surface = std::move(surface),
                                                          .offset = offset,
                                                          .pressure_loads = pressure_loads,
                                                          .area = area,
                                                          .gap = gap});
  tool->uniform_compliance = tool->retreat(tool->compliance.displacement(pressure_loads)) /
                             tool->pressing_force(pressure_loads);
  return {.touched = std::move(touched.surface), .body = tool};
}

continuum::Supports supports_of(std::string const& surface, ToolSupport support) {
  if (support == ToolSupport::rollers)
    return continuum::Supports::rollers(surface);
  auto supports = continuum::Supports::clamped(surface);
  if (support == ToolSupport::guided)
    supports.surfaces.push_back({"side", {true, true, false}});
  return supports;
}

} // namespace

double YieldingTool::retreat(Eigen::Matrix3Xd const& u) const {
  return (pressure_loads.array() * u.array()).sum() / area;
}

double YieldingTool::pressing_force(Eigen::Matrix3Xd const& forces) const {
  double sum = 0.0;
  for (Eigen::Index a = 0; a < forces.cols(); ++a) {
    double const weight = pressure_loads.col(a).norm();
    if (weight > 0.0)
      sum += pressure_loads.col(a).dot(forces.col(a)) / weight;
  }
  return sum;
}

std::vector<ElasticPair> make_yielding_tools(Case const& setup) {
  ensure_session();
  ElasticTools const& elastic = setup.elastic;
  auto const back = supports_of("back", elastic.punch_support);
  try {
    // Bodies first: what is wrong with a file is said before any is condensed.
    ToolBody const die = make_die_body(setup);
    ToolBody const upper = make_punch_body(setup, continuum::PunchPlace::upper);
    ToolBody const lower = make_punch_body(setup, continuum::PunchPlace::lower);
    std::vector<ElasticPair> tools;
    tools.push_back(
        make_pair(setup, "die", "bore", die, supports_of("bottom", elastic.die_support), 0.0));
    tools.push_back(make_pair(setup, "upper_punch", "face", upper, back, setup.powder.fill_height));
    tools.push_back(make_pair(setup, "lower_punch", "face", lower, back, 0.0));
    return tools;
  } catch (continuum::InvalidInput const& error) {
    throw dem::InvalidInput(
        fmt::format("{}: deformable tools: {}", setup.file.string(), error.what()));
  }
}

double largest_gap(dem::SmoothSurface const& touched, ElasticSurface const& surface,
                   dem::Vec3 const& offset) {
  auto const& trace = surface.trace();
  double const reach = 0.1 * std::sqrt(trace.area());
  double largest = 0.0;
  std::vector<dem::SurfacePoint> found;
  for (std::uint32_t face = 0; face < trace.faces.size(); ++face)
    for (double const xi : {0.113, 0.5, 0.887})
      for (double const eta : {0.113, 0.5, 0.887}) {
        found.clear();
        touched.find(trace.position(face, xi, eta) + offset, reach, found);
        double nearest = std::numeric_limits<double>::infinity();
        for (auto const& at : found)
          nearest = std::min(nearest, std::abs(at.distance));
        largest = std::max(largest, nearest);
      }
  return largest;
}

} // namespace coupling
