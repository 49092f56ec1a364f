#include "coupling/case_file.hpp"

#include "dem/expect.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// What a case says may be wrong in itself or against the rest of the case: each refusal by its
// whole message.
namespace coupling {
namespace {

/// The message with which a case with these overrides is refused, without the place `--set: `.
std::string refusal(std::vector<std::string> const& overrides) {
  try {
    parse_case("set Mode = rigid\n", "case.prm", overrides);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    std::string const message = problem.what();
    return message.starts_with("--set: ") ? message.substr(7) : message;
  }
}

TEST(Units, OfAnotherDimensionAreRefused) {
  EXPECT_EQ(refusal({"Powder/Total mass=9.13 mm"}),
            "Powder/Total mass = 9.13 mm: has a unit that does not fit (a mass is needed). Write "
            "it in kg, g, mg?");
  EXPECT_EQ(refusal({"Powder/Component 2/Size classes=0.5 g: 100 %"}),
            "Powder/Component 2/Size classes = 0.5 g: 100 %: in class '0.5 g: 100 %': has a unit "
            "that does not fit (a "
            "length is needed). Write it in m, mm, um?");
}

TEST(Units, ThatWereForgottenAreSuspected) {
  EXPECT_EQ(refusal({"Powder/Component 1/Young's modulus=250 Pa"}),
            "Powder/Component 1/Young's modulus = 250 Pa: is outside the allowed range (>= 100000 "
            "Pa, <= 2000000000000 "
            "Pa). Did you mean 250 MPa?");
  EXPECT_EQ(refusal({"Tooling/Bore diameter=22.05"}),
            "Tooling/Bore diameter = 22.05: is outside the allowed range (>= 0.0001 m, <= 0.5 m). "
            "Did you mean 22.05 mm?");
  EXPECT_EQ(refusal({"Tooling/Bore diameter=22.05 um"}),
            "Tooling/Bore diameter = 22.05 um: is outside the allowed range (>= 0.0001 m, <= 0.5 "
            "m). Did you mean 22.05 mm?");
  EXPECT_EQ(refusal({"Powder/Component 2/Size classes=0.5: 100 %"}),
            "Powder/Component 2/Size classes = 0.5: 100 %: has a diameter 0.5 outside the allowed "
            "range (> 0 m, <= 0.1 m). "
            "Did you mean mm?");
  EXPECT_EQ(refusal({"Powder/Component 2/Size classes=0.5 mm: 100"}),
            "Powder/Component 2/Size classes = 0.5 mm: 100: has a share 100 that is not above 0 "
            "and up to 100 %. Is the "
            "percent sign missing?");
}

TEST(Values, OutOfRangeAreRefused) {
  EXPECT_EQ(refusal({"Contact/Particle-wall/Coefficient of restitution=0"}),
            "Contact/Particle-wall/Coefficient of restitution = 0: is outside the allowed range (> "
            "0, <= 1). Choose a "
            "value inside it?");
  EXPECT_EQ(refusal({"Contact/Particle-particle/Coefficient of restitution=1.01"}),
            "Contact/Particle-particle/Coefficient of restitution = 1.01: is outside the allowed "
            "range (> 0, <= 1). Choose "
            "a value inside it?");
  EXPECT_EQ(refusal({"Powder/Component 1/Poisson's ratio=0.5"}),
            "Powder/Component 1/Poisson's ratio = 0.5: is outside the allowed range (> -1, < 0.5). "
            "Choose a value inside it?");
  EXPECT_EQ(refusal({"Powder/Total mass=-9 g"}),
            "Powder/Total mass = -9 g: is outside the allowed range (>= 1e-12 kg, <= 1000 kg). "
            "Choose a value inside it?");
  EXPECT_EQ(refusal({"Time stepping/Rayleigh fraction=nan"}),
            "Time stepping/Rayleigh fraction = nan: is no finite number (a ratio is needed). Give "
            "it a value?");
  EXPECT_EQ(refusal({"Powder/Packing seed=-1"}),
            "Powder/Packing seed = -1: is no whole number in the allowed range (>= 0, <= "
            "9000000000000000). Write one such "
            "as 1?");
  EXPECT_EQ(refusal({"Time stepping/Adaptive=maybe"}),
            "Time stepping/Adaptive = maybe: is neither true nor false. Write one of them?");
  EXPECT_EQ(refusal({"Tooling/Walls=surfaces"}), "Tooling/Walls = surfaces: is none of the choices "
                                                 "(surface | analytic). Did you mean 'surface'?");
  EXPECT_EQ(refusal({"Title=" + std::string(201, 'x')}),
            "Title = " + std::string(80, 'x') + "...: is longer than 200 bytes. Shorten it?");
}

TEST(Mode, OfAnotherNameIsRefused) {
  EXPECT_EQ(refusal({"Mode=two_way_implicit"}), "accepted");
  EXPECT_EQ(refusal({"Mode=oneway"}), "Mode = oneway: is none of the choices (rigid | one_way | "
                                      "two_way_explicit | two_way_secant | two_way_implicit). "
                                      "Did you mean 'one_way'?");
}

TEST(Shares, ThatDoNotMakeAWholeAreRefused) {
  EXPECT_EQ(refusal({"Powder/Component 1/Mass fraction=90 %"}),
            "case.prm: Powder/Component 2/Mass fraction = 20 % (default): makes the mass fractions "
            "sum to 110 % (all of the "
            "powder is 100 %). Change one?");
  EXPECT_EQ(refusal({"Powder/Component 1/Size classes=0.5 mm: 35 %, 1 mm: 60 %"}),
            "Powder/Component 1/Size classes = 0.5 mm: 35 %, 1 mm: 60 %: has shares that sum to 95 "
            "% (all of the component "
            "is 100 %). Change one?");
  EXPECT_EQ(refusal({"Powder/Component 3/Name=silica"}),
            "case.prm: Powder/Component 3/Mass fraction = 0 % (default): leaves a named component "
            "without mass. Empty its "
            "Name?");
  EXPECT_EQ(refusal({"Powder/Component 1/Name=", "Powder/Component 2/Name="}),
            "Powder/Component 1/Name = : leaves the powder without a component. Name one?");
  EXPECT_EQ(refusal({"Powder/Component 1/Size classes="}),
            "Powder/Component 1/Size classes = : holds no size class (a component has at least "
            "one). Write 0.5 mm: 100 %?");
  EXPECT_EQ(refusal({"Powder/Component 1/Size classes=0.5 mm"}),
            "Powder/Component 1/Size classes = 0.5 mm: has a class '0.5 mm' without a share (a "
            "class is DIAMETER: SHARE). "
            "Write 0.5 mm: 100 %?");
}

TEST(Powder, ThatCannotFitTheDieIsRefused) {
  // 20 g: (16 g / 3500 + 4 g / 3000) / (pi/4 22.05^2 20 mm^3) = 5.905 cm^3 / 7.637 cm^3 = 77.3 %;
  // at 40 % the cylinder is 5.905 / (0.4 pi/4 2.205^2) = 3.866 cm high
  EXPECT_EQ(refusal({"Powder/Total mass=20 g"}),
            "Powder/Total mass = 20 g: fills 77.3 % of the cylinder with solid (random filling "
            "reaches about 40 %). Fill "
            "height and Die height = 39 mm?");
  EXPECT_EQ(
      refusal({"Powder/Total mass=20 g", "Powder/Fill height=39 mm", "Tooling/Die height=39 mm"}),
      "accepted");
  EXPECT_EQ(refusal({"Powder/Fill height=21 mm"}),
            "Powder/Fill height = 21 mm: is above the die (Tooling/Die height = 20 mm). Make the "
            "die as high?");
  EXPECT_EQ(refusal({"Powder/Component 2/Size classes=23 mm: 100 %"}),
            "Powder/Component 2/Size classes = 23 mm: 100 %: has grains of 23 mm that do not fit "
            "(bore 22.1 mm, fill height "
            "20 mm). Is the unit right?");
}

TEST(Powder, WithoutAWholeGrainOrWithTooManyIsRefused) {
  // 3 mm MgO: 3500 kg/m^3 pi/6 (3 mm)^3 = 49.48 mg; 0.1 g 0.8 0.05 = 4 mg
  EXPECT_EQ(
      refusal({"Powder/Total mass=0.1 g"}),
      "case.prm: Powder/Component 1/Size classes = 0.5 mm: 70 %, 1 mm: 10 %, 2 mm: 15 %, 3 mm: 5 "
      "% (default): asks "
      "for 0.0808 grains of 3 mm (one weighs 49.5 mg). Raise the total mass or drop the class?");
  // 1.826 g / (3000 kg/m^3 pi/6 (1 um)^3) = 1.16e12
  EXPECT_EQ(refusal({"Powder/Component 2/Size classes=1 um: 100 %"}),
            "Powder/Component 2/Size classes = 1 um: 100 %: asks for 1.16e+12 grains (limit "
            "5e+07). Is the unit right?");
}

TEST(Powder, FromAFileThatIsNotThereIsRefused) {
  std::string const message = refusal({"Powder/Fill method=file", "Powder/Fill file=no/such.csv"});
  EXPECT_TRUE(message.starts_with("Powder/Fill file = no/such.csv: does not exist (looked for /"))
      << message;
  EXPECT_TRUE(message.ends_with("/no/such.csv; paths start at the case file). Is it misspelt?"))
      << message;
  EXPECT_EQ(refusal({"Powder/Fill file=grains.csv"}),
            "Powder/Fill file = grains.csv: is not used (Fill method = random makes its own "
            "packing). Remove it?");
  EXPECT_EQ(refusal({"Powder/Fill method=file"}),
            "case.prm: Powder/Fill file =  (default): names no file (Fill method = file reads "
            "one). Name it?");
}

TEST(AddedFines, ThatAddNothingOrAreNotFineAreRefused) {
  std::string const share = "Powder/Added fines/Share=5 %";
  EXPECT_EQ(refusal({share}), "case.prm: Powder/Added fines/Diameter = 0 mm (default): leaves the "
                              "added fines without a size. Give them one?");
  EXPECT_EQ(refusal({share, "Powder/Added fines/Diameter=0.5 mm"}),
            "Powder/Added fines/Diameter = 0.5 mm: is not finer than 0.5 mm, a size class of MgO. "
            "Choose a smaller one?");
  EXPECT_EQ(refusal({share, "Powder/Added fines/Diameter=0.2 mm"}), "accepted");
  EXPECT_EQ(refusal({"Powder/Added fines/Diameter=0.2 mm"}),
            "Powder/Added fines/Diameter = 0.2 mm: is not used (Added fines/Share = 0). Remove "
            "it?");
  // 9.13 g 0.8 0.05 / (3500 kg/m^3 pi/6 (1 um)^3) = 1.99e11
  EXPECT_EQ(refusal({share, "Powder/Added fines/Diameter=1 um"}),
            "Powder/Added fines/Diameter = 1 um: asks for 1.99e+11 grains (limit 5e+07). Is the "
            "unit right?");
  EXPECT_EQ(refusal({"Powder/Fill method=file",
                     "Powder/Fill file=" PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm", share}),
            "Powder/Added fines/Share = 5 %: is not used (Fill method = file brings its own "
            "grains). Remove it?");
}

TEST(Breakage, WithoutStrengthIsNotUsed) {
  EXPECT_EQ(refusal({"Breakage/Weibull modulus=3"}),
            "Breakage/Weibull modulus = 3: is not used (Breakage/Strength = 0: grains do not "
            "break). Remove it?");
  EXPECT_EQ(refusal({"Breakage/Weibull modulus=3", "Breakage/Strength=30 MPa"}), "accepted");
}

TEST(FillState, WithoutTimeToSettleIsRefused) {
  EXPECT_EQ(refusal({"Powder/Fill state=0.5"}),
            "Powder/Fill state = 0.5: changes nothing (Settle time = 0 leaves the grains where "
            "they were put). Give them time to settle?");
  EXPECT_EQ(refusal({"Powder/Fill state=0.5", "Powder/Settle time=50 ms"}), "accepted");
}

TEST(Tooling, FilesThatAreMissingOrUnusedAreRefused) {
  std::string const message = refusal({"Tooling/Die file=die.stl"});
  EXPECT_TRUE(message.starts_with("Tooling/Die file = die.stl: does not exist")) << message;
  EXPECT_EQ(refusal({"Tooling/Chordal tolerance=2 mm"}),
            "Tooling/Chordal tolerance = 2 mm: is too coarse for the bore (22.1 mm). Take less "
            "than a twentieth of it?");
}

TEST(Tooling, ThatCannotTiltIsRefused) {
  EXPECT_EQ(refusal({"Tooling/Punch tilt=0.3 mm"}), "accepted");
  EXPECT_EQ(refusal({"Mode=two_way_secant", "Tooling/Punch tilt=0.3 mm"}),
            "Tooling/Punch tilt = 0.3 mm: is for rigid tools (the bodies of Mode = two_way_secant "
            "stand upright). Set Mode = rigid?");
  EXPECT_EQ(refusal({"Tooling/Punch tilt=8 mm", "Press programme/Stage 1/Gap=4 mm"}),
            "Tooling/Punch tilt = 8 mm: brings the low side of the upper punch onto the lower one "
            "(at the end of stage 'loading' the gap is 4 mm). Tilt it less?");
}

TEST(Preset, AndALawThatContradictsItAreRefused) {
  EXPECT_EQ(refusal({"Contact/Cohesion law=sjkr"}),
            "Contact/Cohesion law = sjkr: contradicts Contact/Preset = liggghts (its law is "
            "sjkr2). Set Contact/Preset = "
            "custom?");
  EXPECT_EQ(refusal({"Contact/Preset=custom"}),
            "case.prm: Contact/Normal law = preset (default): names no law (Contact/Preset = "
            "custom leaves the choice to the "
            "case). Name one?");
  EXPECT_EQ(refusal({"Contact/Preset=custom", "Contact/Normal law=jkr", "Contact/Cohesion law=sjkr",
                     "Contact/Tangential law=mindlin"}),
            "Contact/Cohesion law = sjkr: doubles the adhesion of Contact/Normal law = jkr. Set "
            "Cohesion law = none?");
}

TEST(PlasticContacts, WithoutStrengthOrOfAnotherLawAreRefused) {
  std::vector<std::string> yields{"Contact/Preset=custom", "Contact/Normal law=thornton_ning",
                                  "Contact/Cohesion law=sjkr2", "Contact/Tangential law=mindlin"};
  auto const with = [&](std::string const& entry) {
    auto all = yields;
    all.push_back(entry);
    return refusal(all);
  };
  EXPECT_EQ(refusal(yields),
            "case.prm: Contact/Yield pressure = 0 Pa (default): leaves Contact/Normal law = "
            "thornton_ning without strength. About 2.8 times the yield stress?");
  // 4 pi k / pi with k = 5e6 J/m^3
  EXPECT_EQ(with("Contact/Yield pressure=20 MPa"),
            "Contact/Yield pressure = 20 MPa: does not hold the cohesion of sjkr2 (5e+06 J/m^3), "
            "which needs more than 20 MPa. A stronger grain, or less cohesion?");
  EXPECT_EQ(with("Contact/Yield pressure=20.1 MPa"), "accepted");
  EXPECT_EQ(refusal({"Contact/Yield pressure=20 MPa"}),
            "Contact/Yield pressure = 20 MPa: is not used (Contact/Normal law = hertz; "
            "thornton_ning uses it). Remove it?");
  EXPECT_EQ(refusal({"Contact/Plasticity ratio=0.5"}),
            "Contact/Plasticity ratio = 0.5: is not used (Contact/Normal law = hertz; edinburgh "
            "uses it). Remove it?");
}

TEST(Coefficients, ThatNoLawUsesAreRefused) {
  EXPECT_EQ(refusal({"Contact/Particle-particle/Coefficient of rolling friction=0.1"}),
            "Contact/Particle-particle/Coefficient of rolling friction = 0.1: is not used "
            "(Contact/Rolling law = none). "
            "Remove it?");
  EXPECT_EQ(refusal({"Contact/Particle-wall/Surface energy=0.1"}),
            "Contact/Particle-wall/Surface energy = 0.1: is not used (Contact/Normal law = hertz; "
            "jkr and edinburgh use it). Remove it?");
  EXPECT_EQ(refusal({"Contact/Particle-wall/Surface energy=0 J/m^2"}), "accepted");
  // (3 pi k / E*)^2 with E* = 250 MPa / (2 (1 - 0.25^2)) = 133.3 MPa and k = 5e7: (3.534)^2 = 12.5
  EXPECT_EQ(refusal({"Contact/Particle-particle/Cohesion energy density=5e7 J/m^3"}),
            "Contact/Particle-particle/Cohesion energy density = 5e7 J/m^3: draws MgO grains "
            "together by 12.5 effective "
            "radii at rest (limit 1). Is the unit right, or the modulus too low?");
}

TEST(Names, ThatAreUnknownAreRefusedWithTheNearest) {
  EXPECT_EQ(refusal({"Powder/Totl mass=1 g"}),
            "Powder/Totl mass = 1 g: is no entry of a case. Did you mean 'Powder/Total mass'?");
  EXPECT_EQ(refusal({"powder/total mass=1 g"}),
            "powder/total mass = 1 g: is no entry of a case. Did you mean 'Powder/Total mass'?");
  EXPECT_EQ(refusal({"Total mass=1 g"}),
            "Total mass = 1 g: is no entry of a case. Did you mean 'Powder/Total mass'?");
  EXPECT_EQ(refusal({"Frobnication=1"}),
            "Frobnication = 1: is no entry of a case. See all entries with: presscheck defaults?");
  EXPECT_EQ(refusal({"Powder=1"}),
            "Powder = 1: is a section, not an entry. Name an entry below it?");
  EXPECT_EQ(refusal({"Powder/Total mass"}), "--set 'Powder/Total mass': has no '=' (an override is "
                                            "'Section/Entry=value'). Add the value?");
  EXPECT_EQ(
      refusal({"Title\nPowder"}),
      "--set 'Title Powder': has no '=' (an override is 'Section/Entry=value'). Add the value?");
  EXPECT_EQ(refusal({"Title=a # b"}),
            "Title = a # b: holds '#', a tab, a line end, or a backslash at its end (a .prm file "
            "could not hold it). Leave it out?");
}

} // namespace
} // namespace coupling
