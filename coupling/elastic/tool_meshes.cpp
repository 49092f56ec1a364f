#include "coupling/elastic/tool_meshes.hpp"

#include "continuum/errors.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

// A bore or punch that differs from the case's by more is another tool, or another unit.
constexpr double size_tolerance = 0.01;
// [m] per bore radius: a flat part that stands elsewhere by more shifts every gap of the press.
constexpr double height_tolerance = 1e-4;

continuum::ToolMesh read_mesh(Case const& setup, std::string const& entry,
                              std::filesystem::path const& file,
                              std::vector<std::string> surfaces) {
  try {
    return continuum::ToolMesh::from_msh(file, {.length_unit = setup.elastic.shapes.mesh_scale,
                                                .required_surfaces = std::move(surfaces)});
  } catch (continuum::InvalidInput const& problem) {
    throw dem::InvalidInput(
        fmt::format("{}: Deformable tools/{}: {}", setup.file.string(), entry, problem.what()));
  }
}

struct Span {
  double low, high;
};

Span heights(Eigen::Matrix3Xd const& positions) {
  return {positions.row(2).minCoeff(), positions.row(2).maxCoeff()};
}

Span radii(Eigen::Matrix3Xd const& positions) {
  Eigen::RowVectorXd const r = positions.topRows<2>().colwise().norm();
  return {r.minCoeff(), r.maxCoeff()};
}

void check_bore(Case const& setup, continuum::ToolMesh const& mesh) {
  std::string const file = setup.elastic.shapes.die_file.string();
  double const radius = 0.5 * setup.tooling.bore_diameter;
  auto const bore = mesh.trace("bore").positions;
  auto const [r_low, r_high] = radii(bore);
  VALIDATE(r_low > (1.0 - size_tolerance) * radius && r_high < (1.0 + size_tolerance) * radius,
           fmt::format("{}: its surface 'bore' lies {:.6g} to {:.6g} m from the z axis "
                       "(Tooling/Bore diameter = {:.6g} m about that axis is what the punches and "
                       "the powder fit). Is Mesh scale = {:.6g} m right?",
                       file, r_low, r_high, 2.0 * radius, setup.elastic.shapes.mesh_scale));
  auto const [low, high] = heights(bore);
  double const hair = height_tolerance * radius, fill = setup.powder.fill_height;
  VALIDATE(low <= hair && high >= fill - hair,
           fmt::format("{}: its bore reaches from z = {:.6g} m to {:.6g} m (the powder stands from "
                       "0 to Powder/Fill height = {:.6g} m). Move the drawing's origin?",
                       file, low, high, fill));
}

void check_punch(Case const& setup, continuum::ToolMesh const& mesh, std::string const& file,
                 continuum::PunchPlace place) {
  double const radius = 0.5 * setup.tooling.bore_diameter;
  auto const face = mesh.trace("face").positions;
  double const reach = radii(face).high;
  VALIDATE(reach < (1.0 + size_tolerance) * radius && reach > (1.0 - size_tolerance) * radius,
           fmt::format("{}: its surface 'face' reaches {:.6g} m from the z axis (a punch {} the "
                       "die of Tooling/Bore diameter = {:.6g} m). Is Mesh scale = {:.6g} m right?",
                       file, reach,
                       reach > radius ? "so wide overlaps" : "so narrow leaves a gap to",
                       2.0 * radius, setup.elastic.shapes.mesh_scale));
  auto const [low, high] = heights(face);
  double const hair = height_tolerance * radius;
  VALIDATE(std::min(std::abs(low), std::abs(high)) <= hair,
           fmt::format("{}: its surface 'face' stands from z = {:.6g} m to {:.6g} m (its flat part "
                       "is at z = 0 in a punch's own frame). Move the drawing's origin?",
                       file, low, high));
  bool const is_upper = place == continuum::PunchPlace::upper;
  auto const [back_low, back_high] = heights(mesh.trace("back").positions);
  VALIDATE(is_upper ? back_low > high : back_high < low,
           fmt::format("{}: its surface 'back' stands from z = {:.6g} m to {:.6g} m (the body of "
                       "the {} punch is {} its face). Turn the drawing over?",
                       file, back_low, back_high, is_upper ? "upper" : "lower",
                       is_upper ? "above" : "below"));
}

/// A body inside the STL; what is on none of its planes and cylinders is `other`.
continuum::ToolMesh mesh_of(Case const& setup, std::string const& entry,
                            std::filesystem::path const& file, StlTool const& tool,
                            std::string const& other, std::string const& held) {
  try {
    auto made =
        continuum::ToolMesh::from_stl(file, {.cell_size = setup.elastic.cell_size,
                                             .gap_tolerance = setup.elastic.shapes.largest_gap,
                                             .length_unit = setup.tooling.stl_scale,
                                             .feature_angle = dem::default_smooth_angle,
                                             .surfaces = tool.shapes(),
                                             .other_surface = other});
    VALIDATE(std::ranges::count(made.mesh.surfaces(), held) == 1,
             fmt::format("{}: no plane square to the z axis at the tool's end (its '{}', by which "
                         "it is held). Bring a mesh file with named surfaces instead?",
                         file.string(), held));
    return std::move(made.mesh);
  } catch (continuum::InvalidInput const& problem) {
    throw dem::InvalidInput(
        fmt::format("{}: Tooling/{}: {}", setup.file.string(), entry, problem.what()));
  }
}

std::vector<continuum::ElasticMaterial> die_materials(Case const& setup,
                                                      continuum::ToolMesh const& mesh) {
  ElasticTools const& elastic = setup.elastic;
  if (!elastic.ring)
    return {mesh.n_regions(), elastic.material};
  VALIDATE(mesh.n_regions() == 2,
           fmt::format("{}: it has {} regions (a ring's material is for the second of two physical "
                       "volumes). Leave out 'Ring Young's modulus' and 'Ring Poisson's ratio'?",
                       elastic.shapes.die_file.string(), mesh.n_regions()));
  return {elastic.material, *elastic.ring};
}

} // namespace

ToolBody make_die_body(Case const& setup) {
  Tooling const& t = setup.tooling;
  ElasticToolShapes const& shapes = setup.elastic.shapes;
  std::optional<StlTool> stl;
  if (!t.die_file.empty())
    stl = read_stl_die(setup);
  if (!shapes.die_file.empty()) {
    auto mesh = read_mesh(setup, "Die mesh file", shapes.die_file, {"bore", "bottom"});
    check_bore(setup, mesh);
    auto materials = die_materials(setup, mesh);
    return {.mesh = std::move(mesh), .materials = std::move(materials), .stl = std::move(stl)};
  }
  if (stl)
    return {.mesh = mesh_of(setup, "Die file", t.die_file, *stl, "rest", "bottom"),
            .materials = {setup.elastic.material},
            .stl = std::move(stl)};
  double const radius = 0.5 * t.bore_diameter;
  continuum::DieShape shape{
      .bore_radius = radius, .outer_radius = radius + t.wall_thickness, .height = t.die_height};
  if (shapes.ring_thickness > 0.0)
    shape.ring_radius = shape.outer_radius + shapes.ring_thickness;
  auto mesh =
      continuum::ToolMesh::die(shape, continuum::cells_of_size(shape, setup.elastic.cell_size));
  auto materials = die_materials(setup, mesh);
  return {.mesh = std::move(mesh), .materials = std::move(materials)};
}

ToolBody make_punch_body(Case const& setup, continuum::PunchPlace place) {
  ElasticToolShapes const& shapes = setup.elastic.shapes;
  bool const is_upper = place == continuum::PunchPlace::upper;
  auto const& file = is_upper ? shapes.upper_punch_file : shapes.lower_punch_file;
  auto const& stl_file = is_upper ? setup.tooling.upper_punch_file : setup.tooling.lower_punch_file;
  std::optional<StlTool> stl;
  if (!stl_file.empty())
    stl = read_stl_punch(setup, place);
  auto const with_material = [&](continuum::ToolMesh mesh, double height = 0.0) {
    std::size_t const n = mesh.n_regions();
    return ToolBody{.mesh = std::move(mesh),
                    .materials = {n, setup.elastic.material},
                    .height = height,
                    .stl = std::move(stl)};
  };
  if (!file.empty()) {
    auto mesh = read_mesh(setup, is_upper ? "Upper punch mesh file" : "Lower punch mesh file", file,
                          {"face", "back"});
    check_punch(setup, mesh, file.string(), place);
    return with_material(std::move(mesh));
  }
  if (stl)
    return with_material(mesh_of(setup, is_upper ? "Upper punch file" : "Lower punch file",
                                 stl_file, *stl, "face", "back"),
                         stl->height);
  continuum::PunchShape const shape{.radius = 0.5 * setup.tooling.bore_diameter,
                                    .length = setup.tooling.punch_length,
                                    .place = place,
                                    .face = shapes.punch_face};
  return with_material(
      continuum::ToolMesh::punch(shape, continuum::cells_of_size(shape, setup.elastic.cell_size)));
}

dem::TriangleSurface surface_of(continuum::TraceTriangles const& mesh, dem::Vec3 const& offset) {
  dem::TriangleSurface surface;
  for (auto const& vertex : mesh.vertices)
    surface.vertices.push_back(vertex + offset);
  for (auto const& corners : mesh.triangles)
    surface.triangles.push_back(corners);
  return surface;
}

} // namespace coupling
