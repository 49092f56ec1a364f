// Each entry about the shape of deformable tools changes the tool that the press gets.
#include "continuum/tool/elastic_tool.hpp"
#include "coupling/elastic/session.hpp"
#include "coupling/elastic/yielding_tool.hpp"
#include "coupling/press_tools.hpp"
#include "tests/support/near.hpp"
#include "tests/unit/coupling/elastic_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace coupling {
namespace {

using namespace elastic_case;
using continuum::PunchPlace;

std::string const at = "Deformable tools/";

/// 1/3 integral x.n dA, exact on these faces: pressure_loads are the integrals of -N_a n.
double volume(continuum::ToolMesh const& mesh) {
  auto const boundary = mesh.boundary();
  return boundary.pressure_loads(-1.0).cwiseProduct(boundary.positions).sum() / 3.0;
}

double punch_volume(Overrides const& overrides, PunchPlace place = PunchPlace::upper) {
  return volume(make_punch_body(read(overrides), place).mesh);
}

/// Mean radial displacement of the bore [m] under 65.7 MPa, the die on rollers.
double growth(ToolBody const& die, continuum::Supports const& supports) {
  ensure_session();
  continuum::ElasticTool const tool(die.mesh, die.materials, supports);
  auto const u = tool.solve_pressure("bore", 65.7e6).displacement;
  auto const bore_trace = die.mesh.trace("bore");
  double sum = 0.0;
  for (std::size_t i = 0; i < bore_trace.nodes.size(); ++i)
    sum += bore_trace.positions.col(i).head<2>().normalized().dot(
        u.col(bore_trace.nodes[i]).head<2>());
  return sum / bore_trace.nodes.size();
}
double growth(Overrides const& overrides) {
  return growth(make_die_body(read(overrides)), continuum::Supports::rollers("bottom"));
}

/// Two tubes with free ends, a < c < b, joined by the pressure q at which their displacements
/// agree:  q c/E2 [(b^2+c^2)/(b^2-c^2) + nu2] = 2 p a^2 c/(E (c^2-a^2)) - q c/E
/// [(c^2+a^2)/(c^2-a^2)
/// - nu].  Timoshenko, Goodier, Theory of Elasticity, section 28.
double joined_tubes(double E2, double nu2) {
  double const a = bore, c = bore + 10e-3, b = c + 10e-3, p = 65.7e6, E = 210e9, nu = 0.3;
  auto const ratio = [](double r, double R) { return (R * R + r * r) / (R * R - r * r); };
  double const thick = c * c - a * a;
  double const q =
      2.0 * p * a * a / (E * thick) / ((ratio(c, b) + nu2) / E2 + (ratio(a, c) - nu) / E);
  return p * a / E * (ratio(a, c) + nu) - 2.0 * q * c * c * a / (E * thick);
}

TEST(ElasticCase, HasARingOfItsThicknessAndMaterial) {
  Overrides const ring = {at + "Ring thickness=10 mm"};
  auto const with = [&](Overrides more) {
    more.insert(more.end(), ring.begin(), ring.end());
    return growth(more);
  };
  double const bare = growth(Overrides{}), same = with({});
  double const soft = with({at + "Ring Young's modulus=70 GPa"});
  double const narrow = with({at + "Ring Young's modulus=70 GPa", at + "Ring Poisson's ratio=0"});
  EXPECT_TRUE(near::relative(same, joined_tubes(210e9, 0.3), 5e-3));
  EXPECT_TRUE(near::relative(soft, joined_tubes(70e9, 0.3), 5e-3));
  EXPECT_GT(bare, 1.02 * soft);
  EXPECT_GT(soft, 1.05 * same);
  // joined_tubes says 1.0 % less growth for 0 than for 0.3
  EXPECT_LT(narrow, 0.995 * soft);
  RecordProperty("bore_um_bare_soft_same", std::to_string(1e6 * bare) + " " +
                                               std::to_string(1e6 * soft) + " " +
                                               std::to_string(1e6 * same));
}

// A bevel takes 2 pi d/w int (r - i) r dr, i = R - w, a cup a spherical cap pi d (3 c^2 + d^2) / 6.
TEST(ElasticCase, HasPunchFacesOfItsWidthsAndDepths) {
  double const pi = dem::pi, R = bore, w = 2e-3, d = 1e-3, i = R - w, c = R - 0.5e-3;
  double const bevel = 2.0 * pi * d / w * (R * R * R / 3.0 - i * R * R / 2.0 + i * i * i / 6.0);
  double const cup = pi * d * (3.0 * c * c + d * d) / 6.0;
  double const flat = punch_volume({});
  EXPECT_TRUE(near::relative(flat, pi * R * R * 10e-3, 1e-4));
  for (auto const place : {PunchPlace::upper, PunchPlace::lower}) {
    EXPECT_TRUE(
        near::relative(flat - punch_volume({at + "Punch face=bevelled", at + "Bevel width=2 mm",
                                            at + "Bevel depth=1 mm"},
                                           place),
                       bevel, 1e-2));
    EXPECT_TRUE(near::relative(flat - punch_volume({at + "Punch face=concave",
                                                    at + "Cup depth=1 mm", at + "Cup land=0.5 mm"},
                                                   place),
                               cup, 1e-2));
  }
  // A rim that reaches into the powder adds what one that stands back takes.
  support::ScratchFolder const folder;
  support::put_bytes(folder / "grains.csv", "");
  EXPECT_TRUE(
      near::relative(punch_volume({at + "Punch face=bevelled", at + "Bevel width=2 mm",
                                   at + "Bevel depth=-1 mm", "Powder/Fill method=file",
                                   "Powder/Fill file=" + (folder / "grains.csv").string()}) -
                         flat,
                     bevel, 1e-2));
}

TEST(ElasticCase, TakesToolsFromMeshFiles) {
  FileCase const die_case("Die mesh file", die());
  ToolBody const from_file = make_die_body(read(die_case.with()));
  EXPECT_EQ(from_file.mesh.n_cells(), 32u * 2u * 2u);
  // the same cells with round sides
  ToolBody const round{continuum::ToolMesh::from_hexes(die()), from_file.materials};
  auto const clamped = continuum::Supports::clamped("bottom");
  EXPECT_TRUE(near::relative(growth(from_file, clamped), growth(round, clamped), 0.02));
  for (auto const& [entry, place] : {std::pair{"Upper punch mesh file", PunchPlace::upper},
                                     {"Lower punch mesh file", PunchPlace::lower}}) {
    FileCase const punch_case(entry, punch(place));
    Case const setup = read(punch_case.with());
    auto const other = place == PunchPlace::upper ? PunchPlace::lower : PunchPlace::upper;
    // a polygon of 32 sides instead of the circle: sin(pi/16) / (pi/16) = 0.9936
    EXPECT_TRUE(near::relative(volume(make_punch_body(setup, place).mesh),
                               0.99359 * dem::pi * bore * bore * 15e-3, 1e-3));
    EXPECT_TRUE(near::relative(volume(make_punch_body(setup, other).mesh),
                               dem::pi * bore * bore * 10e-3, 1e-3));
  }
}

TEST(ElasticCase, ReadsMeshesInTheUnitOfMeshScale) {
  FileCase const in_mm("Die mesh file", die()), in_cm("Die mesh file", die(), 1e2);
  auto const by_mm = make_die_body(read(in_mm.with()));
  auto const by_cm = make_die_body(read(in_cm.with({at + "Mesh scale=1 cm"})));
  EXPECT_TRUE(near::relative(volume(by_cm.mesh), volume(by_mm.mesh), 1e-12));
}

TEST(ElasticCase, GivesTheSecondRegionOfAFileTheRingsMaterial) {
  FileCase const file("Die mesh file", ringed_die());
  auto const clamped = continuum::Supports::clamped("bottom");
  auto const plain = make_die_body(read(file.with()));
  auto const soft = make_die_body(read(file.with({at + "Ring Young's modulus=70 GPa"})));
  ASSERT_EQ(plain.materials.size(), 2u);
  EXPECT_EQ(plain.materials[1].young_modulus, 210e9);
  EXPECT_EQ(soft.materials[0].young_modulus, 210e9);
  EXPECT_EQ(soft.materials[1].young_modulus, 70e9);
  EXPECT_GT(growth(soft, clamped), 1.05 * growth(plain, clamped));
}

// A run keeps its case as understood: read again it says the same.
TEST(ElasticCase, SurvivesItsResolvedText) {
  FileCase const file("Die mesh file", ringed_die());
  for (Overrides const& overrides :
       {Overrides{at + "Ring thickness=10 mm", at + "Ring Poisson's ratio=0.2",
                  at + "Punch face=bevelled", at + "Bevel width=2 mm", at + "Bevel depth=1 mm"},
        Overrides{at + "Punch face=concave", at + "Cup depth=1 mm", at + "Cup land=1 mm"},
        file.with({at + "Ring Young's modulus=70 GPa"})}) {
    Case const first = read(overrides);
    Case const again = parse_case(first.resolved_text, "again.prm");
    EXPECT_EQ(again.resolved_text, first.resolved_text);
    EXPECT_EQ(make_die_body(again).mesh.hash(), make_die_body(first).mesh.hash());
    EXPECT_EQ(make_punch_body(again, PunchPlace::upper).mesh.hash(),
              make_punch_body(first, PunchPlace::upper).mesh.hash());
    ASSERT_EQ(again.elastic.ring.has_value(), first.elastic.ring.has_value());
    if (first.elastic.ring) {
      EXPECT_EQ(again.elastic.ring->young_modulus, first.elastic.ring->young_modulus);
      EXPECT_EQ(again.elastic.ring->poisson_ratio, first.elastic.ring->poisson_ratio);
    }
  }
}

// The press gets these bodies: the upper punch's flat part at the fill height, its cup above it.
TEST(ElasticCase, ReachesThePress) {
  support::ScratchFolder const cache;
  setenv("PRESSCHECK_CACHE", cache.path().c_str(), 1);
  Case const setup = read({at + "Ring thickness=10 mm", at + "Punch face=concave",
                           at + "Cup depth=2 mm", at + "Cup land=1 mm"});
  auto const tools = make_yielding_tools(setup);
  ASSERT_EQ(tools.size(), 3u);
  EXPECT_EQ(tools[0].body->body.mesh().hash(), make_die_body(setup).mesh.hash());
  EXPECT_EQ(tools[0].body->body.materials().size(), 2u);
  EXPECT_LT(tools[0].body->gap, 1e-6);
  for (auto const& [tool, place, z, outwards] :
       {std::tuple{1, PunchPlace::upper, 20e-3, 1.0}, {2, PunchPlace::lower, 0.0, -1.0}}) {
    EXPECT_EQ(tools[tool].body->body.mesh().hash(), make_punch_body(setup, place).mesh.hash());
    // a cup is followed by quadratic interpolation, within the chordal tolerance
    EXPECT_LT(tools[tool].body->gap, 1e-5);
    // in the middle the cup is deepest, on the land the face is where a flat one is
    for (auto const& [r, height] : {std::pair{0.0, z + outwards * 2e-3}, {10.6e-3, z}}) {
      std::vector<dem::SurfacePoint> found;
      tools[tool].touched.find({r, 0.0, height}, 1e-4, found);
      ASSERT_FALSE(found.empty()) << tool << " at r = " << r;
      EXPECT_LT(std::abs(found.front().distance), 2e-5) << tool << " at r = " << r;
    }
  }
}

// A file's mesh with straight sides leaves the case's bore by 53 um between corners; what grains
// follow stays with the FE surface within the chordal tolerance, not with that bore.
TEST(ElasticCase, FromFilesReachesThePress) {
  support::ScratchFolder const cache;
  setenv("PRESSCHECK_CACHE", cache.path().c_str(), 1);
  FileCase const die_file("Die mesh file", die());
  FileCase const upper("Upper punch mesh file", punch(PunchPlace::upper));
  FileCase const lower("Lower punch mesh file", punch(PunchPlace::lower));
  auto const tools = make_yielding_tools(
      read(die_file.with({at + "Upper punch mesh file=" + upper.path().string(),
                          at + "Lower punch mesh file=" + lower.path().string()})));
  ASSERT_EQ(tools.size(), 3u);
  EXPECT_EQ(tools[0].body->body.mesh().n_cells(), die().cells.size());
  EXPECT_LT(tools[0].body->gap, 1e-5);
  for (int const t : {1, 2}) {
    EXPECT_EQ(tools[t].body->body.mesh().n_cells(), punch(PunchPlace::upper).cells.size());
    EXPECT_LT(tools[t].body->gap, 1e-9);
    EXPECT_TRUE(near::relative(tools[t].body->area, 0.99359 * dem::pi * bore * bore, 1e-3));
  }
}

// Drawings of the same tools, in millimetres and elsewhere on the axis: grains touch the drawings,
// and the bodies behind them yield as those from the dimensions do, as far as coarse cells can say.
TEST(ElasticCase, TakesToolsFromStlFiles) {
  support::ScratchFolder const scratch;
  setenv("PRESSCHECK_CACHE", scratch.path().c_str(), 1);
  auto const save = [&](char const* name, dem::TriangleSurface surface, double z) {
    for (dem::Vec3& vertex : surface.vertices)
      vertex.z() += z;
    dem::write_stl(scratch / name, surface, dem::StlFormat::binary, 1e-3);
    return (scratch / name).string();
  };
  auto const drawn_punch = [](dem::PunchFace face) {
    return dem::make_punch(2.0 * bore, 10e-3, 1e-5, face);
  };
  Overrides const files = {
      "Tooling/STL scale=1 mm", at + "Largest gap=0.1 mm",
      "Tooling/Die file=" + save("die.stl", die_surface(bore), 0.0),
      "Tooling/Upper punch file=" + save("upper.stl", drawn_punch(dem::PunchFace::down), 50e-3),
      "Tooling/Lower punch file=" + save("lower.stl", drawn_punch(dem::PunchFace::up), -7e-3)};
  auto const drawn = make_yielding_tools(read(files, "8 mm")), made = make_yielding_tools(read({}));
  for (int const t : {0, 1, 2}) {
    EXPECT_LT(drawn[t].body->gap, 1e-6) << t;
    EXPECT_TRUE(near::relative(drawn[t].body->area, made[t].body->area, 2e-5)) << t;
    EXPECT_TRUE(
        near::relative(drawn[t].body->uniform_compliance, made[t].body->uniform_compliance, 0.01))
        << t;
    auto const high = [](ElasticPair const& tool) {
      auto const& surface = tool.body->surface->trace();
      return surface.positions.row(2).maxCoeff() + tool.body->offset.z();
    };
    EXPECT_NEAR(high(drawn[t]), high(made[t]), 1e-8) << t;
    // A grain there meets the pressed surface, which carries it.
    dem::Vec3 const touch(t == 0 ? 10.9e-3 : 0.0, 0.0, t == 1 ? 20e-3 : t == 0 ? 10e-3 : 0.0);
    std::vector<dem::SurfacePoint> found;
    drawn[t].touched.find(touch, 2e-4, found);
    ASSERT_EQ(found.size(), 1u) << t;
    EXPECT_NE(drawn[t].body->surface->locate(found[0].patch, found[0].point).face,
              dem::SurfacePlace::rigid);
  }
}

// One word makes the same tools rigid: what grains touch keeps its shape.
TEST(ElasticCase, KeepsItsShapesWhenRigid) {
  support::ScratchFolder const cache;
  setenv("PRESSCHECK_CACHE", cache.path().c_str(), 1);
  Overrides shapes = {at + "Punch face=concave", at + "Cup depth=2 mm", at + "Cup land=1 mm",
                      at + "Young's modulus=70 GPa", at + "Window=50"};
  auto const elastic = make_yielding_tools(read(shapes));
  shapes.push_back("Mode=rigid");
  auto const rigid = make_tools(read(shapes), 0);
  for (int const t : {1, 2}) {
    auto const& one = elastic[t].touched.triangles().vertices;
    auto const& other = rigid[t].surface.triangles().vertices;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t v = 0; v < one.size(); ++v)
      EXPECT_LT((one[v] - other[v]).norm(), 1e-15);
  }
}

} // namespace
} // namespace coupling
