#include "dem/measure/fields.hpp"

#include "dem/expect.hpp"
#include "dem/measure/compensated_sum.hpp"
#include "dem/measure/contact_statistics.hpp"
#include "dem/measure/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

struct KernelPoint {
  Vec3 offset;   // [m]
  double weight; // all sum to 1
};

/// The kernel as points: antipodal pairs on a Fibonacci spiral, so that its first moment vanishes
/// exactly.
std::vector<KernelPoint> make_kernel(double width) {
  constexpr int n_pairs = 16;
  double const golden_angle = pi * (3.0 - std::sqrt(5.0));
  QuadratureRule const shells = gauss_legendre(5);
  std::vector<KernelPoint> points;
  double sum = 0.0;
  for (std::size_t s = 0; s < shells.points.size(); ++s) {
    double const d = 0.5 * (1.0 + shells.points[s]); // in kernel widths
    double const weight = shells.weights[s] * d * d * (1.0 + 3.0 * d) * std::pow(1.0 - d, 3);
    for (int k = 0; k < n_pairs; ++k) {
      double const z = (k + 0.5) / n_pairs;
      double const angle =
          golden_angle * k + static_cast<double>(s); // shells are turned against each other
      double const r = std::sqrt(1.0 - z * z);
      Vec3 const offset = width * d * Vec3(r * std::cos(angle), r * std::sin(angle), z);
      points.push_back({offset, weight});
      points.push_back({-offset, weight});
      sum += 2.0 * weight;
    }
  }
  for (KernelPoint& point : points)
    point.weight /= sum;
  return points;
}

void validate(FieldGrid const& grid) {
  bool const has_room =
      grid.radius > 0.0 && grid.top > grid.bottom && grid.n_r >= 1 && grid.n_z >= 1;
  VALIDATE(has_room, "fields: the grid has no room (it needs a radius, a height and a cell)");
  double const room = std::min(grid.radius, grid.top - grid.bottom);
  VALIDATE(grid.kernel_width > 0.0 && grid.kernel_width <= 0.25 * room,
           "fields: kernel width = " + std::to_string(grid.kernel_width) +
               " m is not between 0 and a quarter of the die's radius and the bed's height (it "
               "would be mirrored twice)");
}

/// Spreads quantities about points of the grid.
class Spreader {
public:
  explicit Spreader(FieldGrid const& grid) : grid_(grid), kernel_(make_kernel(grid.kernel_width)) {}

  /// Calls add(cell, weight, e_r) for each kernel point about `centre`; the weights sum to 1.
  template <class Add> void spread(Vec3 const& centre, Add&& add) const {
    for (KernelPoint const& point : kernel_) {
      Vec3 const x = centre + point.offset;
      double const r = std::sqrt(x[0] * x[0] + x[1] * x[1]);
      Vec3 const e_r = r > 0.0 ? Vec3(x[0] / r, x[1] / r, 0.0) : Vec3(Vec3::UnitX());
      add(cell_at(mirrored_radius(r), mirrored_height(x[2])), point.weight, e_r);
    }
  }

  bool holds(Vec3 const& x) const {
    return std::hypot(x[0], x[1]) <= grid_.radius && x[2] >= grid_.bottom && x[2] <= grid_.top;
  }

private:
  // In r^2, so that rings keep their area: a uniform bed fills exactly what it lost.
  double mirrored_radius(double r) const {
    double const R = grid_.radius;
    return r <= R ? r : std::sqrt(std::max(0.0, 2.0 * R * R - r * r));
  }
  double mirrored_height(double z) const {
    if (z < grid_.bottom)
      return 2.0 * grid_.bottom - z;
    return z > grid_.top ? 2.0 * grid_.top - z : z;
  }
  std::size_t cell_at(double r, double z) const {
    int const i_r = static_cast<int>(r / grid_.radius * grid_.n_r);
    int const i_z = static_cast<int>((z - grid_.bottom) / (grid_.top - grid_.bottom) * grid_.n_z);
    return grid_.cell(std::clamp(i_r, 0, grid_.n_r - 1), std::clamp(i_z, 0, grid_.n_z - 1));
  }

  FieldGrid const& grid_;
  std::vector<KernelPoint> kernel_;
};

/// What a cell holds, before it is divided by its mass or volume.
struct CellSums {
  CompensatedSum mass, momentum_r, momentum_z;               // [kg], [kg m/s]
  CompensatedSum solid;                                      // [m^3]
  CompensatedSum virial_rr, virial_tt, virial_zz, virial_rz; // [J]
};
using Sums = std::vector<CellSums>;

void spread_grain(Sums& sums, Spreader const& spreader, Spheres const& grains, std::size_t i) {
  double const mass = grains.mass[i], volume = sphere_volume(grains.radius[i]);
  Vec3 const& v = grains.velocity[i];
  spreader.spread(grains.position[i], [&](std::size_t cell, double weight, Vec3 const& e_r) {
    sums[cell].mass += weight * mass;
    sums[cell].solid += weight * volume;
    sums[cell].momentum_r += weight * mass * v.dot(e_r);
    sums[cell].momentum_z += weight * mass * v[2];
  });
}

void spread_virial(Sums& sums, Spreader const& spreader, Vec3 const& x, Vec3 const& branch,
                   Vec3 const& force) {
  spreader.spread(x, [&](std::size_t cell, double weight, Vec3 const& e_r) {
    double const l_r = branch.dot(e_r), l_t = e_r[0] * branch[1] - e_r[1] * branch[0];
    double const f_r = force.dot(e_r), f_t = e_r[0] * force[1] - e_r[1] * force[0];
    sums[cell].virial_rr += -weight * f_r * l_r;
    sums[cell].virial_tt += -weight * f_t * l_t;
    sums[cell].virial_zz += -weight * force[2] * branch[2];
    sums[cell].virial_rz += -weight * 0.5 * (f_r * branch[2] + force[2] * l_r);
  });
}

void spread_contact(Sums& sums, Spreader const& spreader, Spheres const& grains,
                    Contact const& contact, double kernel_width) {
  Vec3 const& from = grains.position[contact.i];
  bool const has_partner = contact.j != Contact::none;
  Vec3 const branch = (has_partner ? grains.position[contact.j] : contact.point) - from;
  // Two Gauss points a piece; a piece is no longer than the kernel.
  int const n_pieces = std::max(1, static_cast<int>(std::ceil(branch.norm() / kernel_width)));
  double const gauss = 0.5 / std::sqrt(3.0);
  for (int piece = 0; piece < n_pieces; ++piece)
    for (double shift : {0.5 - gauss, 0.5 + gauss})
      spread_virial(sums, spreader, from + (piece + shift) / n_pieces * branch,
                    0.5 / n_pieces * branch, contact.force);
  if (double const lens = contact_lens(grains, contact); lens > 0.0)
    spreader.spread(contact.point, [&](std::size_t cell, double weight, Vec3 const&) {
      sums[cell].solid += -weight * lens;
    });
}

/// From sums to fields: momentum over mass, everything else over volume.
Fields divide(Sums const& sums, FieldGrid const& grid) {
  Fields fields;
  for (int i_z = 0; i_z < grid.n_z; ++i_z)
    for (int i_r = 0; i_r < grid.n_r; ++i_r) {
      CellSums const& cell = sums[grid.cell(i_r, i_z)];
      double const mass = cell.mass.value(), volume = grid.cell_volume(i_r);
      fields.density.push_back(mass / volume);
      fields.solid_fraction.push_back(cell.solid.value() / volume);
      fields.velocity_r.push_back(mass > 0.0 ? cell.momentum_r.value() / mass : 0.0);
      fields.velocity_z.push_back(mass > 0.0 ? cell.momentum_z.value() / mass : 0.0);
      fields.stress_rr.push_back(cell.virial_rr.value() / volume);
      fields.stress_tt.push_back(cell.virial_tt.value() / volume);
      fields.stress_zz.push_back(cell.virial_zz.value() / volume);
      fields.stress_rz.push_back(cell.virial_rz.value() / volume);
    }
  return fields;
}

} // namespace

double FieldGrid::cell_volume(int i_r) const {
  double const step = radius / n_r;
  return pi * step * step * (2 * i_r + 1) * (top - bottom) / n_z;
}

Fields coarse_grain(Spheres const& grains, ContactStream const& contacts, FieldGrid const& grid) {
  validate(grid);
  Spreader const spreader(grid);
  Sums sums(grid.n_cells());
  double mass_outside = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (spreader.holds(grains.position[i]))
      spread_grain(sums, spreader, grains, i);
    else
      mass_outside += grains.mass[i];
  }
  contacts.for_each([&](Contact const& contact) {
    if (spreader.holds(grains.position[contact.i]))
      spread_contact(sums, spreader, grains, contact, grid.kernel_width);
  });
  Fields fields = divide(sums, grid);
  fields.mass_outside = mass_outside;
  return fields;
}

} // namespace dem
