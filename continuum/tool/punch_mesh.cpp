#include "continuum/tool/disc_mesh.hpp"
#include "continuum/tool/hex_mesh.hpp"
#include "continuum/tool/punch_profile.hpp"
#include "continuum/tool/shape_checks.hpp"

namespace continuum {

namespace {
Disc disc_of(PunchShape const& shape, PunchProfile const& profile, PunchCells const& cells) {
  validate_count("around", cells.around, 8);
  validate_count("in rings", cells.rings, 1);
  validate_count("along", cells.along, 1);
  validate_growth(cells.growth);
  std::vector<double> circles = {shape.radius};
  if (profile.rim_width() > 0.0) {
    validate_count("in rings of the rim", cells.rim, 1);
    circles = graded(shape.radius - profile.rim_width(), shape.radius, cells.rim, 1.0);
  }
  return mesh_disc(circles, cells.around / 4, cells.rings);
}

// From the flat disc to the body: what the face stands back at a radius fades along the length.
class Body {
public:
  Body(PunchShape const& shape, PunchProfile const& profile, PunchCells const& cells)
      : profile_(profile), into_body_(shape.place == PunchPlace::lower ? -1.0 : 1.0),
        length_(shape.length), distances_(graded(0.0, shape.length, cells.along, cells.growth)) {
    if (is_lower())
      std::ranges::reverse(distances_); // upwards, so that cells are right-handed
  }
  bool is_lower() const { return into_body_ < 0.0; }

  /// @param layer  in half cells, counted upwards
  Eigen::Vector3d place(Eigen::Vector2d const& point, unsigned layer) const {
    double const from_face = 0.5 * (distances_[layer / 2] + distances_[(layer + 1) / 2]);
    double const bent = profile_.depth(point.norm()) * (1.0 - from_face / length_);
    return {point.x(), point.y(), into_body_ * (from_face + bent)};
  }

private:
  PunchProfile const& profile_;
  double into_body_, length_;
  std::vector<double> distances_; // of the layers from z = 0
};

void add_boundary(HexMesh& mesh, Disc const& disc, unsigned n_z, bool is_lower) {
  unsigned const n_disc = disc.points.size();
  unsigned const face = (is_lower ? n_z : 0) * n_disc, back = (is_lower ? 0 : n_z) * n_disc;
  for (auto const& [a, b, c, d] : disc.quads) {
    mesh.boundary.push_back({{face + a, face + b, face + c, face + d}, 0});
    mesh.boundary.push_back({{back + a, back + b, back + c, back + d}, 2});
  }
  for (unsigned z = 0; z < n_z; ++z)
    for (std::size_t t = 0; t < disc.rim.size(); ++t) {
      unsigned const a = z * n_disc + disc.rim[t],
                     b = z * n_disc + disc.rim[(t + 1) % disc.rim.size()];
      mesh.boundary.push_back({{a, b, a + n_disc, b + n_disc}, 1});
    }
  // The rim starts at -45 degrees, so an eighth of it further is the x axis.
  auto const rim_at = [&](std::size_t eighths) {
    return back + disc.rim[eighths * disc.rim.size() / 8];
  };
  mesh.pins = {{rim_at(1), 1}, {rim_at(3), 0}, {rim_at(5), 1}};
}
} // namespace

HexMesh mesh_punch(PunchShape const& shape, PunchCells const& cells) {
  PunchProfile const profile(shape);
  Disc const disc = disc_of(shape, profile, cells);
  Body const body(shape, profile, cells);
  unsigned const n_z = cells.along, n_disc = disc.points.size();

  HexMesh mesh{.surfaces = {"face", "side", "back"}};
  for (unsigned z = 0; z <= n_z; ++z)
    for (Eigen::Vector2d const& point : disc.points)
      mesh.vertices.push_back(body.place(point, 2 * z));
  for (unsigned z = 0; z < n_z; ++z)
    for (std::size_t q = 0; q < disc.quads.size(); ++q) {
      auto const& [a, b, c, d] = disc.quads[q];
      unsigned const low = z * n_disc, high = low + n_disc;
      mesh.cells.push_back(
          {low + a, low + b, low + c, low + d, high + a, high + b, high + c, high + d});
      mesh.nodes.push_back(cell_nodes([&](unsigned i, unsigned j, unsigned k) {
        return body.place(disc.nodes[q][3 * j + i], 2 * z + k);
      }));
    }
  mesh.regions.assign(mesh.cells.size(), 0);
  add_boundary(mesh, disc, n_z, body.is_lower());
  return mesh;
}

} // namespace continuum
