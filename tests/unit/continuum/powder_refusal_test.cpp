// Each bad parameter of a powder law has its message.
#include "continuum/powder/avicel_ph102.hpp"
#include "continuum/powder/powder_law.hpp"
#include "tests/unit/continuum/refusal.hpp"

#include <limits>

namespace {

using namespace continuum;

ModifiedCamClay clay() {
  return {.slope = 1.2,
          .initial_relative_density = 0.5,
          .elasticity =
              PressureElasticity{.reference_pressure = 1e5, .kappa = 0.002, .shear_modulus = 5e7},
          .hardening = IndexHardening{.preconsolidation = 1.5e5, .lambda = 0.003, .kappa = 0.002}};
}

void refuse_cap(auto const& spoil, std::string const& part) {
  auto law = avicel_ph102(HardeningReading::consistent);
  spoil(law);
  expect_refusal([&] { validate(law, "bed"); }, part);
}

void refuse_clay(auto const& spoil, std::string const& part) {
  auto law = clay();
  spoil(law);
  expect_refusal([&] { validate(law, "bed"); }, part);
}

TEST(PowderRefusal, TakesWhatIsRight) {
  validate(avicel_ph102(HardeningReading::as_filed), "bed");
  validate(avicel_ph102(HardeningReading::consistent), "bed");
  validate(clay(), "bed");
}

TEST(PowderRefusal, OfTables) {
  refuse_cap([](auto& l) { l.cohesion.rows.clear(); }, "bed, cohesion d: the table has no row");
  refuse_cap([](auto& l) { std::swap(l.eccentricity.rows[1], l.eccentricity.rows[2]); },
             "bed, eccentricity R: row 3 at relative density = 0.4 does not follow 0.5");
  refuse_cap([](auto& l) { l.friction_angle.rows[0].value = std::nan(""); },
             "bed, friction angle: row 1 = (0.3, nan)");
  refuse_cap([](auto& l) { l.cohesion.rows.back().x = 1.1; }, "a row at relative density = 1.1");
}

TEST(PowderRefusal, OfTheCap) {
  refuse_cap([](auto& l) { l.initial_relative_density = 1.0; }, "initial relative density = 1 ");
  refuse_cap([](auto& l) { l.initial_relative_density = 0.0; }, "initial relative density = 0 ");
  refuse_cap([](auto& l) { l.cohesion = -1.0; }, "cohesion d = -1 Pa");
  refuse_cap([](auto& l) { l.friction_angle = 68.0; }, "friction angle from 68 to 68 rad");
  refuse_cap([](auto& l) { l.eccentricity = 0.0; }, "eccentricity R = 0 ");
  refuse_cap([](auto& l) { l.hardening.rows[3].value = 1.0; },
             "hardening p_b has one row, or falls");
  refuse_cap([](auto& l) { l.hardening_reference_density = 1.2; },
             "reference density of the hardening = 1.2");
  refuse_cap([](auto& l) { l.tension_cut_off = 0.0; }, "tension cut-off = 0 ");
  refuse_cap([](auto& l) { l.transition = 0.5; }, "transition a = 0.5 is not below cos b");
  refuse_cap([](auto& l) { l.cohesion = 10e6; }, "is not above R d");
}

TEST(PowderRefusal, OfElasticity) {
  refuse_cap([](auto& l) { l.elasticity.young_modulus = 0.0; }, "Young's modulus = 0 Pa");
  refuse_cap([](auto& l) { l.elasticity.poisson_ratio = 0.5; }, "Poisson's ratio = 0.5");
  refuse_cap([](auto& l) { l.elasticity.poisson_ratio = -1.0; }, "Poisson's ratio = -1");
  using P = PressureElasticity;
  refuse_clay([](auto& l) { std::get<P>(l.elasticity).kappa = 0.0; }, "kappa = 0 ");
  refuse_clay([](auto& l) { std::get<P>(l.elasticity).shear_modulus = -1.0; },
              "shear modulus = -1 Pa");
  refuse_clay([](auto& l) { std::get<P>(l.elasticity).reference_pressure = 0.0; },
              "reference pressure = 0 Pa");
}

TEST(PowderRefusal, OfCamClay) {
  refuse_clay([](auto& l) { l.slope = 0.0; }, "M = 0 ");
  refuse_clay([](auto& l) { l.cohesion = -1.0; }, "cohesion = -1 Pa");
  refuse_clay([](auto& l) { l.initial_relative_density = 1.5; }, "initial relative density = 1.5");
  using I = IndexHardening;
  refuse_clay([](auto& l) { std::get<I>(l.hardening).lambda = 0.002; },
              "kappa = 0.002 is not below lambda = 0.002");
  refuse_clay([](auto& l) { std::get<I>(l.hardening).preconsolidation = 0.0; },
              "preconsolidation = 0 Pa");
  refuse_clay([](auto& l) { std::get<I>(l.hardening).kappa = 0.001; }, "is not kappa = 0.001");
  refuse_clay([](auto& l) { std::get<I>(l.hardening).preconsolidation = 5e4; },
              "initial pressure = 100000 Pa is above p_c = 50000 Pa");
}

TEST(PowderRefusal, OfHardeningCurves) {
  refuse_clay(
      [](auto& l) {
        l.hardening = HeckelHardening{1e6, 0.0, 0.5};
      },
      "yield pressure = 0 Pa");
  refuse_clay(
      [](auto& l) {
        l.hardening = HeckelHardening{1e6, 1e7, 1.0};
      },
      "reference density of the hardening = 1 ");
  refuse_clay(
      [](auto& l) {
        l.hardening = HeckelHardening{1e6, 1e8, 0.6};
      },
      "Pa at the initial density");
  auto const table = [](std::vector<PiecewiseLinear::Row> rows) {
    return [rows](auto& l) { l.hardening = TabulatedHardening{PiecewiseLinear(rows)}; };
  };
  refuse_clay(table({{0.5, 1e6}}), "the hardening has one row");
  refuse_clay(table({{0.5, 1e6}, {1.0, 2e6}}), "hardening at relative density = 1 ");
  refuse_clay(table({{0.5, 1e6}, {0.8, 5e5}}), "the hardening falls");
  refuse_clay(table({{0.5, -1e6}, {0.8, 5e5}}), "Pa at the initial density");
}

} // namespace
