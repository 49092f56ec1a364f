#include "coupling/grain_fields.hpp"

#include <Eigen/Geometry>

namespace coupling {
namespace {

void add_contact(GrainFields& fields, dem::World const& world, std::uint32_t row,
                 dem::Contact const& contact, dem::Vec3 const& force) {
  double const volume = dem::sphere_volume(world.grains.radius[row]);
  fields.mean_overlap[row] += contact.overlap;
  fields.pressure[row] -= (contact.point - world.grains.position[row]).dot(force) / (3.0 * volume);
  ++fields.n_contacts[row];
}

double area(dem::TriangleSurface const& surface, std::array<std::uint32_t, 3> const& corners) {
  dem::Vec3 const& a = surface.vertices[corners[0]];
  return 0.5 * (surface.vertices[corners[1]] - a).cross(surface.vertices[corners[2]] - a).norm();
}

} // namespace

GrainFields grain_fields(dem::World const& world, dem::ContactStream const& contacts) {
  std::size_t const n = world.grains.size();
  GrainFields fields{.mean_overlap = std::vector<double>(n, 0.0),
                     .pressure = std::vector<double>(n, 0.0),
                     .n_contacts = std::vector<std::uint32_t>(n, 0)};
  contacts.for_each([&](dem::Contact const& contact) {
    add_contact(fields, world, contact.i, contact, contact.force);
    if (contact.j != dem::Contact::none)
      add_contact(fields, world, contact.j, contact, -contact.force);
  });
  for (std::size_t i = 0; i < n; ++i)
    if (fields.n_contacts[i] > 0)
      fields.mean_overlap[i] /= fields.n_contacts[i];
  return fields;
}

ToolFields tool_fields(dem::World const& world, dem::ContactStream const& contacts) {
  ToolFields fields;
  std::vector<std::size_t> first_triangle(world.tools.size());
  for (std::size_t t = 0; t < world.tools.size(); ++t) {
    dem::Tool const& tool = world.tools[t];
    first_triangle[t] = fields.triangles.size();
    if (!tool.present)
      continue;
    dem::TriangleSurface const& surface = tool.surface.triangles();
    auto const base = static_cast<std::uint32_t>(fields.vertices.size());
    for (dem::Vec3 const& vertex : surface.vertices)
      fields.vertices.push_back(vertex + tool.displacement);
    for (auto const& [a, b, c] : surface.triangles)
      fields.triangles.push_back({a + base, b + base, c + base});
    fields.tool.resize(fields.triangles.size(), static_cast<std::uint8_t>(t));
  }
  fields.traction.assign(fields.triangles.size(), dem::Vec3::Zero());
  contacts.for_each([&](dem::Contact const& contact) {
    if (contact.tool == dem::Contact::none || contact.triangle == dem::Contact::none)
      return;
    dem::TriangleSurface const& surface = world.tools[contact.tool].surface.triangles();
    if (contact.triangle >= surface.triangles.size())
      return; // an exact wall has none
    fields.traction[first_triangle[contact.tool] + contact.triangle] -=
        contact.force / area(surface, surface.triangles[contact.triangle]);
  });
  return fields;
}

} // namespace coupling
