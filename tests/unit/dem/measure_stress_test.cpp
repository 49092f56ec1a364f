#include "dem/measure/fields.hpp"
#include "dem/measure/stress.hpp"

#include "dem/expect.hpp"
#include "tests/unit/dem/measure_builders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace dem {
namespace {

using test::simple_cubic;
using test::touch;
using test::touch_tool;

constexpr double die = 11e-3, d = 0.5e-3, load = 2.0; // [m], [m], [N] a column of grains
constexpr int n_layers = 20;

/// Columns of touching grains that fill a die of radius `die` and height n_layers d; each carries
/// `load` from punch to punch.
struct LoadedColumns {
  Spheres grains = simple_cubic(d, 22, n_layers, Vec3(0.1 * d, 0.2 * d, 0.5 * d),
                                [](Vec3 const& x) { return x.head<2>().norm() < die; });
  std::vector<Contact> contacts;

  LoadedColumns() {
    auto const n_columns = static_cast<std::uint32_t>(grains.size() / n_layers);
    for (std::uint32_t i = 0; i < grains.size(); ++i) {
      Vec3 const below = grains.position[i] - Vec3(0, 0, 0.5 * d), up(0, 0, load);
      if (i < n_columns)
        contacts.push_back(touch_tool(grains, i, below, up));
      else
        contacts.push_back(touch(grains, i, i - n_columns, up));
      if (i >= grains.size() - n_columns)
        contacts.push_back(touch_tool(grains, i, below + Vec3(0, 0, d), -up));
    }
  }
};

FieldGrid const grid{
    .radius = die, .bottom = 0.0, .top = n_layers * d, .n_r = 6, .n_z = 8, .kernel_width = 1.5e-3};

double integrate(std::vector<double> const& field, FieldGrid const& over) {
  double sum = 0.0;
  for (int i_z = 0; i_z < over.n_z; ++i_z)
    for (int i_r = 0; i_r < over.n_r; ++i_r)
      sum += field[over.cell(i_r, i_z)] * over.cell_volume(i_r);
  return sum;
}

// Two forces F, equal and opposite, at the ends of a diameter 2R: sigma_zz = 2 R F / (4/3 pi R^3) =
// 3 F / (2 pi R^2).
TEST(GrainStress, OfADiametralPairIsPositiveInCompression) {
  Spheres grains;
  grains.add({0, 0, 1e-3}, 1e-3, 3000.0, 0);
  std::vector<Contact> const contacts{touch_tool(grains, 0, Vec3::Zero(), Vec3(0, 0, 3)),
                                      touch_tool(grains, 0, Vec3(0, 0, 2e-3), Vec3(0, 0, -3))};
  Tensor expected = Tensor::Zero();
  expected(2, 2) = 4.5 / (pi * 1e-6);
  EXPECT_LT((grain_stresses(grains, contacts)[0] - expected).norm(), 1e-9 * expected.norm());
}

// A couple of shear forces F along x at the poles and F along z at the equator, in balance of
// moments: sigma_xz = sigma_zx.
TEST(GrainStress, IsSymmetricInEquilibrium) {
  Spheres grains;
  grains.add(Vec3::Zero(), 1.0, 3000.0, 0);
  std::vector<Contact> const contacts{touch_tool(grains, 0, Vec3(0, 0, 1), Vec3(1, 0, 0)),
                                      touch_tool(grains, 0, Vec3(0, 0, -1), Vec3(-1, 0, 0)),
                                      touch_tool(grains, 0, Vec3(1, 0, 0), Vec3(0, 0, 1)),
                                      touch_tool(grains, 0, Vec3(-1, 0, 0), Vec3(0, 0, -1))};
  Tensor const stress = grain_stresses(grains, contacts)[0];
  EXPECT_NEAR(stress(0, 2), -2.0 / sphere_volume(1.0),
              1e-15); // pulling along the diagonal: tension negative
  EXPECT_NEAR(stress(2, 0), stress(0, 2), 1e-15);
}

// Each column carries the load over its whole height: sum f l = n_columns load height.
TEST(BulkStress, OfLoadedColumnsIsLoadOverArea) {
  LoadedColumns const bed;
  double const height = n_layers * d,
               area = static_cast<double>(bed.grains.size()) / n_layers * d * d;
  Tensor const stress = bulk_stress(bed.grains, bed.contacts, area * height);
  EXPECT_NEAR(stress(2, 2), load / (d * d), 1e-10 * load / (d * d));
  EXPECT_LT(std::abs(stress(0, 0)) + std::abs(stress(0, 2)) + std::abs(stress(2, 0)),
            1e-9 * stress(2, 2));
}

TEST(Fields, MassAndStressIntegrateToTheirTotals) {
  LoadedColumns const bed;
  auto const fields = coarse_grain(bed.grains, bed.contacts, grid);
  double const mass = std::accumulate(bed.grains.mass.begin(), bed.grains.mass.end(), 0.0);
  EXPECT_EQ(fields.mass_outside, 0.0);
  EXPECT_NEAR(integrate(fields.density, grid), mass, 1e-12 * mass);
  EXPECT_NEAR(integrate(fields.solid_fraction, grid), mass / 3000.0, 1e-12 * mass / 3000.0);
  double const virial = static_cast<double>(bed.grains.size()) / n_layers * load * n_layers * d;
  EXPECT_NEAR(integrate(fields.stress_zz, grid), virial, 1e-12 * virial);
}

// Uniform columns: sigma_zz = load / d^2 everywhere, in the cells at the bore and at the punches
// too. The lattice is coarse against the rings (d = 0.5 mm, 1.8 mm): the innermost ring of 3.4 mm
// radius holds 40 columns; 4 %.
TEST(Fields, StressOfLoadedColumnsIsUniformUpToTheWalls) {
  LoadedColumns const bed;
  auto const fields = coarse_grain(bed.grains, bed.contacts, grid);
  double const expected = load / (d * d);
  for (int i_z = 0; i_z < grid.n_z; ++i_z)
    for (int i_r = 0; i_r < grid.n_r; ++i_r) {
      std::size_t const k = grid.cell(i_r, i_z);
      EXPECT_NEAR(fields.stress_zz[k], expected, 0.04 * expected) << i_r << ' ' << i_z;
      EXPECT_NEAR(fields.solid_fraction[k], pi / 6.0, 0.04 * pi / 6.0) << i_r << ' ' << i_z;
      EXPECT_LT(std::abs(fields.stress_rr[k]) + std::abs(fields.stress_rz[k]), 1e-9 * expected);
    }
}

// Forces along x between neighbours along x only: in cylinder coordinates sigma_rr and sigma_tt are
// each half of sigma_xx when averaged about the axis, sigma_zz is none.
TEST(Fields, HorizontalStressSplitsIntoRadialAndHoopHalves) {
  LoadedColumns const bed;
  std::vector<Contact> contacts;
  for (std::uint32_t i = 1; i < bed.grains.size(); ++i) {
    Vec3 const between = bed.grains.position[i] - bed.grains.position[i - 1];
    if (between.norm() < 1.01 * d && between[0] > 0.99 * d)
      contacts.push_back(touch(bed.grains, i, i - 1, Vec3(load, 0, 0)));
  }
  auto const fields = coarse_grain(bed.grains, contacts, grid);
  double const half = 0.5 * load / (d * d);
  for (int i_r = 1; i_r < 4; ++i_r) {
    std::size_t const k = grid.cell(i_r, 4);
    EXPECT_NEAR(fields.stress_rr[k], half, 0.05 * half);
    EXPECT_NEAR(fields.stress_tt[k], half, 0.05 * half);
    EXPECT_EQ(fields.stress_zz[k], 0.0);
  }
}

// v = (a x, a y, b): v_r = a r and v_z = b. The mean of r over a ring's area is near its middle.
TEST(Fields, VelocityIsMomentumOverMass) {
  LoadedColumns bed;
  for (std::size_t i = 0; i < bed.grains.size(); ++i)
    bed.grains.velocity[i] =
        Vec3(7.0 * bed.grains.position[i][0], 7.0 * bed.grains.position[i][1], -0.2);
  auto const fields = coarse_grain(bed.grains, {}, grid);
  for (int i_r = 1; i_r < 4; ++i_r) {
    double const r = (i_r + 0.5) * die / 6.0;
    EXPECT_NEAR(fields.velocity_r[grid.cell(i_r, 4)], 7.0 * r, 0.05 * 7.0 * r) << i_r;
    EXPECT_NEAR(fields.velocity_z[grid.cell(i_r, 4)], -0.2, 1e-12);
  }
}

TEST(Fields, SubtractLensesAndNameTheMassOutside) {
  Spheres grains;
  grains.add({0, 0, 5e-3}, 1e-3, 3000.0, 0);
  grains.add({0, 0, 6.8e-3}, 1e-3, 3000.0, 0);
  grains.add({0, 0, 11e-3}, 1e-3, 3000.0, 0);
  std::vector<Contact> const contacts{touch(grains, 0, 1, Vec3(0, 0, -1))};
  auto const fields = coarse_grain(grains, contacts, grid);
  EXPECT_DOUBLE_EQ(fields.mass_outside, grains.mass[2]);
  double const solid = 2.0 * sphere_volume(1e-3) - lens_volume(1e-3, 1e-3, 1.8e-3);
  EXPECT_NEAR(integrate(fields.solid_fraction, grid), solid, 1e-12 * solid);
}

TEST(Fields, RefuseAKernelWiderThanAQuarterOfTheBed) {
  FieldGrid wide = grid;
  wide.kernel_width = 2.6e-3; // of 10 mm height
  EXPECT_THROW(coarse_grain({}, {}, wide), InvalidInput);
  wide.kernel_width = 0.0;
  EXPECT_THROW(coarse_grain({}, {}, wide), InvalidInput);
}

} // namespace
} // namespace dem
