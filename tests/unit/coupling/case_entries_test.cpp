#include "coupling/case_file.hpp"

#include "tests/unit/coupling/case_equality.hpp"

#include <gtest/gtest.h>

// Each entry, moved away from its default, arrives where the Case keeps it and survives the
// resolved text.
namespace coupling {
namespace {

using Overrides = std::vector<std::string>;

Case seed(Overrides const& overrides = {}) {
  return parse_case("set Mode = rigid\n", "case.prm", overrides);
}

// Every entry away from its default, spread over cases that use it.
Overrides const powder_and_tools = {
    "Title=Versuch \u00e4 <b>",
    "Powder/Total mass=0.5 g",
    "Powder/Fill height=15 mm",
    "Powder/Packing seed=18",
    "Powder/Settle time=0.1 s",
    "Powder/Fill state=0.4",
    "Powder/Added fines/Share=5 %",
    "Powder/Added fines/Diameter=0.2 mm",
    "Powder/Component 1/Name=spinel",
    "Powder/Component 1/Mass fraction=50 %",
    "Powder/Component 1/Density=3.6 g/cm^3",
    "Powder/Component 1/Young's modulus=1 GPa",
    "Powder/Component 1/Poisson's ratio=0.2",
    "Powder/Component 1/Size classes=0.7 mm: 40 %, 0.9 mm: 60 %",
    "Powder/Component 2/Name=",
    "Powder/Component 5/Name=silica",
    "Powder/Component 5/Mass fraction=0.5",
    "Breakage/Strength=30 MPa",
    "Breakage/Weibull modulus=3",
    "Breakage/Reference diameter=2 mm",
    "Breakage/Smallest diameter=0.4 mm",
    "Tooling/Bore diameter=11 mm",
    "Tooling/Die height=30 mm",
    "Tooling/Wall thickness=8 mm",
    "Tooling/Punch length=7 mm",
    "Tooling/Punch tilt=0.3 mm",
    "Tooling/Chordal tolerance=2 um",
    "Tooling/STL scale=1 mm",
    "Tooling/Density=7800 kg/m^3",
    "Tooling/Young's modulus=210 GPa",
    "Tooling/Poisson's ratio=0.3",
    "Time stepping/Rayleigh fraction=0.05",
    "Time stepping/Adaptive=yes",
    "Time stepping/Safety=0.7",
    "Time stepping/Largest relative overlap=0.5",
    "Time stepping/Largest energy error=5 %",
    "Output/Record interval=1 ms",
    "Output/Snapshot interval=0 s",
    "Output/Restart interval=1 min",
    "Output/Core diameter fraction=50 %",
    "Gravity/x=1 m/s^2",
    "Gravity/y=2 m/s^2",
    "Gravity/z=-3 m/s^2",
};

Overrides const laws_and_stages = {
    "Contact/Preset=custom",
    "Contact/Normal law=hooke",
    "Contact/Cohesion law=sjkr",
    "Contact/Tangential law=hooke_spring",
    "Contact/Rolling law=constant_torque",
    "Contact/Friction limit=elastic",
    "Contact/Tangential damping=off",
    "Contact/Limit force=on",
    "Contact/Characteristic velocity=1 m/s",
    "Contact/Adhesion exponent=5",
    "Contact/Viscous time=2 us",
    "Contact/Multi-contact coefficient=0.7",
    "Contact/Precision=double",
    "Contact/Particle-particle/Coefficient of restitution=0.4",
    "Contact/Particle-particle/Coefficient of static friction=0.3",
    "Contact/Particle-particle/Coefficient of rolling friction=0.01",
    "Contact/Particle-particle/Cohesion energy density=2e5",
    "Contact/Particle-wall/Coefficient of restitution=0.6",
    "Contact/Particle-wall/Coefficient of static friction=0.1",
    "Contact/Particle-wall/Coefficient of rolling friction=0.02",
    "Contact/Particle-wall/Cohesion energy density=1e5 J/m^3",
    "Tooling/Walls=analytic",
    "Press programme/Stage 1/Name=approach",
    "Press programme/Stage 1/Tools=upper_punch, lower_punch",
    "Press programme/Stage 1/Speed=-1 mm/min",
    "Press programme/Stage 1/Until=time",
    "Press programme/Stage 1/Duration=3 s",
    "Press programme/Stage 2/Kind=none",
    "Press programme/Stage 3/Kind=move",
    "Press programme/Stage 3/Tools=upper_punch",
    "Press programme/Stage 3/Speed=-0.1 m/s",
    "Press programme/Stage 3/Until=force",
    "Press programme/Stage 3/Force=25.1 kN",
    "Press programme/Stage 3/Duration=1 min",
    "Press programme/Stage 4/Kind=hold",
    "Press programme/Stage 4/Tools=upper_punch",
    "Press programme/Stage 4/Servo=true",
    "Press programme/Stage 4/Force=10 kN",
    "Press programme/Stage 12/Kind=release",
    "Press programme/Stage 12/Tools=die",
};

TEST(EveryEntry, OfPowderAndToolsReachesTheCase) {
  Case const it = seed(powder_and_tools);
  EXPECT_EQ(it.title, "Versuch \u00e4 <b>");
  EXPECT_EQ(it.powder.total_mass, 0.5e-3);
  EXPECT_EQ(it.powder.fill_height, 15e-3);
  EXPECT_EQ(it.powder.seed, 18u);
  EXPECT_EQ(it.powder.settle_time, 0.1);
  EXPECT_EQ(it.powder.fill_state, 0.4);
  EXPECT_EQ(it.powder.fines.share, 0.05);
  EXPECT_EQ(it.powder.fines.diameter, 0.2e-3);
  ASSERT_EQ(it.powder.components.size(), 2u);
  expect_equal(it.powder.components[0].material, {"spinel", 3600.0, 1e9, 0.2});
  EXPECT_EQ(it.powder.components[0].mass_fraction, 0.5);
  ASSERT_EQ(it.powder.components[0].sizes.size(), 3u);
  EXPECT_EQ(it.powder.components[0].sizes[1].diameter, 0.9e-3);
  EXPECT_EQ(it.powder.components[0].sizes[1].mass_fraction, 0.6 * 0.95);
  EXPECT_EQ(it.powder.components[0].sizes[2].diameter, 0.2e-3);
  EXPECT_EQ(it.powder.components[0].sizes[2].mass_fraction, 0.05);
  EXPECT_EQ(it.powder.components[1].material.name, "silica");
  EXPECT_EQ(it.breakage.strength, 30e6);
  EXPECT_EQ(it.breakage.weibull_modulus, 3.0);
  EXPECT_EQ(it.breakage.reference_diameter, 2e-3);
  EXPECT_EQ(it.breakage.smallest_diameter, 0.4e-3);
  Tooling const& tooling = it.tooling;
  EXPECT_EQ(tooling.bore_diameter, 11e-3);
  EXPECT_EQ(tooling.die_height, 30e-3);
  EXPECT_EQ(tooling.wall_thickness, 8e-3);
  EXPECT_EQ(tooling.punch_length, 7e-3);
  EXPECT_EQ(tooling.punch_tilt, 0.3e-3);
  EXPECT_EQ(tooling.chordal_tolerance, 2e-6);
  EXPECT_EQ(tooling.stl_scale, 1e-3);
  expect_equal(tooling.material, {"wall", 7800.0, 210e9, 0.3});
  expect_equal(it.time_stepping, {0.05, true, 0.7, 0.5, 0.05});
  expect_equal(it.output, {1e-3, 0.0, 60.0, 0.5});
  EXPECT_EQ(it.gravity, dem::Vec3(1.0, 2.0, -3.0));
}

TEST(EveryEntry, OfTheMachineReachesTheCase) {
  Case const it = seed({"Press frame/Gap offset=-0.2 mm", "Press frame/Thermal drift=3 um/min",
                        "Load cell/Gain=98 %", "Load cell/Offset=-40 N", "Load cell/Drift=6 N/min",
                        "Load cell/Time constant=20 ms"});
  EXPECT_EQ(it.frame.gap_offset, -0.2e-3);
  EXPECT_DOUBLE_EQ(it.frame.thermal_drift, 3e-6 / 60.0);
  EXPECT_EQ(it.load_cell.gain, 0.98);
  EXPECT_EQ(it.load_cell.offset, -40.0);
  EXPECT_DOUBLE_EQ(it.load_cell.drift, 0.1);
  EXPECT_EQ(it.load_cell.lag, 20e-3);
}

TEST(EveryEntry, OfPlasticContactsReachesTheCase) {
  Case const yields = seed({"Contact/Preset=custom", "Contact/Normal law=thornton_ning",
                            "Contact/Cohesion law=sjkr2", "Contact/Tangential law=mindlin",
                            "Contact/Yield pressure=150 MPa"});
  EXPECT_EQ(yields.contacts.law.normal, "thornton_ning");
  EXPECT_EQ(yields.contacts.law.yield_pressure, 150e6);
  Case const adheres =
      seed({"Contact/Preset=custom", "Contact/Normal law=edinburgh", "Contact/Cohesion law=none",
            "Contact/Tangential law=mindlin", "Contact/Plasticity ratio=0.6",
            "Contact/Particle-particle/Cohesion energy density=0",
            "Contact/Particle-wall/Cohesion energy density=0",
            "Contact/Particle-particle/Surface energy=2 J/m^2"});
  EXPECT_EQ(adheres.contacts.law.plasticity_ratio, 0.6);
  EXPECT_EQ(adheres.contacts.grain_grain.surface_energy, 2.0);
}

TEST(EveryEntry, OfLawsAndStagesReachesTheCase) {
  Case const it = seed(laws_and_stages);
  expect_equal(it.contacts.law, {"hooke", "sjkr", "hooke_spring", "constant_torque", "elastic",
                                 false, true, 1.0, 0.0, 0.0, 5.0, 2e-6, 0.7, dem::Precision::full});
  expect_equal(it.contacts.grain_grain, {0.4, 0.3, 0.01, 2e5, 0.0});
  expect_equal(it.contacts.grain_wall, {0.6, 0.1, 0.02, 1e5, 0.0});
  EXPECT_EQ(it.tooling.walls, WallKind::analytic);
  ASSERT_EQ(it.stages.size(), 4u);
  expect_equal(it.stages[0], {.name = "approach",
                              .kind = StageKind::move,
                              .tools = {"upper_punch", "lower_punch"},
                              .speed = -1e-3 / 60.0,
                              .until = Limit::time,
                              .duration = 3.0});
  expect_equal(it.stages[1], {.name = "release",
                              .kind = StageKind::move,
                              .tools = {"upper_punch"},
                              .speed = -0.1,
                              .until = Limit::force,
                              .duration = 60.0,
                              .force = 25100.0});
  expect_equal(it.stages[2], {.name = "relaxation",
                              .kind = StageKind::hold,
                              .tools = {"upper_punch"},
                              .duration = 0.05,
                              .force = 1e4,
                              .servo = true});
  expect_equal(it.stages[3], {.name = "stage 12", .kind = StageKind::release, .tools = {"die"}});
}

TEST(EveryEntry, OfAPathReachesTheCase) {
  std::string const file = PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm"; // any that is there
  Case const it =
      seed({"Press programme/Stage 2/Kind=follow", "Press programme/Stage 2/Follow file=" + file,
            "Press programme/Stage 2/Time scale=1e-3"});
  Stage const& stage = it.stages.at(1);
  EXPECT_EQ(stage.kind, StageKind::follow);
  EXPECT_EQ(stage.tools, std::vector<std::string>{"upper_punch"});
  EXPECT_EQ(stage.follow_file, file);
  EXPECT_EQ(stage.time_scale, 1e-3);
  expect_equal(parse_case(it.resolved_text, "case.resolved.prm"), it);
}

TEST(EveryEntry, OfJkrReachesTheCase) {
  Case const it = seed({"Contact/Preset=custom", "Contact/Normal law=jkr",
                        "Contact/Cohesion law=none", "Contact/Tangential law=frictionless",
                        "Contact/Particle-particle/Surface energy=50 mJ/m^2",
                        "Contact/Particle-wall/Surface energy=0.02"});
  EXPECT_EQ(it.contacts.law.normal, "jkr");
  EXPECT_EQ(it.contacts.law.tangential, "frictionless");
  EXPECT_EQ(it.contacts.grain_grain.surface_energy, 0.05);
  EXPECT_EQ(it.contacts.grain_wall.surface_energy, 0.02);
  EXPECT_EQ(it.contacts.grain_grain.cohesion_energy_density, 0.0)
      << "nobody asked for the default of the seed";
}

TEST(ResolvedCase, IsReadBackToTheSameCase) {
  for (Overrides const& overrides : {Overrides{}, powder_and_tools, laws_and_stages}) {
    Case const it = seed(overrides);
    Case const again = parse_case(it.resolved_text, "case.resolved.prm");
    expect_equal(again, it);
    EXPECT_EQ(again.resolved_text, it.resolved_text);
  }
}

} // namespace
} // namespace coupling
