#include "coupling/case_file.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/case_setups.hpp"
#include "dem/expect.hpp"
#include "tests/unit/coupling/case_equality.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

namespace coupling {
namespace {

using Overrides = std::vector<std::string>;

Case seed(Overrides const& overrides = {}) {
  return parse_case("set Mode = rigid\n", "case.prm", overrides);
}

std::filesystem::path shipped(std::string const& name) {
  return std::filesystem::path(PRESSCHECK_SOURCE_DIR) / "cases" / name / "case.prm";
}

TEST(DefaultCase, IsTheSeedsPressCycle) {
  Case const it = seed();
  EXPECT_EQ(it.mode, "rigid");
  ASSERT_EQ(it.powder.components.size(), 2u);
  EXPECT_EQ(it.powder.total_mass, 9.13e-3);
  EXPECT_EQ(it.powder.fill_height, 20e-3);
  Component const& magnesia = it.powder.components[0];
  EXPECT_EQ(magnesia.material.name, "MgO");
  EXPECT_EQ(magnesia.mass_fraction, 0.8);
  EXPECT_EQ(magnesia.material.density, 3500.0);
  EXPECT_EQ(magnesia.material.young_modulus, 250e6);
  EXPECT_EQ(magnesia.material.poisson_ratio, 0.25);
  ASSERT_EQ(magnesia.sizes.size(), 4u);
  EXPECT_EQ(magnesia.sizes[3].diameter, 3e-3);
  EXPECT_EQ(magnesia.sizes[3].mass_fraction, 0.05);
  Component const& alumina = it.powder.components[1];
  EXPECT_EQ(alumina.material.name, "Al2O3");
  EXPECT_EQ(alumina.material.density, 3000.0);
  ASSERT_EQ(alumina.sizes.size(), 1u);
  EXPECT_EQ(alumina.sizes[0].diameter, 0.5e-3);
  EXPECT_EQ(it.contacts.law.normal, "hertz");
  EXPECT_EQ(it.contacts.law.cohesion, "sjkr2");
  EXPECT_EQ(it.contacts.law.tangential, "mindlin");
  EXPECT_EQ(it.contacts.law.rolling, "none");
  EXPECT_EQ(it.contacts.law.friction_limit, "net");
  EXPECT_EQ(it.contacts.grain_grain.cohesion_energy_density, 5e6);
  EXPECT_EQ(it.contacts.grain_wall.cohesion_energy_density, 0.0);
  EXPECT_EQ(it.contacts.grain_wall.static_friction, 0.2);
  EXPECT_EQ(it.tooling.bore_diameter, 22.05e-3);
  EXPECT_EQ(it.tooling.chordal_tolerance, 1e-5);
  EXPECT_EQ(it.tooling.material.young_modulus, 200e6);
  EXPECT_EQ(it.tooling.material.poisson_ratio, 0.29);
  EXPECT_EQ(it.time_stepping.rayleigh_fraction, 0.1);
  EXPECT_EQ(it.gravity, dem::Vec3(0.0, 0.0, -9.81));
}

TEST(DefaultCase, MovesDownSixHundredthsOfASecondUpFourReleasesAndWaits) {
  Case const it = seed();
  ASSERT_EQ(it.stages.size(), 4u);
  EXPECT_EQ(it.stages[0].kind, StageKind::move);
  EXPECT_EQ(it.stages[0].until, Limit::gap);
  // 20 mm - 0.2 m/s 0.06 s = 8 mm; 8 mm + 0.2 m/s 0.04 s = 16 mm
  EXPECT_NEAR((it.powder.fill_height - it.stages[0].gap) / -it.stages[0].speed, 0.06, 1e-15);
  EXPECT_NEAR((it.stages[1].gap - it.stages[0].gap) / it.stages[1].speed, 0.04, 1e-15);
  EXPECT_EQ(it.stages[2].kind, StageKind::release);
  EXPECT_EQ(it.stages[2].tools, (std::vector<std::string>{"die", "upper_punch"}));
  EXPECT_EQ(it.stages[3].kind, StageKind::free);
  EXPECT_EQ(it.stages[3].duration, 0.05);
}

TEST(DefaultCase, EqualsTheDefaultsOfTheStructs) {
  Case const it = seed();
  expect_equal(it.tooling, Tooling{});
  expect_equal(it.time_stepping, TimeStepping{});
  expect_equal(it.output, Output{});
  expect_equal(it.contacts.law, dem::ContactChoice{});
}

TEST(DefaultsListing, IsItselfTheDefaultCaseInBothFormats) {
  expect_equal(parse_case(describe_entries(DefaultsFormat::prm), "all.prm"), seed());
  expect_equal(parse_case(describe_entries(DefaultsFormat::json), "all.json"), seed());
}

TEST(DefaultsListing, NamesEveryEntryWithDefaultUnitRangeAndDescription) {
  std::string const prm = describe_entries(DefaultsFormat::prm);
  std::string const json = describe_entries(DefaultsFormat::json);
  for (Entry const& entry : case_schema()) {
    EXPECT_NE(prm.find("set " + entry.name() + " ="), std::string::npos) << entry.path;
    EXPECT_NE(prm.find(entry.description), std::string::npos) << entry.path;
    EXPECT_NE(json.find("\"" + entry.name() + "\""), std::string::npos) << entry.path;
  }
  EXPECT_NE(prm.find("  # Inner diameter of the die. Unit: m. Allowed: >= 0.0001 m, <= 0.5 m.\n"
                     "  set Bore diameter = 22.05 mm\n"),
            std::string::npos);
  EXPECT_NE(prm.find("    # set Gap = 0 mm\n"), std::string::npos)
      << "unused entries are commented out";
}

TEST(Presets, ChooseTheLawsOfTheSeedsTwoSimulators) {
  EXPECT_EQ(seed({"Contact/Preset=edem"}).contacts.law.cohesion, "linear_reduced");
  EXPECT_EQ(seed({"Contact/Preset=edem"}).contacts.law.normal, "hertz");
  EXPECT_EQ(seed({"Contact/Preset=liggghts", "Contact/Cohesion law=sjkr2"}).contacts.law.cohesion,
            "sjkr2");
  EXPECT_EQ(seed({"Contact/Friction limit=elastic"}).contacts.law.friction_limit, "elastic");
}

TEST(ResolvedCase, FindsTheFilesOfTheCaseFromAnyFolder) {
  Case const it = read_case(shipped("single-contact"));
  EXPECT_EQ(it.powder.fill_method, FillMethod::file);
  EXPECT_EQ(it.powder.fill_file,
            std::filesystem::path(PRESSCHECK_SOURCE_DIR) / "cases/single-contact/packing.csv");
  expect_equal(parse_case(it.resolved_text, "/elsewhere/case.resolved.prm"), it);
}

TEST(CaseFormats, PrmAndJsonOfTheSameCaseAreEqual) {
  Case const prm =
      parse_case("\xef\xbb\xbf# comment\r\nSUBSECTION Powder\r\n set Total mass = \\\n 5 g # half\n"
                 "\tsubsection Component 2\n set Name =\n END\n subsection Component 1\n"
                 "set Mass fraction=100 %\nend\nend\nset Title = it's a title = good\n",
                 "a.prm");
  Case const json = parse_case(
      R"({"Title": "it's a title = good", "Powder": {"Total mass": {"value": "5 g", "unit": "kg"},
                                  "Component 2": {"Name": ""}, "Component 1/Mass fraction": 1}})",
      "a.json");
  EXPECT_EQ(prm.powder.total_mass, 5e-3);
  EXPECT_EQ(prm.title, "it's a title = good");
  expect_equal(json, prm);
}

TEST(Overrides, WinOverTheFileAndKeepSpacesAndColons) {
  Case const it = parse_case("subsection Powder\nset Total mass = 5 g\nend\n", "case.prm",
                             Overrides{" Powder/Total mass = 6 g ",
                                       "Powder/Component 2/Size classes=0.6 mm: 100 %",
                                       "Powder/Total mass=7 g"});
  EXPECT_EQ(it.powder.total_mass, 7e-3) << "the last one wins";
  EXPECT_EQ(it.powder.components[1].sizes[0].diameter, 0.6e-3);
}

TEST(ShippedCases, AreValidAndReadBack) {
  for (char const* name : {"quick", "single-contact", "seed-mgo-alumina"}) {
    Case const it = read_case(shipped(name));
    expect_equal(parse_case(it.resolved_text, "case.resolved.prm"), it);
  }
}

TEST(ShippedCases, SeedCaseIsTheDefaultPress) {
  Case it = read_case(shipped("seed-mgo-alumina"));
  it.title = seed().title;
  expect_equal(it, seed());
}

TEST(Setups, ScaleEveryModulusAndNameCohesionAndSize) {
  std::filesystem::path const file = shipped("seed-mgo-alumina");
  Case const it = read_case(file, setup_overrides(file, "E2322_CED7_D250"));
  EXPECT_EQ(it.powder.components[0].material.young_modulus, 2322e6);
  EXPECT_EQ(it.powder.components[1].material.young_modulus, 2322e6);
  EXPECT_DOUBLE_EQ(it.tooling.material.young_modulus, 0.8 * 2322e6);
  EXPECT_EQ(it.contacts.grain_grain.cohesion_energy_density, 7e6);
  EXPECT_EQ(it.powder.components[1].sizes[0].diameter, 0.25e-3);
  EXPECT_EQ(it.contacts.law.cohesion, "sjkr2");
}

TEST(Setups, OfThePaperAreAllThereAndValid) {
  std::filesystem::path const file = shipped("seed-mgo-alumina");
  std::vector<std::string> const names = setup_names(file);
  // 15 of table 3, 9 of table 4 of which two are in table 3 too (E1375_CED3_D300, E2500_CED5_D300),
  // 8 of table 5
  EXPECT_EQ(names.size(), 15u + 9u - 2u + 8u);
  for (std::string const& name : names) {
    Case const it = read_case(file, setup_overrides(file, name));
    char rebuilt[32];
    std::snprintf(rebuilt, sizeof rebuilt, "E%04.0f_CED%.0f_D%.0f",
                  it.powder.components[0].material.young_modulus / 1e6,
                  it.contacts.grain_grain.cohesion_energy_density / 1e6,
                  it.powder.components[1].sizes[0].diameter * 1e6);
    EXPECT_EQ(name, rebuilt);
    EXPECT_DOUBLE_EQ(it.tooling.material.young_modulus,
                     0.8 * it.powder.components[0].material.young_modulus);
  }
}

} // namespace
} // namespace coupling
