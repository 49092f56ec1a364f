#pragma once

#include "coupling/case_file.hpp"
#include "coupling/elastic/tool_meshes.hpp"
#include "dem/surface/stl.hpp"
#include "dem/surface/tool_shapes.hpp"
#include "tests/support/msh_writer.hpp"
#include "tests/support/scratch_folder.hpp"

#include <string>
#include <vector>

/// Cases with deformable tools, and mesh files that fit the seed's press: bore 22.05 mm, die and
/// fill height 20 mm, wall and punch length 10 mm.
namespace elastic_case {

using Overrides = std::vector<std::string>;

inline coupling::Case read(Overrides overrides, std::string const& cell_size = "4 mm") {
  overrides.push_back("Deformable tools/Cell size=" + cell_size);
  return coupling::parse_case("set Mode = one_way\n", "case.prm", overrides);
}

inline constexpr double bore = 11.025e-3; // [m], radius

// 32 straight cells around leave the bore by 1 - cos(pi/32) = 0.5 % of its radius
inline continuum::HexMesh die() {
  return continuum::mesh_die({.bore_radius = bore, .outer_radius = 21e-3, .height = 20e-3},
                             {.around = 32, .through_wall = 2, .along = 2});
}
inline continuum::HexMesh ringed_die() {
  return continuum::mesh_die(
      {.bore_radius = bore, .outer_radius = 21e-3, .height = 20e-3, .ring_radius = 31e-3},
      {.around = 32, .through_wall = 2, .through_ring = 2, .along = 2});
}
inline continuum::HexMesh punch(continuum::PunchPlace place, double radius = bore) {
  return continuum::mesh_punch({.radius = radius, .length = 15e-3, .place = place},
                               {.around = 32, .rings = 1, .along = 2});
}

inline continuum::HexMesh shifted(continuum::HexMesh mesh, Eigen::Vector3d const& by) {
  for (auto& vertex : mesh.vertices)
    vertex += by;
  return mesh;
}

inline dem::TriangleSurface die_surface(double radius) {
  return dem::make_die(2.0 * radius, 20e-3, 10e-3, 1e-5);
}

/// A case whose mesh file, in mm, is this one.
class FileCase {
public:
  FileCase(std::string const& entry, continuum::HexMesh const& mesh, double per_metre = 1e3) {
    support::save_msh(mesh, path(), per_metre);
    overrides_ = {"Deformable tools/" + entry + "=" + path().string(),
                  "Deformable tools/Mesh scale=1 mm", "Deformable tools/Die support=clamped"};
  }
  std::filesystem::path path() const { return folder_ / "tool.msh"; }
  Overrides with(Overrides const& more = {}) const {
    Overrides all = overrides_;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

private:
  support::ScratchFolder folder_;
  Overrides overrides_;
};

} // namespace elastic_case
