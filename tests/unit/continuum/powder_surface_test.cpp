// Ends of steps against the yield functions and potentials of the cap model, written here again
// from Abaqus' manual, with a transition and a cut-off.
#include "continuum/powder/avicel_ph102.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace {

using namespace continuum;

struct Values {
  double d, t, c, R, p_a, D_c, a, f;
};

Values at_end(DruckerPragerCap const& law, double compaction) {
  double const D = 0.3411 * std::exp(compaction);
  Values v{};
  v.d = law.cohesion(D);
  v.t = std::tan(law.friction_angle(D));
  v.c = std::cos(law.friction_angle(D));
  v.R = law.eccentricity(D);
  double const p_b = law.hardening(std::log(D / 0.30));
  v.p_a = (p_b - v.R * v.d) / (1.0 + v.R * v.t);
  v.D_c = v.d + v.p_a * v.t;
  v.a = law.transition;
  v.f = law.tension_cut_off;
  return v;
}

/// The yield function of a surface [Pa].
double yield(PowderSurface surface, Values const& v, double p, double q) {
  switch (surface) {
  case PowderSurface::cap:
    return std::hypot(p - v.p_a, v.R * q / (1.0 + v.a - v.a / v.c)) - v.R * (v.d + v.p_a * v.t);
  case PowderSurface::transition:
    return std::hypot(p - v.p_a, q - (1.0 - v.a / v.c) * (v.d + v.p_a * v.t)) -
           v.a * (v.d + v.p_a * v.t);
  case PowderSurface::shear:
    return q - p * v.t - v.d;
  case PowderSurface::tension:
    return p + v.f * v.d / v.t;
  case PowderSurface::edge:
    return std::abs(p + v.f * v.d / v.t) + std::abs(q - (1.0 - v.f) * v.d);
  default:
    return 0.0;
  }
}

/// The potential [Pa]; flow is its gradient, taken by differences.
double potential(ShearFlow flow, PowderSurface surface, Values const& v, double p, double q) {
  if (surface == PowderSurface::cap || surface == PowderSurface::tension)
    return surface == PowderSurface::cap ? yield(surface, v, p, q) : -p;
  double const k = 1.0 + v.a - v.a / v.c, x = (v.p_a - p) * v.t;
  return flow == ShearFlow::elliptic ? std::hypot(x, q / k) : q + k * x * x / (2.0 * v.D_c);
}

/// Sine of the angle between the plastic strain of a step and the potential's gradient.
double misdirection(ShearFlow flow, PowderSurface surface, Values const& v, Invariants const& s,
                    double volumetric, double deviatoric) {
  double const h = 1e-4 * v.D_c;
  double const by_p =
      (potential(flow, surface, v, s.p + h, s.q) - potential(flow, surface, v, s.p - h, s.q)) /
      (2.0 * h);
  double const by_q =
      (potential(flow, surface, v, s.p, s.q + h) - potential(flow, surface, v, s.p, s.q - h)) /
      (2.0 * h);
  EXPECT_GT(by_p * volumetric + by_q * deviatoric, 0.0); // forwards
  return (by_p * deviatoric - by_q * volumetric) /
         (std::hypot(by_p, by_q) * std::hypot(volumetric, deviatoric));
}

double q_of(Eigen::Vector3d const& strain) {
  return std::sqrt(2.0 / 3.0) * (strain.array() - strain.mean()).matrix().norm();
}

void expect_ends_on_surfaces(ShearFlow flow) {
  auto law = avicel_ph102(HardeningReading::consistent);
  law.shear_flow = flow;
  law.transition = 0.03;
  law.tension_cut_off = 0.4;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> compaction(0.0, 0.9);
  std::map<PowderSurface, int> n;
  for (int i = 0; i < 6000; ++i) {
    PowderState const state{.plastic_compaction = compaction(random)};
    Eigen::Vector3d const trial = 3e-3 * std::exp(normal(random)) *
                                  Eigen::Vector3d(normal(random), normal(random), normal(random));
    auto const step = law.respond(state, trial);
    ASSERT_TRUE(step);
    if (step->surface == PowderSurface::none)
      continue;
    ++n[step->surface];
    auto const v = at_end(law, step->state.plastic_compaction);
    auto const s = invariants(step->stress);
    EXPECT_LT(std::abs(yield(step->surface, v, s.p, s.q)), 1e-9 * v.D_c) << name_of(step->surface);
    Eigen::Vector3d const plastic = trial - step->elastic_strain;
    if (step->surface != PowderSurface::edge && plastic.norm() > 1e-6) {
      double const sine = misdirection(flow, step->surface, v, s, -plastic.sum(), q_of(plastic));
      EXPECT_NEAR(sine, 0.0, 1e-6) << name_of(step->surface);
    }
  }
  using enum PowderSurface;
  for (PowderSurface const surface : {cap, transition, shear, tension, edge})
    EXPECT_GE(n[surface], 5) << name_of(surface);
}

TEST(PowderSurfaces, StepsEndOnThemAndFlowByAbaqusPotential) {
  expect_ends_on_surfaces(ShearFlow::elliptic);
}

TEST(PowderSurfaces, StepsEndOnThemAndFlowByTheParabola) {
  expect_ends_on_surfaces(ShearFlow::admissible);
}

/// The trial strain whose stress is (p, q) at a density of the law.
Eigen::Vector3d strain_of(DruckerPragerCap const& law, double density, double p, double q) {
  double const E = law.elasticity.young_modulus(density);
  double const nu = law.elasticity.poisson_ratio(density);
  double const third = p * (1.0 - 2.0 * nu) / E, shear = q * 2.0 * (1.0 + nu) / (3.0 * E);
  return {-third + shear / 2.0, -third + shear / 2.0, -third - shear};
}

// On each part of the boundary: a stress a thousandth inside is elastic, a thousandth outside
// yields.
TEST(PowderSurfaces, ElasticRangeEndsAtThem) {
  auto law = avicel_ph102(HardeningReading::consistent);
  law.transition = 0.03;
  law.tension_cut_off = 0.4;
  double const density = 0.65, compaction = std::log(density / 0.3411);
  auto const v = at_end(law, compaction);
  double const k = 1.0 + v.a - v.a / v.c, half = v.p_a - 0.5 * v.a * v.D_c * v.t * v.c;
  double const arc =
      (1.0 - v.a / v.c) * v.D_c + std::sqrt(std::pow(v.a * v.D_c, 2) - std::pow(half - v.p_a, 2));
  double const on_cap = v.p_a + 0.6 * v.R * v.D_c;
  struct {
    PowderSurface surface;
    double p, q, by_p, by_q; // a point and the way out
  } const points[] = {{PowderSurface::cap, on_cap, 0.8 * k * v.D_c, 1.0, 1.0},
                      {PowderSurface::transition, half, arc, 0.0, 1.0},
                      {PowderSurface::shear, 0.5 * v.p_a, v.d + 0.5 * v.p_a * v.t, 0.0, 1.0},
                      {PowderSurface::tension, -0.4 * v.d / v.t, 0.3 * v.d, -1.0, 0.0}};
  for (auto const& point : points) {
    double const move = 1e-3 * v.d;
    auto const at = [&](double way) {
      auto const strain = strain_of(law, density, point.p + way * move * point.by_p,
                                    point.q + way * move * point.by_q);
      return law.respond({.plastic_compaction = compaction}, strain);
    };
    auto const inside = at(-1.0), outside = at(1.0);
    ASSERT_TRUE(inside && outside) << name_of(point.surface);
    EXPECT_EQ(inside->surface, PowderSurface::none) << name_of(point.surface);
    EXPECT_EQ(outside->surface, point.surface);
  }
}

// The parabola and the ellipse have value, slope and curvature in common at p_a, so their
// dilatancies agree to first order there.
TEST(PowderSurfaces, ParabolaOsculatesTheEllipse) {
  Values v{
      .d = 3.0, .t = 2.4, .c = 1.0 / 2.6, .R = 0.6, .p_a = 7.0, .D_c = 0.0, .a = 0.03, .f = 1.0};
  v.D_c = v.d + v.p_a * v.t;
  double const k = 1.0 + v.a - v.a / v.c, top = k * v.D_c;
  auto const slope = [&](ShearFlow flow, double p) { // -G_p/G_q
    double const h = 1e-4;
    auto const G = [&](double x, double y) {
      return potential(flow, PowderSurface::shear, v, x, y);
    };
    return -(G(p + h, top) - G(p - h, top)) / (G(p, top + h) - G(p, top - h));
  };
  for (auto const flow : {ShearFlow::elliptic, ShearFlow::admissible}) {
    EXPECT_NEAR(slope(flow, v.p_a), 0.0, 1e-9);
    EXPECT_NEAR((slope(flow, v.p_a) - slope(flow, v.p_a + 1e-3)) / 1e-3, k * v.t * v.t / v.D_c,
                1e-5);
  }
}

} // namespace
