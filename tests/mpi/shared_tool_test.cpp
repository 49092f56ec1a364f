// Dies and punches over ranks: tests/mpi/shared_tool.cpp beside itself without mpirun.
#include "tests/mpi/mpirun.hpp"
#include "tests/support/scratch_folder.hpp"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

namespace {

std::string const program = SHARED_TOOL_PROGRAM;

/// What shared_tool writes.
struct Answer {
  Eigen::VectorXd displacement, stress;
  Eigen::MatrixXd compliance;
};

double number_before(std::string const& text, std::string const& words) {
  auto const end = text.find(words);
  if (end == std::string::npos || end == 0)
    throw std::runtime_error("no '" + words + "' in: " + text);
  return std::stod(text.substr(text.find_last_of(", \n", end - 1) + 1));
}

Answer answer_of(program::Outcome const& outcome, std::filesystem::path const& file) {
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  auto const n = static_cast<Eigen::Index>(number_before("\n" + outcome.out, " unknowns"));
  auto const m = static_cast<Eigen::Index>(number_before(outcome.out, " on the surface"));
  auto const bytes = support::bytes_of(file);
  Answer answer{Eigen::VectorXd(n), Eigen::VectorXd(3 * m), Eigen::MatrixXd(m, m)};
  EXPECT_EQ(bytes.size(), sizeof(double) * static_cast<std::size_t>(n + 3 * m + m * m));
  char const* from = bytes.data();
  auto const take = [&](auto& values) {
    std::memcpy(values.data(), from, sizeof(double) * values.size());
    from += sizeof(double) * values.size();
  };
  take(answer.displacement), take(answer.stress), take(answer.compliance);
  return answer;
}

void expect_serial_answer(std::string const& tool) {
  support::ScratchFolder const folder;
  std::string const file = (folder / "answer").string(),
                    command = program + " " + tool + " " + file;
  Answer const alone = answer_of(mpirun::run_alone(command), file);
  ASSERT_GT(alone.compliance.norm(), 0.0);
  ASSERT_GT(alone.compliance.rows(), 2 * 256); // blocks of the inverse for three ranks
  for (int const n : {2, 3}) {
    std::filesystem::remove(file);
    Answer const shared = answer_of(mpirun::run(n, command), file);
    auto const difference = [](auto const& a, auto const& b) { return (a - b).norm() / b.norm(); };
    EXPECT_LT(difference(shared.displacement, alone.displacement), 1e-10) << n << " ranks";
    EXPECT_LT(difference(shared.stress, alone.stress), 1e-10) << n << " ranks";
    EXPECT_LT(difference(shared.compliance, alone.compliance), 1e-10) << n << " ranks";
    EXPECT_TRUE(shared.compliance == shared.compliance.transpose()) << n << " ranks";
  }
}

TEST(ToolOverRanks, DieIsTheSerialOne) {
  expect_serial_answer("die 5.5e-3");
}

TEST(ToolOverRanks, PunchIsTheSerialOne) {
  expect_serial_answer("punch 3.3e-3");
}

// Start and end of MPI take 0.4 s of CPU; a rank that spins would add the 4 s.
TEST(ToolOverRanks, RanksWithoutWorkSleep) {
  auto const outcome = mpirun::run(2, program + " idle 4");
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  auto const at = outcome.out.find("another rank: CPU ");
  ASSERT_NE(at, std::string::npos) << outcome.out;
  EXPECT_LT(std::stod(outcome.out.substr(at + std::strlen("another rank: CPU "))), 2.0);
}

// The memory that lacks is another rank's; the error is the program's.
TEST(ToolOverRanks, LackOfMemoryElsewhereIsAnError) {
  auto const outcome = mpirun::run(2, program + " starve 1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.error, "linear solver: not enough memory. Use larger cells?\n");
}

} // namespace
