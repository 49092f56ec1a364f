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
  if (!shapes.die_file.empty()) {
    auto mesh = read_mesh(setup, "Die mesh file", shapes.die_file, {"bore", "bottom"});
    check_bore(setup, mesh);
    auto materials = die_materials(setup, mesh);
    return {.mesh = std::move(mesh), .materials = std::move(materials)};
  }
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
  auto const with_material = [&](continuum::ToolMesh mesh) {
    std::size_t const n = mesh.n_regions();
    return ToolBody{.mesh = std::move(mesh), .materials = {n, setup.elastic.material}};
  };
  if (!file.empty()) {
    auto mesh = read_mesh(setup, is_upper ? "Upper punch mesh file" : "Lower punch mesh file", file,
                          {"face", "back"});
    check_punch(setup, mesh, file.string(), place);
    return with_material(std::move(mesh));
  }
  continuum::PunchShape const shape{.radius = 0.5 * setup.tooling.bore_diameter,
                                    .length = setup.tooling.punch_length,
                                    .place = place,
                                    .face = shapes.punch_face};
  return with_material(
      continuum::ToolMesh::punch(shape, continuum::cells_of_size(shape, setup.elastic.cell_size)));
}

} // namespace coupling
