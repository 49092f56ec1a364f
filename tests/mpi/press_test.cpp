// The program over ranks, as a user runs it: the tiny case with tools that deform.
#include "coupling/record/curves.hpp"
#include "tests/mpi/mpirun.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <set>

namespace {

std::string const presscheck = PRESSCHECK_PROGRAM;
std::string const tiny = " run " + program::tiny_case() + " --threads 1 --set Mode=two_way_secant";

class PressOverRanks : public ::testing::Test {
protected:
  std::string in(std::string const& name) const { return (folder_ / name).string(); }
  std::string cache(std::string const& name) const { return "PRESSCHECK_CACHE=" + in(name); }
  std::string curves(std::string const& name) const {
    return support::bytes_of(folder_ / name / "curves.csv");
  }
  std::set<std::string> names(std::string const& name) const {
    std::set<std::string> found;
    for (auto const& entry : std::filesystem::directory_iterator(folder_ / name))
      found.insert(entry.path().filename().string());
    return found;
  }

private:
  support::ScratchFolder folder_;
};

double size_of(std::vector<double> const& values) {
  double largest = 0.0;
  for (double const value : values)
    largest = std::max(largest, std::abs(value));
  return largest;
}

void expect_close(coupling::PressRecord const& found, coupling::PressRecord const& expected) {
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_GT(expected.size(), 100u);
  for (auto const& [name, unit] : expected.columns()) {
    auto const there = expected.column(name);
    auto difference = found.column(name);
    for (std::size_t row = 0; row < there.size(); ++row)
      difference[row] -= there[row];
    EXPECT_LE(size_of(difference), 1e-9 * size_of(there)) << name;
  }
}

// Operators agree within 1e-14 and steel gives micrometres at most, so that grains of a millimetre
// feel 1e-17 of their size: 1e-9 leaves room for what contacts make of it.
TEST_F(PressOverRanks, IsTheSerialPress) {
  ASSERT_EQ(mpirun::run_alone(presscheck + tiny + " -o " + in("alone"), cache("kept")).status, 0);
  auto const shared = mpirun::run(2, presscheck + tiny + " -o " + in("shared"), cache("new"));
  ASSERT_EQ(shared.status, 0) << shared.error;
  EXPECT_EQ(names("new"), names("kept")); // the operators of one rank are those of two
  EXPECT_EQ(names("kept").size(), 3u);
  expect_close(coupling::read_curves(in("shared") + "/curves.csv"),
               coupling::read_curves(in("alone") + "/curves.csv"));
  auto const cached = mpirun::run(3, presscheck + tiny + " -o " + in("cached"), cache("kept"));
  ASSERT_EQ(cached.status, 0) << cached.error;
  EXPECT_TRUE(curves("cached") == curves("alone"));
}

TEST_F(PressOverRanks, StopsAndGoesOn) {
  auto const settings = cache("kept");
  ASSERT_EQ(mpirun::run_alone(presscheck + tiny + " -o " + in("whole"), settings).status, 0);
  // The first rank leaves its number in a file.
  std::string const rest = tiny + " -o " + in("run");
  program::Running running({"sh", "-c",
                            settings + " " + mpirun::starter + " -n 1 sh -c 'echo $$ >" +
                                in("first") + " && exec " + presscheck + rest + "' : -n 1 " +
                                presscheck + rest});
  ASSERT_TRUE(running.wait_for("loading"));
  kill(std::stoi(support::bytes_of(in("first"))), SIGINT);
  auto const stopped = running.finish();
  EXPECT_EQ(stopped.status, 130) << stopped.error;
  EXPECT_NE(stopped.error.find("interrupted at"), std::string::npos);
  auto const resumed =
      mpirun::run(2, presscheck + " resume " + in("run") + " --threads 1", settings);
  EXPECT_EQ(resumed.status, 0) << resumed.error;
  EXPECT_TRUE(curves("run") == curves("whole"));
}

TEST_F(PressOverRanks, RigidToolsAreOneRanksWork) {
  std::string const rigid = " run " + program::tiny_case() + " --threads 1 --quiet -o ";
  ASSERT_EQ(mpirun::run_alone(presscheck + rigid + in("alone")).status, 0);
  auto const shared = mpirun::run(2, presscheck + rigid + in("shared"));
  EXPECT_EQ(shared.status, 0);
  EXPECT_NE(shared.error.find("Mode = rigid: one of the 2 ranks does the work"), std::string::npos)
      << shared.error;
  EXPECT_TRUE(curves("shared") == curves("alone"));
}

TEST_F(PressOverRanks, SaysOnceWhatIsWrong) {
  for (std::string const wrong :
       {" --set Mode=steel", " --set 'Deformable tools/Cell size=-1 mm'"}) {
    auto const outcome = mpirun::run(2, presscheck + tiny + wrong + " -o " + in("run"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(in("run")));
  }
}

TEST_F(PressOverRanks, DescribesACaseOnce) {
  std::string const check = presscheck + " check " + program::tiny_case() + " --set Mode=one_way";
  std::string const settings = "OMP_NUM_THREADS=1 " + cache("kept");
  ASSERT_EQ(mpirun::run_alone(check, settings).status, 0);
  auto const outcome = mpirun::run(2, check, settings);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  auto const first = outcome.out.find("die, elastic");
  EXPECT_NE(first, std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("die, elastic", first + 1), std::string::npos);
}

// Every process of another MPI's mpirun is a rank of its own: none may touch the folder.
TEST_F(PressOverRanks, RefusesAnotherMpisStarter) {
  auto const outcome = mpirun::run_alone(presscheck + tiny + " -o " + in("run"), "PMI_SIZE=2");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("2 processes were started"), std::string::npos) << outcome.error;
  EXPECT_FALSE(std::filesystem::exists(in("run")));
}

} // namespace
