// A batch of tiny presses as a user starts it: undisturbed, killed twice, with runs that fail, two
// at once, and run by run as a job array does.
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/csv.hpp"
#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <set>

using program::run;
using support::bytes_of;
using support::ScratchFolder;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> const ids{"E20_CED4e5", "E20_CED5e5", "E25_CED4e5", "E25_CED5e5"};

std::string factor(int number, std::string const& name, std::string const& entries,
                   std::string const& low, std::string const& high) {
  return "subsection Factor " + std::to_string(number) + "\n  set Name = " + name +
         "\n  set Entries = " + entries + "\n  set Low = " + low + "\n  set High = " + high +
         "\n  set Levels = 2\nend\n";
}

/// Four runs: two moduli, two cohesions.
std::string study_in(fs::path const& folder, std::string const& second = "",
                     std::string const& more = "") {
  auto const file = folder / "study.prm";
  support::put_bytes(
      file,
      "set Case = " + program::tiny_case() + "\nset Model = linear\n" +
          "subsection Design\n  set Kind = full_factorial\nend\n" +
          factor(1, "E", "Powder/Component 1/Young's modulus", "20 MPa", "25 MPa") +
          (second.empty() ? factor(2, "CED", "Contact/Particle-particle/Cohesion energy density",
                                   "4e5 J/m^3", "5e5 J/m^3")
                          : second) +
          "subsection Response 1\n  set Name = F\n  set Quantity = max_force\nend\n" + more);
  return file.string();
}

std::vector<std::string> batch(std::string const& study, fs::path const& folder,
                               std::vector<std::string> const& more = {}) {
  std::vector<std::string> arguments{"study",  study, "-o",        folder.string(),
                                     "--jobs", "1",   "--threads", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

nlohmann::json state(fs::path const& folder, std::string const& id) {
  return nlohmann::json::parse(coupling::read_file(folder / "states" / (id + ".json")));
}

/// results.csv without what a clock says.
std::vector<std::vector<std::string>> results(fs::path const& folder) {
  auto const file = folder / "results.csv";
  auto const lines = coupling::split_csv(bytes_of(file), file.string());
  auto const& header = lines.at(0).fields;
  std::vector<std::vector<std::string>> rows;
  for (auto const& line : lines) {
    rows.emplace_back();
    for (std::size_t c = 0; c < header.size(); ++c)
      if (header[c].find("second") == std::string::npos)
        rows.back().push_back(line.fields.at(c));
  }
  return rows;
}

void expect_same(fs::path const& a, fs::path const& b) {
  EXPECT_EQ(results(a), results(b));
  for (auto const& id : ids)
    EXPECT_TRUE(bytes_of(a / "runs" / id / "curves.csv") ==
                bytes_of(b / "runs" / id / "curves.csv"))
        << id;
}

/// The page, with the curves and final shapes of the finished runs; it is made anew by `report`.
void expect_page(fs::path const& folder, std::string const& verdict) {
  auto const page = coupling::read_file(folder / "report.html");
  EXPECT_NE(page.find(verdict), std::string::npos);
  for (auto const* part : {"\"upper_punch_force\":[", "\"mean_overlap\":[", "\"pixels\":\""})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  fs::remove(folder / "report.html");
  auto const again = run({"report", folder.string()});
  EXPECT_EQ(again.status, 0) << again.error;
  EXPECT_TRUE(coupling::read_file(folder / "report.html") == page);
}

void kill_at(std::vector<std::string> const& arguments, std::string const& progress) {
  program::Running running(arguments);
  ASSERT_TRUE(running.wait_for(progress));
  running.signal(SIGKILL);
  EXPECT_EQ(running.finish().status, 128 + SIGKILL);
}

} // namespace

TEST(StudyBatch, KilledTwiceEndsAsUndisturbed) {
  ScratchFolder scratch;
  auto const study = study_in(scratch.path());
  auto const straight = run(batch(study, scratch / "straight"));
  ASSERT_EQ(straight.status, 0) << straight.error;
  EXPECT_NE(straight.out.find("F [N]: linear model, 4 runs"), std::string::npos) << straight.out;
  expect_page(scratch / "straight", "<strong>4 of 4 runs finished</strong>, 0 failed.");
  kill_at(batch(study, scratch / "killed"), "1 of 4 done");
  kill_at(batch(study, scratch / "killed"), "3 of 4 done");
  auto const last = run(batch(study, scratch / "killed"));
  ASSERT_EQ(last.status, 0) << last.error;
  expect_same(scratch / "straight", scratch / "killed");
  for (auto const& id : ids) // what was done stays done
    EXPECT_LE(state(scratch / "killed", id).at("attempts"), 2) << id;
  EXPECT_EQ(state(scratch / "killed", ids[0]).at("attempts"), 1);
  auto const before = fs::last_write_time(scratch / "killed" / "runs" / ids[3] / "curves.csv");
  EXPECT_EQ(run(batch(study, scratch / "killed")).status, 0);
  EXPECT_EQ(fs::last_write_time(scratch / "killed" / "runs" / ids[3] / "curves.csv"), before);
}

TEST(StudyBatch, InterruptedSaysHowToGoOn) {
  ScratchFolder scratch;
  auto const study = study_in(scratch.path());
  program::Running running(batch(study, scratch / "out"));
  ASSERT_TRUE(running.wait_for("1 of 4 done"));
  running.signal(SIGINT);
  auto const outcome = running.finish();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_NE(outcome.error.find("Go on with: presscheck study " + study + " -o " +
                               (scratch / "out").string()),
            std::string::npos)
      << outcome.error;
  EXPECT_EQ(run(batch(study, scratch / "out")).status, 0);
}

// An overlap guard of 1 % trips; the runs with the usual one are not touched by that.
TEST(StudyBatch, ListsFailedRunsAndDoesTheRest) {
  ScratchFolder scratch;
  auto const study = study_in(
      scratch.path(), factor(2, "G", "Time stepping/Largest relative overlap", "0.01", "1.8"));
  auto const first = run(batch(study, scratch / "out"));
  EXPECT_EQ(first.status, 1);
  EXPECT_NE(first.out.find("2 of 4 runs done, 2 failed"), std::string::npos) << first.out;
  EXPECT_NE(first.error.find("E20_G0.01 failed: "), std::string::npos) << first.error;
  EXPECT_NE(first.error.find("overlap"), std::string::npos) << first.error;
  expect_page(scratch / "out", "<li>E20_G0.01: failed, ");
  EXPECT_EQ(run(batch(study, scratch / "out")).status, 1);
  EXPECT_EQ(state(scratch / "out", "E20_G0.01").at("attempts"), 1);
  EXPECT_EQ(run(batch(study, scratch / "out", {"--retry"})).status, 1);
  EXPECT_EQ(state(scratch / "out", "E20_G0.01").at("attempts"), 2);
  EXPECT_EQ(state(scratch / "out", "E20_G1.8").at("attempts"), 1);
}

TEST(StudyBatch, TwoAtOnceShareTheRuns) {
  ScratchFolder scratch;
  auto const study = study_in(scratch.path());
  {
    program::Running one(batch(study, scratch / "out")), other(batch(study, scratch / "out"));
    EXPECT_EQ(one.finish().status, 0);
    EXPECT_EQ(other.finish().status, 0);
  }
  for (auto const& id : ids)
    EXPECT_EQ(state(scratch / "out", id).at("attempts"), 1) << id;
}

TEST(StudyBatch, RunByRunIsTheSame) {
  ScratchFolder scratch;
  auto const study = study_in(scratch.path());
  ASSERT_EQ(run(batch(study, scratch / "straight", {"--quiet"})).status, 0);
  for (auto const& id : ids)
    ASSERT_EQ(run(batch(study, scratch / "array", {"--only", id})).status, 0);
  auto const collected = run(batch(study, scratch / "array", {"--collect"}));
  EXPECT_EQ(collected.status, 0) << collected.error;
  EXPECT_NE(collected.out.find("4 of 4 runs done"), std::string::npos) << collected.out;
  expect_page(scratch / "array", "<strong>4 of 4 runs finished</strong>");
  expect_same(scratch / "straight", scratch / "array");
}

TEST(StudyBatch, RunsTheCalibratedPoint) {
  ScratchFolder scratch;
  auto const study = study_in(
      scratch.path(), "",
      "subsection Response 2\n  set Name = H\n  set Quantity = compact_height\n"
      "  set Target = 4.8 mm\n  set Target uncertainty = 0.1 mm\nend\n"
      "subsection Calibration\n  set Held = CED = 5e5 J/m^3\n  set Validation = true\nend\n");
  auto const outcome = run(batch(study, scratch / "out"));
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("5 of 5 runs done"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nvalidation_E"), std::string::npos) << outcome.out;
  auto const json =
      nlohmann::json::parse(coupling::read_file(scratch / "out" / "study.json")).at("analysis");
  EXPECT_EQ(json.at("validation").size(), 2u); // one run, two responses
}

TEST(StudyBatch, RefusesWhatIsNoStudyBeforeAnythingRuns) {
  ScratchFolder scratch;
  auto const refused = [&](std::string const& study, std::string const& reason) {
    auto const outcome = run(batch(study, scratch / "out"));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    EXPECT_NE(outcome.error.find(reason), std::string::npos) << outcome.error;
    EXPECT_FALSE(fs::exists(scratch / "out"));
  };
  refused("no-such-study.prm", "no-such-study.prm: does not exist");
  refused(study_in(scratch.path(), factor(2, "X", "Powder/Colour", "1", "2")), "Powder/Colour");
  refused(
      study_in(scratch.path(), factor(2, "N", "Powder/Component 1/Poisson's ratio", "0.2", "0.9")),
      "0.9");
  refused(
      study_in(scratch.path(), factor(2, "N", "Powder/Component 1/Poisson's ratio", "0.2", "0.2")),
      "0.2");
}
