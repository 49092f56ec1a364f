#include "coupling/press_measures.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/spheres.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace coupling;
using support::ScratchFolder;

// How the bed and the tools may differ from the case's nominal ones: a tilted punch, fines, a
// settled fill.
namespace {

double mass_of(dem::Spheres const& grains, auto&& belongs) {
  double mass = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (belongs(i))
      mass += grains.mass[i];
  return mass;
}

double mean_height(dem::Spheres const& grains) {
  double moment = 0.0, mass = 0.0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    moment += grains.mass[i] * grains.position[i].z(), mass += grains.mass[i];
  return moment / mass;
}

std::vector<std::string> const settling{"Powder/Settle time=30 ms",
                                        "Contact/Particle-particle/Cohesion energy density=0"};

std::vector<std::string> settling_with(std::vector<std::string> more) {
  more.insert(more.end(), settling.begin(), settling.end());
  return more;
}

} // namespace

TEST(PunchTilt, LeansTheFaceAndKeepsItsMiddle) {
  for (std::string const walls : {"surface", "analytic"}) {
    auto const press = tiny::press({"Tooling/Punch tilt=0.3 mm", "Tooling/Walls=" + walls});
    double const slope = 0.3 / 6.0;
    for (double const x : {-2.5e-3, 0.0, 2.5e-3}) {
      std::vector<dem::SurfacePoint> found;
      tool_named(press.world, "upper_punch").surface.find({x, 0.2e-3, 7.7e-3}, 0.45e-3, found);
      ASSERT_EQ(found.size(), 1u);
      // Of a point below the plane z = 8 mm + slope x.
      EXPECT_NEAR(found[0].distance, (0.3e-3 + slope * x) / std::hypot(1.0, slope), 1e-12);
      EXPECT_NEAR(found[0].normal.x() / found[0].normal.z(), -slope, 1e-12);
    }
    EXPECT_TRUE(dem::list_contacts(press.world).empty()) << "the fill leaves room for it";
  }
}

TEST(PunchTilt, PushesAside) {
  ScratchFolder scratch;
  auto press = tiny::press(
      {"Tooling/Punch tilt=0.3 mm", "Contact/Particle-wall/Coefficient of static friction=0"});
  tiny::run(press, scratch.path(), "loading");
  dem::Tool const& punch = tool_named(press.world, "upper_punch");
  // Without friction the bed pushes along the face's normal.
  EXPECT_GT(punch.force.z(), 1.0);
  EXPECT_NEAR(punch.force.x() / punch.force.z(), -0.3 / 6.0, 1e-6);
  EXPECT_NEAR(punch.force.y() / punch.force.z(), 0.0, 1e-6);
  EXPECT_EQ(read_press(press).grains_outside, 0.0);
}

TEST(PunchTilt, StopsWhereTheLowSideArrives) {
  ScratchFolder scratch;
  Case setup = tiny::read({"Tooling/Punch tilt=2 mm", "Powder/Total mass=60 mg"});
  setup.stages.resize(1);
  setup.stages[0].until = Limit::force;
  setup.stages[0].force = 1e6;
  Press press = set_up_press(setup);
  try {
    tiny::run(press, scratch.path());
    FAIL() << "it passed through the lower punch";
  } catch (dem::PhysicsGuard const& guard) {
    EXPECT_GT(punch_gap(press.world, press.programme.faces()), 0.99e-3) << guard.what();
  }
}

TEST(AddedFines, TakeTheirShareOfEveryComponentsMass) {
  auto const plain = tiny::press();
  auto const fine =
      tiny::press({"Powder/Added fines/Share=10 %", "Powder/Added fines/Diameter=0.4 mm"});
  dem::Spheres const& g = fine.world.grains;
  for (std::uint8_t const component : {0, 1}) {
    double const mass = component == 0 ? 0.24e-3 : 0.06e-3;
    auto const is_its = [&](std::size_t i) { return g.material[i] == component; };
    auto const is_fine = [&](std::size_t i) { return is_its(i) && g.radius[i] < 0.3e-3; };
    // Coarse classes are whole grains of up to 6.2 mg (1.5 mm); the fines, of 0.12 mg, make up.
    EXPECT_NEAR(mass_of(g, is_its), mass, 0.12e-6);
    EXPECT_NEAR(mass_of(g, is_fine), 0.1 * mass, 3.2e-6);
    EXPECT_GT(mass_of(g, is_fine), 0.0);
  }
  EXPECT_NEAR(fine.grain_mass, 0.3e-3, 0.06e-6);
  EXPECT_GT(g.size(), 2 * plain.world.grains.size());
}

TEST(FillState, TakesFrictionAwayWhileGrainsSettle) {
  ScratchFolder scratch;
  auto press = tiny::press(settling_with({"Powder/Fill state=0.75"}));
  EXPECT_EQ(press.world.materials.pair(0, 1).interaction.static_friction, 0.05);
  EXPECT_EQ(press.world.materials.pair(0, 2).interaction.static_friction, 0.05);
  tiny::run(press, scratch.path(), "settle");
  EXPECT_EQ(press.world.materials.pair(0, 1).interaction.static_friction, 0.2);
  EXPECT_EQ(press.world.materials.pair(0, 2).interaction.static_friction, 0.2);
}

TEST(FillState, PacksTheBedDenser) {
  ScratchFolder scratch;
  auto const settled = [&](std::string const& state) {
    auto press = tiny::press(settling_with({"Powder/Fill state=" + state}));
    tiny::run(press, scratch / state, "settle");
    return mean_height(press.world.grains);
  };
  double const rough = settled("0"), tapped = settled("1");
  EXPECT_LT(tapped, 0.995 * rough);
  EXPECT_GT(tapped, 0.9 * rough);
}

TEST(FillState, ContactsTakeUpTheFrictionOfTheStage) {
  // A restored press does what one that was never stopped does: contacts have the same constants.
  auto const all = settling_with(
      {"Powder/Fill state=1", "Contact/Multi-contact coefficient=1", "Tooling/Punch tilt=0.2 mm"});
  ScratchFolder scratch;
  Press whole = tiny::press(all);
  tiny::run(whole, scratch / "whole", "loading");
  Press first = tiny::press(all);
  tiny::run(first, scratch / "part", "settle");
  Press second = restore_press(tiny::read(all), stage_restart(scratch / "part", "settle"));
  tiny::run(second, scratch / "part", "loading");
  EXPECT_EQ(whole.record.rows(), second.record.rows());
  // The bed rubs only from the loading on.
  auto const work = whole.record.column("tangential_work");
  auto const last = std::ranges::find(whole.record.stages(), "loading");
  auto const begin = static_cast<std::size_t>(last - whole.record.stages().begin());
  EXPECT_LT(std::abs(work[begin - 1]), 0.02 * work.back());
}
