// The named cause as entries of the case: each changes exactly its own, and they read back.
#include "coupling/finding/extended_case.hpp"

#include "coupling/case_file.hpp"
#include "coupling/finding/cause_words.hpp"
#include "tests/support/sample_finding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace coupling::finding {
namespace {

using Values = std::map<std::string, std::string>;

Case seed(std::vector<std::string> const& overrides = {}) {
  return parse_case("set Mode = rigid\n", "case.prm", overrides);
}

FoundCause cause(std::string name, double size, std::string unit) {
  return {.name = std::move(name),
          .probability = 0.95,
          .log_evidence = 50.0,
          .plausibility = "plausible",
          .parameters = {{"size", size, 0.9 * size, 1.1 * size, std::move(unit)}}};
}

Values values_of(std::string const& prm) {
  Values values;
  for (auto const& one : scan_prm(prm, "case.prm"))
    values[one.path] = one.text;
  return values;
}

/// Paths whose values the extended text has otherwise than the case.
std::set<std::string> changed(Case const& setup, ExtendedCase const& extended) {
  auto const before = values_of(setup.resolved_text);
  std::set<std::string> paths;
  for (auto const& [path, text] : values_of(extended.text))
    if (!before.contains(path) || before.at(path) != text)
      paths.insert(path);
  return paths;
}

Case read_back(ExtendedCase const& extended) {
  return parse_case(extended.text, "extended.prm");
}

struct Expected {
  FoundCause cause;
  std::set<std::string> paths;
  double (*value)(Case const&);
  double wanted;
};

// A case with something in every place, so that an entry that is set instead of changed shows.
std::vector<std::string> const worn_machine = {"Press frame/Stiffness=1e8 N/m",
                                               "Press frame/Gap offset=0.02 mm",
                                               "Press frame/Thermal drift=1e-7 m/s",
                                               "Load cell/Gain=1.01",
                                               "Load cell/Offset=20 N",
                                               "Load cell/Time constant=0.1 s"};

std::string const wall = "Contact/Particle-wall/Coefficient of static friction";
std::string const grain = "Contact/Particle-particle/Coefficient of static friction";

std::vector<Expected> const each = {
    // 1 / (1e-8 + 1.5e-8)
    {cause("frame_compliance", 1.5e-8, "m/N"),
     {"Press frame/Stiffness"},
     [](Case const& c) { return c.frame.stiffness; },
     4e7},
    {cause("gap_offset", 1e-4, "m"),
     {"Press frame/Gap offset"},
     [](Case const& c) { return c.frame.gap_offset; },
     1.2e-4},
    {cause("thermal_drift", -3e-7, "m/s"),
     {"Press frame/Thermal drift"},
     [](Case const& c) { return c.frame.thermal_drift; },
     -2e-7},
    {cause("force_gain", -0.04, "1"),
     {"Load cell/Gain"},
     [](Case const& c) { return c.load_cell.gain; },
     1.01 * 0.96},
    {cause("force_offset", 100.0, "N"),
     {"Load cell/Offset"},
     [](Case const& c) { return c.load_cell.offset; },
     120.0},
    {cause("force_lag", 1.5, "s"),
     {"Load cell/Time constant"},
     [](Case const& c) { return c.load_cell.lag; },
     1.6},
    {cause("mass_error", 0.015, "1"),
     {"Powder/Total mass"},
     [](Case const& c) { return c.powder.total_mass; },
     9.13e-3 * 1.015},
    {cause("die_size", 8e-5, "m"),
     {"Tooling/Bore diameter"},
     [](Case const& c) { return c.tooling.bore_diameter; },
     22.13e-3},
    {cause("wall_friction", 0.06, "1"),
     {wall},
     [](Case const& c) { return c.contacts.grain_wall.static_friction; },
     0.26},
    {cause("particle_friction", -0.06, "1"),
     {grain},
     [](Case const& c) { return c.contacts.grain_grain.static_friction; },
     0.14},
    {cause("young_modulus", 0.1, "1"),
     {"Powder/Component 1/Young's modulus", "Powder/Component 2/Young's modulus"},
     [](Case const& c) { return c.powder.components[1].material.young_modulus; },
     275e6},
    {cause("cohesion", -0.5, "1"),
     {"Contact/Particle-particle/Cohesion energy density"},
     [](Case const& c) { return c.contacts.grain_grain.cohesion_energy_density; },
     2.5e6},
};

TEST(ExtendedCase, EachCauseChangesItsEntriesAndNothingElse) {
  Case const setup = seed(worn_machine);
  for (auto const& one : each) {
    auto const extended = extended_case(setup, {one.cause});
    EXPECT_TRUE(extended.not_modelled.empty()) << one.cause.name;
    EXPECT_EQ(changed(setup, extended), one.paths) << one.cause.name;
    EXPECT_EQ(extended.changes.size(), one.paths.size()) << one.cause.name;
    EXPECT_NEAR(one.value(read_back(extended)), one.wanted, 1e-12 * std::abs(one.wanted))
        << one.cause.name;
  }
}

TEST(ExtendedCase, ARigidFrameGetsTheStiffnessOfTheCauseAlone) {
  auto const extended = extended_case(seed(), {cause("frame_compliance", 2e-8, "m/N")});
  EXPECT_NEAR(read_back(extended).frame.stiffness, 5e7, 1e-6);
}

TEST(ExtendedCase, YieldPressureTakesItsShareOfHertzForce) {
  Case const setup = seed({"Contact/Particle-particle/Cohesion energy density=1e6 J/m^3"});
  auto const extended =
      extended_case(setup, {cause("plastic_contacts", 0.3, "1")}, {}, {.relative_overlap = 0.2});
  ASSERT_TRUE(extended.not_modelled.empty()) << extended.not_modelled[0];
  EXPECT_EQ(changed(setup, extended), (std::set<std::string>{"Contact/Preset", "Contact/Normal law",
                                                             "Contact/Yield pressure"}));
  Case const read = read_back(extended);
  EXPECT_EQ(read.contacts.law.normal, "thornton_ning");
  EXPECT_EQ(read.contacts.law.cohesion, setup.contacts.law.cohesion);
  // The law itself, in forces, at R* = 1: Hertz to d_y, then a straight line of slope pi p_y R*.
  double const E = 0.5 * 250e6 / (1.0 - 0.25 * 0.25), p = read.contacts.law.yield_pressure;
  double const d = 0.2, d_y = std::pow(std::numbers::pi * p / (2.0 * E), 2);
  double const hertz = 4.0 / 3.0 * E * std::pow(d, 1.5);
  double const yielding = 4.0 / 3.0 * E * std::pow(d_y, 1.5) + std::numbers::pi * p * (d - d_y);
  EXPECT_LT(d_y, d);
  EXPECT_NEAR(1.0 - yielding / hertz, 0.3, 1e-9);
  // Without the overlap there is a sentence and no guess.
  auto const none = extended_case(setup, {cause("plastic_contacts", 0.3, "1")});
  EXPECT_TRUE(none.changes.empty());
  EXPECT_NE(none.not_modelled.at(0).find("overlap of the contacts"), std::string::npos);
}

TEST(ExtendedCase, ViscousTimeGivesTheExponentOfSpeed) {
  Case const setup = seed();
  auto const extended =
      extended_case(setup, {cause("rate_dependence", 0.02, "1")}, {}, {.growth_time = 4e-3});
  EXPECT_EQ(changed(setup, extended), std::set<std::string>{"Contact/Viscous time"});
  // F (1 + A / T): 2 % of the force at the case's own speed, T = F / (dF/dt).
  EXPECT_NEAR(read_back(extended).contacts.law.viscous_time, 8e-5, 1e-18);
}

TEST(ExtendedCase, TheDieWidensAsMeasured) {
  Case const setup = seed();
  auto const extended = extended_case(setup, {cause("die_compliance", 5e-13, "m/Pa")});
  ASSERT_TRUE(extended.not_modelled.empty()) << extended.not_modelled[0];
  Case const read = read_back(extended);
  EXPECT_EQ(read.mode, "two_way_secant");
  // Lame: widening of the bore D under p,  D p / E ((r_o^2 + r_i^2) / (r_o^2 - r_i^2) + nu).
  double const r = 11.025e-3, R = 21.025e-3, E = read.elastic.material.young_modulus;
  double const widening = 2.0 * r / E * ((R * R + r * r) / (R * R - r * r) + 0.3);
  EXPECT_NEAR(widening, 5e-13, 1e-22);
}

TEST(ExtendedCase, TiltsThePunchAndLetsContactsStiffenEachOther) {
  auto const extended =
      extended_case(seed(), {cause("punch_tilt", 4e-4, "m"), cause("multi_contact", 0.5, "1")});
  ASSERT_TRUE(extended.not_modelled.empty()) << extended.not_modelled[0];
  EXPECT_NEAR(read_back(extended).tooling.punch_tilt, 4e-4, 1e-12);
  EXPECT_NEAR(read_back(extended).contacts.law.multi_contact, 0.15, 1e-12);
}

// Entries of which only a simulation tells how far they go: by a guess, or by what was shown.
TEST(ExtendedCase, AddsFinesThatAreFinerThanTheCase) {
  auto const extended = extended_case(seed(), {cause("missing_fines", 0.02, "1")});
  ASSERT_TRUE(extended.not_modelled.empty()) << extended.not_modelled[0];
  auto const fines = read_back(extended).powder.fines;
  EXPECT_NEAR(fines.share, 0.2, 1e-12);
  EXPECT_NEAR(fines.diameter, 0.75 * 0.5e-3, 1e-12) << "the seed's finest grains have 0.5 mm";
  EXPECT_NE(extended.text.find("a first guess, which no simulation has tried"), std::string::npos);
  // A case that has fines gets more of them, or fewer.
  auto const own = seed({"Powder/Added fines/Share=0.1", "Powder/Added fines/Diameter=0.2 mm"});
  BedFacts const shown{.doses = {{"missing_fines", {0.04, "by 2 simulations"}}}};
  auto const more = extended_case(own, {cause("missing_fines", 0.02, "1")}, {}, shown);
  EXPECT_NEAR(read_back(more).powder.fines.share, 0.14, 1e-12);
  EXPECT_EQ(read_back(more).powder.fines.diameter, 0.2e-3);
  EXPECT_NE(more.text.find("; by 2 simulations; before: 0.1"), std::string::npos) << more.text;
  auto const fewer = extended_case(own, {cause("missing_fines", -0.02, "1")}, {}, shown);
  EXPECT_NEAR(read_back(fewer).powder.fines.share, 0.06, 1e-12);
}

TEST(ExtendedCase, BreaksGrainsByTheStressOnTheBed) {
  auto const extended =
      extended_case(seed(), {cause("breakage", 0.01, "1")}, {},
                    {.largest_stress = 10e6, .doses = {{"breakage", {32.0, "shown"}}}});
  ASSERT_TRUE(extended.not_modelled.empty()) << extended.not_modelled[0];
  auto const law = read_back(extended).breakage;
  // 0.75 s 32^(-1/5), m = 5; the coarsest class is the reference, pieces of the finest stay.
  EXPECT_NEAR(law.strength, 0.5 * 0.75 * 10e6, 1.0);
  EXPECT_NEAR(law.reference_diameter, 3e-3, 1e-12);
  EXPECT_NEAR(law.smallest_diameter, 0.45e-3, 1e-12);
  // Where grains break already, it adds to that: sigma^-5 = own^-5 + 32 (7.5 MPa)^-5.
  auto const weaker =
      extended_case(seed({"Breakage/Strength=3.75 MPa", "Breakage/Smallest diameter=1 mm"}),
                    {cause("breakage", 0.01, "1")}, {},
                    {.largest_stress = 10e6, .doses = {{"breakage", {32.0, "shown"}}}});
  EXPECT_NEAR(read_back(weaker).breakage.strength, 3.75e6 * std::pow(2.0, -0.2), 1.0);
  EXPECT_EQ(read_back(weaker).breakage.smallest_diameter, 1e-3) << "its own stays";
}

TEST(ExtendedCase, FillsTheDieMoreDensely) {
  Case const setup = seed({"Powder/Settle time=20 ms", "Powder/Fill state=0.2"});
  auto const state = [&](double size) {
    return read_back(extended_case(setup, {cause("fill_state", size, "1")})).powder.fill_state;
  };
  EXPECT_NEAR(state(0.003), 0.5, 1e-12);
  EXPECT_NEAR(state(0.03), 1.0, 1e-12) << "no more than all";
  EXPECT_NEAR(state(-0.001), 0.1, 1e-12);
  EXPECT_NEAR(state(-0.03), 0.0, 1e-12);
}

TEST(ExtendedCase, SaysWhatItCannotModel) {
  for (auto const& [name, size, why] :
       {std::tuple("breakage", 0.01, "largest stress"),
        std::tuple("missing_fines", -0.01, "coarser"), std::tuple("fill_state", -0.01, "looser"),
        std::tuple("fill_state", 0.01, "Settle time"), std::tuple("gremlins", 0.01, "no entry")}) {
    auto const extended = extended_case(seed(), {cause(name, size, "1")});
    EXPECT_TRUE(extended.changes.empty()) << name;
    ASSERT_EQ(extended.not_modelled.size(), 1u) << name;
    EXPECT_NE(extended.not_modelled[0].find(name), std::string::npos);
    EXPECT_NE(extended.not_modelled[0].find(why), std::string::npos) << extended.not_modelled[0];
    // The text says so, and is the case all the same.
    EXPECT_NE(extended.text.find("# " + extended.not_modelled[0]), std::string::npos);
    EXPECT_EQ(values_of(extended.text), values_of(seed().resolved_text));
  }
}

TEST(ExtendedCase, LeavesOutWhatTheCaseRefuses) {
  auto const extended =
      extended_case(seed(), {cause("wall_friction", -0.3, "1"), cause("gap_offset", 1e-4, "m")});
  ASSERT_EQ(extended.not_modelled.size(), 1u);
  EXPECT_NE(extended.not_modelled[0].find("static friction = -0."), std::string::npos)
      << extended.not_modelled[0];
  EXPECT_EQ(extended.changes.size(), 1u);
  EXPECT_EQ(read_back(extended).frame.gap_offset, 1e-4);
}

TEST(ExtendedCase, CalibratedValuesComeFirstAndOnce) {
  CalibratedValue const modulus{.name = "young_modulus",
                                .value = 300e6,
                                .sd = 3e6,
                                .sheet = 250e6,
                                .sheet_sd = 0.1,
                                .unit = "Pa",
                                .is_logarithmic = true};
  CalibratedValue const cohesion{.name = "cohesion_energy_density",
                                 .value = 3e6,
                                 .sd = 1e5,
                                 .sheet = 5e6,
                                 .sheet_sd = 1e6,
                                 .unit = "J/m^3"};
  auto as_cause = cause("young_modulus", 0.2, "1");
  as_cause.is_calibrated = true;
  Case const setup = seed({"Powder/Component 2/Young's modulus=500 MPa"});
  auto const extended = extended_case(setup, {as_cause}, {modulus, cohesion});
  Case const read = read_back(extended);
  EXPECT_NEAR(read.powder.components[0].material.young_modulus, 300e6, 1e-3);
  EXPECT_NEAR(read.powder.components[1].material.young_modulus, 600e6, 1e-3) << "their ratio stays";
  EXPECT_EQ(read.contacts.grain_grain.cohesion_energy_density, 3e6);
  EXPECT_EQ(extended.changes.size(), 3u);
}

TEST(ExtendedCase, WritesTheReasonAboveEachEntry) {
  auto const extended = extended_case(seed(worn_machine), {each[0].cause});
  EXPECT_NE(extended.text.find("  # frame_compliance = 15 µm/kN, 95 %: 13.5 µm/kN to 16.5 µm/kN; "
                               "before: 100000000 N/m\n  set Stiffness = 40000000 N/m\n"),
            std::string::npos)
      << extended.text;
}

TEST(ExtendedCase, OnlyANamedCauseIsModelled) {
  auto finding = sample::named();
  finding.calibrated.clear();
  finding.provenance.data_folder = "hostile\nset Mode = two_way_secant\\";
  auto const named = extended_case(seed(), finding);
  EXPECT_NEAR(read_back(named).frame.stiffness, 1.0 / 18e-9, 1.0);
  EXPECT_EQ(read_back(named).mode, "rigid");
  EXPECT_EQ(named.changes.size(), 1u) << "the lag is in the list, and not named";
  auto undecided = sample::undecided();
  undecided.calibrated.clear();
  auto const none = extended_case(seed(), undecided);
  EXPECT_TRUE(none.changes.empty());
  EXPECT_NE(none.text.find("cannot tell which"), std::string::npos);
}

} // namespace
} // namespace coupling::finding
