#include "coupling/elastic/implicit_window.hpp"
#include "coupling/elastic/tool_coupling.hpp"
#include "coupling/record/restart_file.hpp"
#include "dem/expect.hpp"
#include "dem/step/visit_state.hpp"
#include "tests/regression/tiny_press.hpp"
#include "tests/unit/coupling/elastic_press.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace coupling;
using support::ScratchFolder;

namespace {

std::string mode(std::string const& name) {
  return "Mode=" + name;
}

/// Steps as PressCycle makes them, to the end of the programme.
void run(Press& press) {
  ScratchFolder const scratch;
  tiny::run(press, scratch.path());
}

double punch_force(Press const& press) {
  return 0.5 * (squeezing_force(tool_named(press.world, "upper_punch")) +
                squeezing_force(tool_named(press.world, "lower_punch")));
}

std::vector<double> forces(Press const& press) {
  return press.record.column("upper_punch_force");
}

bool same_bits(dem::WorldState const& a, dem::WorldState const& b) {
  return a.grains.position == b.grains.position && a.grains.velocity == b.grains.velocity &&
         a.grains.spin == b.grains.spin && a.contacts.spring == b.contacts.spring &&
         a.tool_force == b.tool_force && a.time == b.time;
}

std::vector<dem::WallImpulse> random_impulses(ElasticSurface const& surface, std::uint32_t tool) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<dem::WallImpulse> impulses;
  for (int k = 0; k < 400; ++k) {
    auto const face = static_cast<std::uint32_t>(random() % surface.trace().faces.size());
    impulses.push_back({tool,
                        {face, unit(random), unit(random)},
                        dem::Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random))});
  }
  return impulses;
}

} // namespace

TEST(FaceLocator, FindsThePointThatAPlaceStandsFor) {
  ScratchFolder const scratch;
  auto const press = layer::press(scratch, {mode("one_way")});
  for (std::size_t t = 0; t < 3; ++t) {
    auto const& trace = press.coupling.tool(t).surface->trace();
    FaceLocator const locator(trace);
    for (auto const& hit : random_impulses(*press.coupling.tool(t).surface, 0)) {
      auto const [face, xi, eta] = hit.place;
      dem::Vec3 const on = trace.position(face, xi, eta);
      dem::Vec3 const off = on + 0.3e-3 * trace.normal(face, xi, eta);
      auto const found = locator.nearest(off);
      auto const [f, x, e] = found.place;
      EXPECT_NEAR((trace.position(f, x, e) - on).norm(), 0.0, 1e-12);
      EXPECT_NEAR(found.distance, 0.3e-3, 1e-12);
    }
  }
}

TEST(ElasticSurface, KeepsForceMomentAndPower) {
  ScratchFolder const scratch;
  auto const press = layer::press(scratch, {mode("one_way")});
  for (std::uint32_t t = 0; t < 3; ++t) {
    auto& surface = *press.coupling.tool(t).surface;
    auto const impulses = random_impulses(surface, t);
    Eigen::Matrix3Xd nodal = surface.nodal(impulses, t);
    Eigen::Matrix3Xd const velocity = Eigen::Matrix3Xd::Random(3, nodal.cols());
    surface.set_course(velocity, velocity, 1.0);
    auto const kept = surface.errors(impulses, t, nodal);
    EXPECT_LT(kept.force, 1e-12);
    EXPECT_LT(kept.moment, 1e-12);
    EXPECT_LT(kept.power, 1e-12);
    // Every check sees a node that got too much, and another tool's loads do not count.
    nodal.col(3).array() += 1e-3;
    auto const lost = surface.errors(impulses, t, nodal);
    EXPECT_GT(std::min({lost.force, lost.moment, lost.power}), 1e-9);
    EXPECT_TRUE(surface.nodal(impulses, t + 1).isZero(0.0));
  }
}

TEST(ElasticSurface, MovesAsItsNodesDo) {
  ScratchFolder const scratch;
  auto const press = layer::press(scratch, {mode("one_way")});
  auto& surface = *press.coupling.tool(0).surface;
  // A linear field is reproduced; the bound holds.
  Eigen::Matrix3d A;
  A << 1, 2, 3, -1, 0.5, 2, 0, 1, -2;
  Eigen::Matrix3Xd const u = A * surface.trace().positions;
  surface.set_course(u, 2.0 * u, 0.5);
  for (auto const& hit : random_impulses(surface, 0)) {
    auto const motion = surface.at(hit.place);
    dem::Vec3 const x = surface.trace().position(hit.place.face, hit.place.xi, hit.place.eta);
    EXPECT_NEAR((motion.displacement - A * x).norm(), 0.0, 1e-15);
    EXPECT_NEAR((motion.velocity - 2.0 * A * x).norm(), 0.0, 1e-15);
    EXPECT_LE(motion.displacement.norm() + 0.5 * motion.velocity.norm(), surface.extent());
    EXPECT_LE(motion.velocity.norm(), surface.speed());
  }
  EXPECT_EQ(surface.at({}).displacement, dem::Vec3::Zero());
}

// Hertz's spheres in series with what the punches give, coupling numbers from 0.01 to 2: the modes
// that two-way coupling can trust meet the exact force.
TEST(ToolCoupling, MeetsTheSeriesSolution) {
  ScratchFolder const scratch;
  struct Row {
    char const *mode, *modulus;
    double number;
  };
  for (Row const& row : {Row{"two_way_explicit", "50 GPa", 0.01},
                         {"two_way_secant", "50 GPa", 0.01},
                         {"two_way_implicit", "50 GPa", 0.01},
                         {"two_way_secant", "1 GPa", 0.5},
                         {"two_way_implicit", "1 GPa", 0.5},
                         {"two_way_secant", "0.25 GPa", 2.0},
                         {"two_way_implicit", "0.25 GPa", 2.0}}) {
    auto press = layer::press(
        scratch, {mode(row.mode), std::string("Deformable tools/Young's modulus=") + row.modulus});
    run(press);
    double const exact = layer::series_force(press, layer::stroke);
    EXPECT_NEAR(punch_force(press), exact, 0.005 * exact) << row.mode << ' ' << row.modulus;
    // Of the stroke s the spheres take s_b = 2 (F / (7 K))^(2/3): k_b = 3/2 F / s_b and
    // C = (s - s_b) / F.
    double const spheres = 2.0 * std::pow(exact / 7.0 / layer::stiffness(), 2.0 / 3.0);
    double const number = 1.5 * (layer::stroke - spheres) / spheres;
    EXPECT_NEAR(std::log2(number / row.number), 0.0, 0.5) << row.mode << ' ' << row.modulus;
    // The secant mode converges while the bed's stiffness is known within a factor of two; the
    // implicit one takes it for its first guess only.
    if (row.mode != std::string("two_way_implicit")) {
      EXPECT_NEAR(std::log2(press.coupling.coupling_number() / number), 0.0, 1.0)
          << row.mode << ' ' << row.modulus;
    }
    // The grains' ledger counts what the deformation did to them, and the tools hold what was done
    // to them, but for what the lag inside a window takes out of the spheres that bounce on tools
    // as soft as they are.
    EXPECT_LT(press.tally.energy_error, 0.01 * press.tally.peak_work) << row.mode;
    EXPECT_LT(press.coupling.checks().work_error,
              0.01 * std::max(1.0, number) * press.tally.peak_work)
        << row.mode << ' ' << row.modulus;
    EXPECT_LT(press.coupling.checks().force, 1e-12);
    EXPECT_LT(press.coupling.checks().moment, 1e-12);
    EXPECT_LT(press.coupling.checks().power, 1e-12);
  }
}

TEST(ToolCoupling, ExplicitStopsBeforeADivergedResultIsUsed) {
  ScratchFolder const scratch;
  auto press =
      layer::press(scratch, {mode("two_way_explicit"), "Deformable tools/Young's modulus=0.2 GPa"});
  try {
    run(press);
    FAIL() << "it went on with coupling number " << press.coupling.checks().coupling_number;
  } catch (dem::PhysicsGuard const& stop) {
    EXPECT_NE(std::string(stop.what()).find("two_way_explicit diverges"), std::string::npos)
        << stop.what();
  }
}

TEST(ToolCoupling, WithAMillionfoldSteelIsTheRigidPress) {
  ScratchFolder const scratch;
  auto rigid = layer::press(scratch, {mode("one_way")});
  run(rigid);
  auto const expected = forces(rigid);
  double const peak = *std::ranges::max_element(expected);
  for (char const* name : {"two_way_explicit", "two_way_secant", "two_way_implicit"}) {
    auto press = layer::press(scratch, {mode(name), "Deformable tools/Young's modulus=210e15 Pa"});
    run(press);
    auto const found = forces(press);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 1e-6 * peak) << name;
  }
}

TEST(ToolCoupling, OneWayOnlyWatches) {
  ScratchFolder const scratch;
  auto watched = layer::press(scratch, {mode("one_way")});
  auto rigid = layer::press(scratch, {mode("one_way")});
  rigid.coupling = {};
  for (dem::Tool& tool : rigid.world.tools)
    tool.deformation = nullptr;
  dem::prepare(rigid.world);
  run(watched);
  run(rigid);
  EXPECT_TRUE(same_bits(dem::capture_state(watched.world), dem::capture_state(rigid.world)));
  EXPECT_GT(watched.record.column("tool_energy").back(), 0.0);
  EXPECT_EQ(rigid.record.column("tool_energy").back(), 0.0);
}

TEST(ToolCoupling, ImplicitTriesLeaveTheGrainsAsTheyWere) {
  ScratchFolder const scratch;
  auto press =
      layer::press(scratch, {mode("two_way_implicit"), "Deformable tools/Young's modulus=0.5 GPa"});
  press.programme.start_stage(press.world);
  auto const window = press.coupling.choice().window;
  for (std::uint64_t k = 0; k < 20 * window; ++k) {
    if (press.coupling.wants_course()) {
      dem::complete_step(press.world);
      auto const before = dem::capture_state(press.world);
      find_course(press);
      EXPECT_TRUE(same_bits(before, dem::capture_state(press.world)));
    }
    double const dt = press.programme.command_step(press.world);
    dem::advance_ahead(press.world, dt);
    press.programme.step_done(press.world);
    press.coupling.step_done(press.world, punch_gap(press.world, press.programme.faces()), dt);
  }
  EXPECT_GT(press.coupling.checks().iterations, press.coupling.checks().windows);
}

TEST(ToolCoupling, AcceleratorsFindTheFixedPointThatPlainIterationLeaves) {
  // x = b - A x with eigenvalues of A from 0.2 to 4.
  Eigen::VectorXd const A = Eigen::VectorXd::LinSpaced(5, 0.2, 4.0);
  Eigen::VectorXd const b = Eigen::VectorXd::LinSpaced(5, 1.0, 2.0);
  Eigen::VectorXd const exact = b.array() / (1.0 + A.array());
  for (auto const kind : {Accelerator::aitken, Accelerator::iqn_ils}) {
    FixedPointAccelerator accelerator(kind, 0.3);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(5);
    int n = 0;
    while ((x - exact).norm() > 1e-8 && n < 200) {
      x = accelerator.next(x, b - Eigen::VectorXd(A.array() * x.array()));
      ++n;
    }
    EXPECT_LT(n, kind == Accelerator::iqn_ils ? 8 : 100);
  }
}

TEST(ToolCoupling, ARestartInOrBetweenWindowsGoesOnToTheSameBits) {
  ScratchFolder const scratch;
  for (int const n_steps : {133, 140})
    for (char const* name : {"one_way", "two_way_explicit", "two_way_secant", "two_way_implicit"}) {
      auto press = layer::press(scratch, {mode(name), "Deformable tools/Young's modulus=5 GPa"});
      press.programme.start_stage(press.world);
      auto const go_on = [](Press& on, int n) {
        for (int k = 0; k < n; ++k) {
          if (on.coupling.wants_course())
            find_course(on);
          double const dt = on.programme.command_step(on.world);
          dem::advance_ahead(on.world, dt);
          on.programme.step_done(on.world);
          on.coupling.step_done(on.world, punch_gap(on.world, on.programme.faces()), dt);
        }
        dem::complete_step(on.world);
      };
      go_on(press, n_steps);
      auto const file = scratch / "restart.h5";
      StateWriter write(file, {.program_version = PRESSCHECK_VERSION,
                               .case_text = press.setup.resolved_text,
                               .stage = "loading",
                               .step = press.world.step,
                               .time = press.world.time});
      press.save(write);
      write.commit();
      auto again = restore_press(press.setup, file);
      go_on(press, 95);
      go_on(again, 95);
      EXPECT_TRUE(same_bits(dem::capture_state(press.world), dem::capture_state(again.world)))
          << name << ' ' << n_steps;
    }
}
