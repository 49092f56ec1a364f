#include "coupling/record/restart_file.hpp"

#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"
#include "dem/spheres.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/small_disk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

using coupling::RestartHeader;
using coupling::StateReader;
using coupling::StateWriter;
using support::ScratchFolder;

namespace {

/// A state with a visitor of the form that World and the press cycle have.
struct State {
  dem::Spheres grains;
  double time = 0.0;
  std::uint64_t step = 0;
  std::vector<float> springs;

  template <class Field> void visit(Field&& field) {
    field("grains/position", grains.position);
    field("grains/velocity", grains.velocity);
    field("grains/spin", grains.spin);
    field("grains/force", grains.force);
    field("grains/torque", grains.torque);
    field("grains/radius", grains.radius);
    field("grains/mass", grains.mass);
    field("grains/material", grains.material);
    field("grains/id", grains.id);
    field("time", time);
    field("step", step);
    field("contacts/springs", springs);
  }
};

State two_grains() {
  State state;
  state.grains.add({0.0, -0.0, 1.0 / 3.0}, 1e-3, 1800.0, 1, {0.1, 5e-324, 0.0});
  state.grains.add({1.0, 2.0, 3.0}, 2e-3, 1800.0, 0);
  std::swap(state.grains.id[0], state.grains.id[1]);
  state.time = 0.1;
  state.step = 12;
  state.springs = {1e-9f, -0.0f};
  return state;
}

RestartHeader header_at(std::uint64_t step) {
  return {.program_version = "0.1.0",
          .case_text = "set Title = x\n",
          .stage = "loading",
          .step = step,
          .time = 0.1};
}

void save(State state, std::filesystem::path const& file, std::uint64_t step) {
  StateWriter writer(file, header_at(step));
  state.visit(writer);
  writer.commit();
}

std::string message_of(std::function<void()> const& action) {
  try {
    action();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return {};
}

template <class T> bool same_bits(std::vector<T> const& a, std::vector<T> const& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

std::vector<std::string> sorted_names(ScratchFolder const& folder) {
  auto names = folder.names();
  std::ranges::sort(names);
  return names;
}

} // namespace

TEST(RestartFile, RestoresTheStateToTheBit) {
  ScratchFolder const folder;
  State const before = two_grains();
  save(before, folder / "restart_12.h5", 12);

  StateReader reader(folder / "restart_12.h5");
  State after;
  after.visit(reader);
  reader.finish();
  EXPECT_TRUE(same_bits(after.grains.position, before.grains.position));
  EXPECT_TRUE(same_bits(after.grains.velocity, before.grains.velocity));
  EXPECT_TRUE(same_bits(after.grains.spin, before.grains.spin));
  EXPECT_TRUE(same_bits(after.grains.force, before.grains.force));
  EXPECT_TRUE(same_bits(after.grains.torque, before.grains.torque));
  EXPECT_TRUE(same_bits(after.grains.radius, before.grains.radius));
  EXPECT_TRUE(same_bits(after.grains.mass, before.grains.mass));
  EXPECT_EQ(after.grains.material, before.grains.material);
  EXPECT_EQ(after.grains.id, before.grains.id);
  EXPECT_EQ(after.time, before.time);
  EXPECT_EQ(after.step, before.step);
  EXPECT_TRUE(same_bits(after.springs, before.springs));

  EXPECT_EQ(reader.header().program_version, "0.1.0");
  EXPECT_EQ(reader.header().case_text, "set Title = x\n");
  EXPECT_EQ(reader.header().stage, "loading");
  EXPECT_EQ(reader.header().step, 12u);
  EXPECT_EQ(reader.header().time, 0.1);
}

TEST(RestartFile, RefusesFieldsThatOnlyOneSideKnows) {
  ScratchFolder const folder;
  save(two_grains(), folder / "r.h5", 12);
  StateReader reader(folder / "r.h5");
  double value = 0.0;
  EXPECT_NE(message_of([&] { reader("new_in_this_version", value); }).find("is not in the file"),
            std::string::npos);
  EXPECT_NE(message_of([&] { reader("step", value); }).find("another number type"),
            std::string::npos);
  reader("time", value);
  std::string const message = message_of([&] { reader.finish(); });
  EXPECT_NE(message.find("state/contacts/springs"), std::string::npos);
  EXPECT_EQ(message.find("state/time"), std::string::npos);
}

TEST(RestartFile, RefusesGrainsThatAreNone) {
  ScratchFolder const folder;
  auto const refused = [&](std::function<void(State&)> const& damage) {
    State state = two_grains();
    damage(state);
    save(state, folder / "r.h5", 12);
    return message_of([&] { StateReader{folder / "r.h5"}; });
  };
  EXPECT_EQ(refused([](State&) {}), "");
  EXPECT_NE(refused([](State& s) {
              s.grains.velocity.pop_back();
            }).find("velocity has 1 rows for 2 grains"),
            std::string::npos);
  EXPECT_NE(refused([](State& s) { s.grains.material.pop_back(); }).find("material has 1 rows"),
            std::string::npos);
  EXPECT_NE(refused([](State& s) { s.grains.radius[1] = 0.0; }).find("radius[1] = 0"),
            std::string::npos);
  EXPECT_NE(refused([](State& s) { s.grains.mass[0] = -1.0; }).find("mass[0] = -1"),
            std::string::npos);
  EXPECT_NE(refused([](State& s) { s.grains.id[0] = 5; }).find("id[0] = 5"), std::string::npos);
  EXPECT_NE(refused([](State& s) { s.grains.id[0] = s.grains.id[1]; }).find("id[1]"),
            std::string::npos);
}

TEST(RestartFile, DoesNotReplaceAGoodStateByABrokenOne) {
  ScratchFolder const folder;
  save(two_grains(), folder / "r.h5", 12);
  State broken = two_grains();
  broken.grains.position[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(save(broken, folder / "r.h5", 13), dem::PhysicsGuard);
  broken = two_grains();
  broken.grains.radius[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(save(broken, folder / "r.h5", 13), dem::PhysicsGuard);
  EXPECT_EQ(StateReader(folder / "r.h5").header().step, 12u);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"r.h5"});
}

TEST(RestartFile, RefusesOtherFilesOfOurs) {
  ScratchFolder const folder;
  coupling::H5Writer writer(folder / "run.h5");
  writer.write("curves/time", std::vector<double>{0.0});
  writer.commit();
  EXPECT_NE(message_of([&] { StateReader{folder / "run.h5"}; }).find("is no restart file"),
            std::string::npos);

  coupling::H5Writer future(folder / "future.h5");
  future.write("header/format", std::uint64_t{99});
  future.commit();
  EXPECT_NE(message_of([&] { StateReader{folder / "future.h5"}; }).find("format = 99"),
            std::string::npos);
}

TEST(RestartFolder, KeepsTheNewestTwoAndOnePerStage) {
  ScratchFolder const folder;
  // 9 and 10: by number, not by letters.
  for (std::uint64_t const step : {8u, 9u, 10u}) {
    save(two_grains(), coupling::rolling_restart(folder.path(), step), step);
    coupling::prune_restarts(folder.path());
  }
  save(two_grains(), coupling::stage_restart(folder.path(), "loading"), 5);
  save(two_grains(), coupling::stage_restart(folder.path(), "2/../x y"), 6);
  coupling::prune_restarts(folder.path());
  EXPECT_EQ(sorted_names(folder),
            (std::vector<std::string>{"restart_10.h5", "restart_9.h5", "restart_stage_2____x_y.h5",
                                      "restart_stage_loading.h5"}));
}

TEST(RestartFolder, FallsBackToTheOlderWhenTheNewestIsDamaged) {
  ScratchFolder const folder;
  save(two_grains(), coupling::stage_restart(folder.path(), "filling"), 3);
  save(two_grains(), coupling::rolling_restart(folder.path(), 9), 9);
  save(two_grains(), coupling::rolling_restart(folder.path(), 10), 10);
  auto found = coupling::newest_restart(folder.path());
  EXPECT_EQ(found.header.step, 10u);
  EXPECT_EQ(found.file, folder / "restart_10.h5");
  EXPECT_TRUE(found.refused.empty());

  std::string const bytes = support::bytes_of(folder / "restart_10.h5");
  support::put_bytes(folder / "restart_10.h5", bytes.substr(0, bytes.size() / 2));
  found = coupling::newest_restart(folder.path());
  EXPECT_EQ(found.header.step, 9u);
  ASSERT_EQ(found.refused.size(), 1u);
  EXPECT_NE(found.refused[0].find("restart_10.h5"), std::string::npos);
  EXPECT_NE(found.refused[0].find("truncated"), std::string::npos);

  // A stage's end counts like any other state when it is the farthest.
  save(two_grains(), coupling::stage_restart(folder.path(), "loading"), 11);
  EXPECT_EQ(coupling::newest_restart(folder.path()).file, folder / "restart_stage_loading.h5");
}

TEST(RestartFolder, WithoutAWholeFileIsRefusedWithTheReasons) {
  ScratchFolder const folder;
  EXPECT_NE(
      message_of([&] { coupling::newest_restart(folder.path()); }).find("has no restart file"),
      std::string::npos);
  EXPECT_NE(message_of([&] { coupling::newest_restart(folder / "none"); }).find("cannot be listed"),
            std::string::npos);
  support::put_bytes(folder / "restart_1.h5", "text");
  EXPECT_NE(message_of([&] {
              coupling::newest_restart(folder.path());
            }).find("restart_1.h5: is no data file"),
            std::string::npos);
}

TEST(RestartFolder, OnAFullDiskTheLastRestartStaysGood) {
  ScratchFolder const folder;
  save(two_grains(), coupling::rolling_restart(folder.path(), 9), 9);
  {
    support::SmallDisk const disk(2048);
    EXPECT_THROW(save(two_grains(), coupling::rolling_restart(folder.path(), 10), 10),
                 coupling::WriteFailed);
  }
  EXPECT_EQ(sorted_names(folder), std::vector<std::string>{"restart_9.h5"});
  EXPECT_EQ(coupling::newest_restart(folder.path()).header.step, 9u);
}
