#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <thread>

using program::run;
using support::bytes_of;
namespace fs = std::filesystem;

namespace {

/// A study of four tiny runs that write restarts all the time.
class StudyFolders : public testing::Test {
protected:
  StudyFolders() {
    support::put_bytes(scratch_ / "case.prm", bytes_of(program::tiny_case()));
    write_study("set Kind = full_factorial\n");
  }

  void write_study(std::string const& design, std::string const& high = "30 MPa") {
    support::put_bytes(
        file(), "set Case = case.prm\nset Model = linear\nsubsection Case entries\nset "
                "Output/Snapshot interval = 0 s\n"
                "set Output/Restart interval = 20 ms\nend\nsubsection Design\n" +
                    design +
                    "end\nsubsection Factor 1\nset Name = E\nset Entries = Powder/Component "
                    "1/Young's modulus + Powder/Component 2/Young's modulus + 8 x Tooling/Young's "
                    "modulus\nset Low = 20 MPa\nset High = " +
                    high +
                    "\nset Levels = 2\nend\nsubsection Factor 2\nset Name = CED\nset Entries = "
                    "Contact/Particle-particle/Cohesion energy density\nset Low = 2e5 J/m^3\nset "
                    "High = 5e5 J/m^3\nset Levels = 2\nend\nsubsection Response 1\nset Name = F\n"
                    "set Quantity = max_force_N\nend\n");
  }

  /// A study of a table whose second row is stopped by a guard.
  void write_failing_study(std::string const& overlap = "0.2") {
    support::put_bytes(scratch_ / "settings.csv",
                       "setup,Time stepping/Largest relative overlap\ngood,1.8\nbad," + overlap +
                           "\nfine,1.7\n");
    support::put_bytes(file(), "set Case = case.prm\n");
  }

  std::string file() const { return (scratch_ / "study.prm").string(); }

  std::vector<std::string> call(std::string const& folder,
                                std::vector<std::string> const& more = {}) const {
    std::vector<std::string> arguments{"study",     file(), "-o",     (scratch_ / folder).string(),
                                       "--threads", "1",    "--jobs", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::size_t n_attempts(std::string const& folder) const {
    std::size_t n = 0;
    for (auto const& entry : fs::directory_iterator(scratch_ / folder / "states")) {
      auto const text = bytes_of(entry.path());
      n += static_cast<std::size_t>(std::stoi(
          text.substr(text.find("\"attempts\": ") + std::string("\"attempts\": ").size())));
    }
    return n;
  }

  /// Waits until some file of a run has come to be.
  static void wait_for(fs::path const& file) {
    for (int k = 0; k < 3000 && !fs::exists(file); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(fs::exists(file)) << file;
  }

  void expect_same_results(std::string const& a, std::string const& b) const {
    for (auto const& entry : fs::directory_iterator(scratch_ / a / "runs"))
      EXPECT_TRUE(bytes_of(entry.path() / "curves.csv") ==
                  bytes_of(scratch_ / b / "runs" / entry.path().filename() / "curves.csv"))
          << entry.path();
    EXPECT_EQ(without_times(a), without_times(b));
  }

  support::ScratchFolder scratch_;

private:
  /// results.csv without the columns that a clock fills.
  std::string without_times(std::string const& folder) const {
    std::istringstream lines(bytes_of(scratch_ / folder / "results.csv"));
    std::vector<bool> keeps;
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      std::size_t column = 0;
      bool const is_header = keeps.empty();
      for (std::string cell; std::getline(cells, cell, ','); ++column) {
        if (is_header)
          keeps.push_back(cell.find("seconds") == std::string::npos &&
                          cell.find("per_second") == std::string::npos);
        if (keeps[column])
          kept += cell + ",";
      }
      kept += "\n";
    }
    return kept;
  }
};

} // namespace

TEST_F(StudyFolders, KilledInTheMiddleOfItsRunsComesToTheSameBits) {
  ASSERT_EQ(run(call("straight")).status, 0);
  EXPECT_EQ(n_attempts("straight"), 4u);
  {
    program::Running first(call("killed"));
    wait_for(scratch_ / "killed/runs/E20_CED2e5/restart_stage_loading.h5");
    first.signal(SIGKILL);
    EXPECT_EQ(first.finish().status, 128 + SIGKILL);
  }
  EXPECT_FALSE(fs::exists(scratch_ / "killed/results.csv"));
  {
    program::Running second(call("killed"));
    wait_for(scratch_ / "killed/runs/E30_CED2e5/restart_stage_unloading.h5");
    second.signal(SIGKILL);
    second.finish();
  }
  auto const last = run(call("killed"));
  EXPECT_EQ(last.status, 0) << last.error;
  expect_same_results("straight", "killed");
  bool has_resumed = false;
  for (auto const& entry : fs::directory_iterator(scratch_ / "killed/logs"))
    has_resumed =
        has_resumed || bytes_of(entry.path()).find("continuing from") != std::string::npos;
  EXPECT_TRUE(has_resumed);
}

TEST_F(StudyFolders, RepeatsNoFinishedRun) {
  ASSERT_EQ(run(call("out")).status, 0);
  auto const written = fs::last_write_time(scratch_ / "out/runs/E20_CED2e5/summary.json");
  auto const results = bytes_of(scratch_ / "out/results.csv");
  EXPECT_EQ(run(call("out")).status, 0);
  EXPECT_EQ(fs::last_write_time(scratch_ / "out/runs/E20_CED2e5/summary.json"), written);
  EXPECT_EQ(bytes_of(scratch_ / "out/results.csv"), results);
  EXPECT_EQ(n_attempts("out"), 4u);
  // Half of another design is the same: those runs are kept.
  write_study("set Kind = full_factorial\n", "26 MPa");
  EXPECT_EQ(run(call("out")).status, 0);
  EXPECT_EQ(fs::last_write_time(scratch_ / "out/runs/E20_CED2e5/summary.json"), written);
  EXPECT_EQ(n_attempts("out"), 6u);
}

TEST_F(StudyFolders, RefusesTheFolderOfAnother) {
  fs::create_directory(scratch_ / "mine");
  support::put_bytes(scratch_ / "mine/notes.txt", "mine");
  auto const foreign = run(call("mine"));
  EXPECT_EQ(foreign.status, 2);
  EXPECT_NE(foreign.error.find("is not empty"), std::string::npos) << foreign.error;
  ASSERT_EQ(run(call("out", {"--only", "E20_CED2e5"})).status, 0);
  write_failing_study();
  auto const other = run(call("out"));
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.error.find("holds another study (none of its 4 runs is one of the 3 of"),
            std::string::npos)
      << other.error;
}

TEST_F(StudyFolders, AFailingRunDoesNotSinkTheOthers) {
  write_failing_study();
  auto const first = run(call("out"));
  EXPECT_EQ(first.status, 1);
  EXPECT_NE(first.out.find("2 of 3 runs done, 1 failed"), std::string::npos) << first.out;
  EXPECT_NE(first.error.find("bad failed: "), std::string::npos) << first.error;
  EXPECT_NE(first.error.find("limit of 0.2"), std::string::npos) << first.error;
  EXPECT_NE(bytes_of(scratch_ / "out/results.csv").find("bad,bad,1,design,failed"),
            std::string::npos);
  EXPECT_EQ(n_attempts("out"), 3u);
  // Tried again only if asked, or if its case has changed.
  EXPECT_EQ(run(call("out")).status, 1);
  EXPECT_EQ(n_attempts("out"), 3u);
  EXPECT_EQ(run(call("out", {"--retry"})).status, 1);
  EXPECT_EQ(n_attempts("out"), 4u);
  write_failing_study("1.6");
  EXPECT_EQ(run(call("out")).status, 0);
}

TEST_F(StudyFolders, RanksShareTheRuns) {
  auto const outcome = run({"sh", "-c",
                            "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun "
                            "--oversubscribe -n 2 \"" PRESSCHECK_PROGRAM "\" study '" +
                                file() + "' -o '" + (scratch_ / "out").string() + "'"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("4 of 4 runs done, 0 failed"), std::string::npos) << outcome.out;
  EXPECT_EQ(n_attempts("out"), 4u);
}

TEST_F(StudyFolders, TasksOfAnArrayRunOneCaseEach) {
  ASSERT_EQ(run(call("out", {"--export", "slurm"})).status, 0);
  auto const scripts = (scratch_ / "out/slurm").string();
  EXPECT_EQ(
      run({"sh", "-c", "for f in " + scripts + "/*.sh; do bash -n $f || exit 1; done"}).status, 0);
  EXPECT_FALSE(fs::exists(scratch_ / "out/results.csv"));
  for (auto const* task : {"1", "2", "3"})
    EXPECT_EQ(run({"sh", "-c",
                   std::string("SLURM_ARRAY_TASK_ID=") + task + " bash " + scripts + "/array.sh"})
                  .status,
              0);
  auto const early = run({"sh", "-c", "bash " + scripts + "/collect.sh"});
  EXPECT_EQ(early.status, 1);
  EXPECT_NE(early.out.find("3 of 4 runs done"), std::string::npos) << early.out;
  EXPECT_EQ(run({"sh", "-c", "SLURM_ARRAY_TASK_ID=4 bash " + scripts + "/array.sh"}).status, 0);
  EXPECT_EQ(run({"sh", "-c", "bash " + scripts + "/collect.sh"}).status, 0);
  EXPECT_EQ(run(call("straight")).status, 0);
  expect_same_results("straight", "out");
}

TEST_F(StudyFolders, ADryRunWritesNothing) {
  auto const outcome = run(call("out", {"--dry-run"}));
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("in all: 4 runs"), std::string::npos) << outcome.out;
  EXPECT_FALSE(fs::exists(scratch_ / "out"));
  // What only the geometry can refuse is refused before anything runs, too.
  support::put_bytes(scratch_ / "packing.csv", "x [m],y [m],z [m],diameter [m],component\n"
                                               "0.01,0,4e-3,1e-3,MgO\n");
  support::put_bytes(file(), bytes_of(file()) + "subsection Case entries\nset Powder/Fill method = "
                                                "file\nset Powder/Fill file = packing.csv\nend\n");
  auto const refused = run(call("out"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.error.find("study.prm:8: run 'E20_CED2e5': "), std::string::npos)
      << refused.error;
  EXPECT_FALSE(fs::exists(scratch_ / "out"));
}
