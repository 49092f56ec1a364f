#include "coupling/press_set_up.hpp"

#include "coupling/press_grains.hpp"
#include "coupling/press_measures.hpp"
#include "coupling/press_tools.hpp"
#include "dem/expect.hpp"
#include "dem/step/advance.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace coupling;
using support::ScratchFolder;

namespace {

double mass_of(dem::Spheres const& grains, std::uint8_t material) {
  double mass = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (grains.material[i] == material)
      mass += grains.mass[i];
  return mass;
}

std::string refusal(std::vector<std::string> const& changes) {
  try {
    tiny::press(changes);
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "accepted";
}

} // namespace

TEST(PressSetUp, FillsTheCasesMassWithinAGrain) {
  auto const press = tiny::press();
  // The lightest grain is 1 mm of 3000 kg/m^3: 1.571 mg.
  EXPECT_NEAR(press.grain_mass, 0.3e-3, 0.8e-6);
  EXPECT_NEAR(mass_of(press.world.grains, 0), 0.24e-3, 1.8e-6); // 80 % MgO
  EXPECT_NEAR(mass_of(press.world.grains, 1), 0.06e-3, 1.6e-6);
}

TEST(PressSetUp, GrainsStartInsideTheToolsAtRest) {
  auto const press = tiny::press();
  for (std::size_t i = 0; i < press.world.grains.size(); ++i) {
    dem::Vec3 const& x = press.world.grains.position[i];
    double const R = press.world.grains.radius[i];
    EXPECT_LE(std::hypot(x.x(), x.y()) + R, 3e-3);
    EXPECT_GE(x.z() - R, 0.0);
    EXPECT_LE(x.z() + R, 8e-3);
    EXPECT_EQ(press.world.grains.velocity[i].norm(), 0.0);
  }
  EXPECT_TRUE(dem::list_contacts(press.world).empty());
}

TEST(PressSetUp, TheToolsStandWhereTheProgrammeThinks) {
  auto const press = tiny::press();
  EXPECT_EQ(punch_gap(press.world, press.programme.faces()), 8e-3);
  std::vector<dem::SurfacePoint> found;
  tool_named(press.world, "upper_punch").surface.find({0.0, 0.0, 7.9e-3}, 1e-3, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].distance, 0.1e-3, 1e-15);
  EXPECT_NEAR(found[0].normal.z(), -1.0, 1e-12);
  found.clear();
  tool_named(press.world, "die").surface.find({2.9e-3, 0.0, 4e-3}, 1e-3, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].distance, 0.1e-3, 1e-8);
}

TEST(PressSetUp, AnalyticWallsHaveNoRimNearThePowder) {
  auto const press = tiny::press({"Tooling/Walls=analytic"});
  std::vector<dem::SurfacePoint> found;
  // A grain that has left through the die's top, and one that lies on the lower punch beside the
  // bore.
  tool_named(press.world, "die").surface.find({2.9e-3, 0.0, 12e-3}, 1e-3, found);
  tool_named(press.world, "lower_punch").surface.find({8e-3, 0.0, 0.4e-3}, 1e-3, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].distance, 0.1e-3, 1e-8);
  EXPECT_NEAR(found[1].distance, 0.4e-3, 1e-15);
  ScratchFolder scratch;
  write_tools(press, scratch / "geometry");
  EXPECT_FALSE(std::filesystem::exists(scratch / "geometry"));
}

TEST(PressSetUp, ToolsFromTheirOwnStlFilesGiveTheSamePress) {
  ScratchFolder scratch;
  auto const generated = tiny::press();
  write_tools(generated, scratch.path());
  auto const in = [&](std::string const& name) { return (scratch / name).string(); };
  auto const read = tiny::press({"Tooling/Die file=" + in("die.stl"),
                                 "Tooling/Upper punch file=" + in("upper_punch.stl"),
                                 "Tooling/Lower punch file=" + in("lower_punch.stl")});
  EXPECT_EQ(punch_gap(read.world, read.programme.faces()), 8e-3);
  for (std::size_t t = 0; t < 3; ++t) {
    auto const& a = generated.world.tools[t].surface;
    auto const& b = read.world.tools[t].surface;
    EXPECT_EQ(a.triangles().triangles.size(), b.triangles().triangles.size());
    EXPECT_EQ(a.patches().size(), b.patches().size());
    std::vector<dem::SurfacePoint> at_a, at_b;
    a.find({2.8e-3, 0.1e-3, 4e-3}, 9e-3, at_a);
    b.find({2.8e-3, 0.1e-3, 4e-3}, 9e-3, at_b);
    ASSERT_EQ(at_a.size(), at_b.size());
    for (std::size_t k = 0; k < at_a.size(); ++k)
      EXPECT_NEAR(at_a[k].distance, at_b[k].distance, 1e-9);
  }
}

TEST(PressSetUp, APunchMayBeDrawnAnywhereAlongTheAxis) {
  ScratchFolder scratch;
  auto const generated = tiny::press({"Powder/Fill height=8 mm"});
  write_tools(generated, scratch.path()); // the punch's face is drawn at 8 mm
  auto const press =
      tiny::press({"Tooling/Upper punch file=" + (scratch / "upper_punch.stl").string(),
                   "Tooling/Die height=9 mm", "Powder/Fill height=9 mm"});
  std::vector<dem::SurfacePoint> found;
  tool_named(press.world, "upper_punch").surface.find({0.0, 0.0, 8.9e-3}, 1e-3, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].distance, 0.1e-3, 1e-12);
}

TEST(PressSetUp, SettlingIsAStageOfItsOwn) {
  auto const stages = stages_of(tiny::read({"Powder/Settle time=2 ms"}));
  ASSERT_EQ(stages.size(), 5u);
  EXPECT_EQ(stages[0].name, "settle");
  EXPECT_EQ(stages[0].kind, StageKind::free);
  EXPECT_EQ(stages[0].duration, 2e-3);
}

TEST(PressSetUp, TheWallsMaterialIsTheLastRowAndCarriesItsOwnInteraction) {
  auto const materials =
      make_materials(tiny::read({"Contact/Particle-wall/Coefficient of static friction=0.7"}));
  ASSERT_EQ(materials.size(), 3u);
  EXPECT_EQ(materials[2].young_modulus, 200e6);
  EXPECT_EQ(materials.pair(0, 2).interaction.static_friction, 0.7);
  EXPECT_EQ(materials.pair(2, 1).interaction.cohesion_energy_density, 0.0);
  EXPECT_EQ(materials.pair(0, 1).interaction.static_friction, 0.2);
  EXPECT_EQ(materials.pair(1, 1).interaction.cohesion_energy_density, 5e5);
}

TEST(PressSetUp, TheStateOfARunIsAFilling) {
  ScratchFolder scratch;
  auto first = tiny::press({"Press programme/Stage 1/Gap=7 mm"});
  tiny::run(first, scratch.path(), "loading");
  auto const next =
      tiny::press({"Powder/Fill method=state", "Powder/Fill file=" + scratch.path().string(),
                   "Powder/Fill height=7 mm"});
  ASSERT_EQ(next.world.grains.size(), first.world.grains.size());
  std::map<std::uint32_t, dem::Vec3> position;
  for (std::size_t i = 0; i < first.world.grains.size(); ++i)
    position[first.world.grains.id[i]] = first.world.grains.position[i];
  for (std::size_t i = 0; i < next.world.grains.size(); ++i)
    EXPECT_EQ(next.world.grains.position[i], position.at(next.world.grains.id[i]));
  EXPECT_NEAR(next.grain_mass, first.grain_mass, 1e-12);
}

TEST(PressSetUp, TheStepIsTheCasesShareOfTheRayleighTime) {
  auto const press = tiny::press();
  auto const& world = press.world;
  EXPECT_EQ(longest_step_of({.rayleigh_fraction = 0.07})(world), 0.07 * dem::rayleigh_time(world));
  // Nothing touches, so the adaptive step is held by the Rayleigh time alone.
  EXPECT_EQ(longest_step_of({.adaptive = true, .safety = 0.5})(world),
            0.2 * dem::rayleigh_time(world));
}

TEST(PressSetUp, AToolsShareOfAContactIsThatOfItsCompliance) {
  // (1 - nu^2)/E: 0.96/200 MPa of the tool, 0.84/150 MPa and 0.96/600 MPa of the grains.
  Case const setup = tiny::read(
      {"Tooling/Young's modulus=200 MPa", "Tooling/Poisson's ratio=0.2",
       "Powder/Component 1/Young's modulus=150 MPa", "Powder/Component 1/Poisson's ratio=0.4",
       "Powder/Component 2/Young's modulus=600 MPa", "Powder/Component 2/Poisson's ratio=0.2"});
  EXPECT_NEAR(tool_share(setup), 3.0 / 4.0, 1e-12); // with the stiffer of the two
}

TEST(PressSetUp, RefusesWhatOnlyGeometryShows) {
  EXPECT_NE(refusal({"Powder/Fill method=state", "Powder/Fill file=nowhere"}).find("nowhere"),
            std::string::npos);
  ScratchFolder scratch;
  write_tools(tiny::press(), scratch.path());
  auto const die = (scratch / "die.stl").string();
  EXPECT_NE(refusal({"Tooling/Die file=" + die, "Tooling/Bore diameter=5.5 mm",
                     "Powder/Fill height=8 mm", "Powder/Total mass=0.2 g"})
                .find("its bore of 0.006 m diameter is not"),
            std::string::npos);
  auto const punch = (scratch / "upper_punch.stl").string();
  EXPECT_NE(refusal({"Tooling/Upper punch file=" + punch, "Tooling/Bore diameter=16 mm",
                     "Powder/Total mass=0.3 g"})
                .find("does not fit a bore of 0.016 m"),
            std::string::npos);
  Case endless = tiny::read({"Tooling/Walls=analytic"});
  endless.stages = {{.name = "withdrawal",
                     .kind = StageKind::move,
                     .tools = {"die"},
                     .speed = -0.1,
                     .until = Limit::flush}};
  EXPECT_THROW(set_up_press(endless), dem::InvalidInput);
  auto const path = scratch / "path.csv";
  support::put_bytes(path, "time [s],punch_gap [m]\n0,0.0044\n1,0.008\n");
  auto const follow = [&](std::string const& stiffness) {
    Case setup = tiny::read({"Press frame/Stiffness=" + stiffness});
    setup.stages[1] = {.name = "unloading",
                       .kind = StageKind::follow,
                       .tools = {"upper_punch"},
                       .follow_file = path};
    set_up_press(setup);
  };
  EXPECT_NO_THROW(follow("0 N/m"));
  EXPECT_THROW(follow("1 kN/mm"), dem::InvalidInput);
}
