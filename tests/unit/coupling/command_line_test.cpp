#include "coupling/record/curves.hpp"
#include "tests/regression/program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using program::run;
using program::tiny_case;
using support::ScratchFolder;
namespace fs = std::filesystem;

namespace {

/// Status 2, one line that says what is wrong, nothing on standard output.
void expect_refused(program::Outcome const& outcome, std::string const& reason) {
  EXPECT_EQ(outcome.status, 2) << outcome.error;
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
  EXPECT_NE(outcome.error.find(reason), std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.out, "");
}

/// The same for a run, which must leave nothing behind.
void expect_run_refused(std::vector<std::string> const& changes, std::string const& reason,
                        std::string const& case_file = tiny_case()) {
  ScratchFolder scratch;
  std::vector<std::string> arguments{"run",       case_file, "-o", (scratch / "out").string(),
                                     "--threads", "1"};
  for (auto const& change : changes) {
    arguments.push_back("--set");
    arguments.push_back(change);
  }
  expect_refused(run(arguments), reason);
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

} // namespace

TEST(CommandLine, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run({"--help"}).status, 0);
  EXPECT_NE(run({"--help"}).out.find("resume"), std::string::npos);
  EXPECT_EQ(run({"run", "--help"}).status, 0);
  EXPECT_NE(run({"--version"}).out.find('.'), std::string::npos);
}

TEST(CommandLine, WrongUseIsOneLineAndStatus2) {
  expect_refused(run({}), "subcommand");
  expect_refused(run({"press"}), "press");
  expect_refused(run({"run"}), "case");
  expect_refused(run({"run", tiny_case(), "--fast"}), "--fast");
  expect_refused(run({"run", tiny_case(), "--threads", "none"}), "--threads");
  expect_refused(run({"run", tiny_case(), "--threads", "0"}), "--threads");
  expect_refused(run({"compare", "only-one"}), "sources");
  expect_refused(run({"study"}), "names no study file");
  expect_refused(run({"study", "plan.prm"}), "plan.prm: does not exist");
  expect_refused(run({"defaults", "--format", "yaml"}), "--format");
  expect_refused(run({"verify", "--filter", "no-such-benchmark"}), "no-such-benchmark");
}

TEST(CommandLine, DiagnosesOnlyWhatIsThere) {
  std::string const of = PRESSCHECK_SOURCE_DIR "/tests/diagnosis/case.prm";
  expect_refused(run({"diagnose", of, "nowhere"}), "nowhere/measured.json");
  expect_refused(run({"diagnose", "nocase.prm", "nowhere"}), "nocase.prm");
  expect_refused(run({"diagnose", of}), "measured");
}

TEST(CommandLine, TellsThePowerOfInstrumentsBeforeAnythingIsMeasured) {
  ScratchFolder scratch;
  auto const folder = (scratch / "power").string();
  auto const outcome = run({"power", tiny_case(), "-o", folder, "--quiet", "--threads", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  for (auto const* line : {"A: upper force, one run; 42 rows; 1 mm/min to 4.4 mm", "force_offset",
                           "Sensors: forces 12 N", "1 mm/min to 4.4 mm and 60 s there"})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line;
  for (auto const* file : {"power.json", "power.md", "simulation/curves.csv"})
    EXPECT_TRUE(fs::exists(scratch / "power" / file)) << file;
  EXPECT_NE(support::bytes_of(scratch / "power/power.md").find("| cause | prior size | A | D |"),
            std::string::npos);
  // The simulation is taken again, with other instruments.
  auto const simulation = (scratch / "power/simulation").string();
  auto const of = [&](std::vector<std::string> const& further) {
    std::vector<std::string> arguments{"power",    tiny_case(), "--simulation",
                                       simulation, "-o",        (scratch / "again").string()};
    arguments.insert(arguments.end(), further.begin(), further.end());
    return run(arguments);
  };
  expect_refused(of({"--speed", "1 kg"}), "--speed 1 kg: has a unit that does not fit");
  expect_refused(of({"--force-sd", "-1 N"}), "--force-sd -1 N: -1 is not positive");
  expect_refused(of({"--end-gap", "7.9 mm"}), "set A: the bed does not bear at a gap of 0.0079 m");
  expect_refused(of({"--repeats", "0"}), "--repeats");
  expect_refused(run({"power"}), "case");
  expect_refused(run({"power", "nocase.prm"}), "nocase.prm");
  expect_refused(run({"power", tiny_case(), "--simulation", "nowhere"}), "nowhere/case.resolved");
  expect_refused(run({"power", tiny_case(), "-o", folder}), "is not empty");
  EXPECT_FALSE(fs::exists(scratch / "again"));
  auto const coarse = of({"--force-sd", "1 kN", "--repeats", "3", "--grains", "5000"});
  ASSERT_EQ(coarse.status, 0) << coarse.error;
  EXPECT_NE(coarse.out.find("forces 1000 N"), std::string::npos);
  EXPECT_NE(coarse.out.find("each run the mean of 3"), std::string::npos);
  EXPECT_NE(coarse.out.find("one packing, scattering as 5000 grains do"), std::string::npos);
}

TEST(CommandLine, DefaultsListEveryEntry) {
  auto const outcome = run({"defaults"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("Rayleigh fraction"), std::string::npos);
  EXPECT_NE(run({"defaults", "--format", "json"}).out.find("\"Rayleigh fraction\""),
            std::string::npos);
}

TEST(CommandLine, BadCasesAreRefusedBeforeAnythingIsWritten) {
  expect_run_refused({}, "does not exist", "no-such-case.prm");
  expect_run_refused({"Powder/Total masses=9 g"}, "Total mass");
  expect_run_refused({"Powder/Total mass=9 mm"}, "mm");
  expect_run_refused({"Powder/Total mass=nan"}, "nan");
  expect_run_refused({"Powder/Total mass=3 g"}, "Total mass"); // does not fit
  expect_run_refused({"Tooling/Bore diameter=22 m"}, "22 m");
  expect_run_refused({"Press programme/Stage 1/Speed=-40 m/s"}, "per step");
  expect_run_refused({"Press programme/Stage 1/Kind=none", "Press programme/Stage 2/Kind=none",
                      "Press programme/Stage 3/Kind=none", "Press programme/Stage 4/Kind=none"},
                     "without a stage", PRESSCHECK_SOURCE_DIR "/cases/quick/case.prm");
  expect_run_refused({"Mode=two_way"}, "two_way_secant");
  expect_run_refused({"Mode=one_way", "Deformable tools/Cup depth=1 mm"}, "Cup depth");
  expect_run_refused({"Powder/Fill method=file", "Powder/Fill file=missing.csv"}, "missing.csv");
}

TEST(CommandLine, BadGeometryIsRefused) {
  ScratchFolder scratch;
  auto const stl = (scratch / "die.stl").string();
  auto const with_die = [&](std::string_view bytes, std::string const& reason) {
    support::put_bytes(stl, bytes);
    expect_run_refused({"Tooling/Die file=" + stl}, reason);
  };
  with_die("", "die.stl");
  with_die("solid die\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "die.stl");
  with_die(std::string("solid but binary") + std::string(68, ' ') + std::string("\x02\0\0\0", 4) +
               std::string(50, '\0'),
           "die.stl");
}

TEST(CommandLine, ADieInTheWrongUnitIsRefused) {
  ScratchFolder scratch;
  auto const first = (scratch / "first").string();
  ASSERT_EQ(run({"run", tiny_case(), "-o", first, "--quiet", "--threads", "1", "--until", "loading",
                 "--set", "Press programme/Stage 1/Gap=7.9 mm"})
                .status,
            0);
  auto const die = first + "/geometry/die.stl";
  expect_run_refused({"Tooling/Die file=" + die, "Tooling/STL scale=1 mm"}, "die.stl");
  expect_run_refused({"Tooling/Die file=" + die, "Tooling/Bore diameter=7 mm"}, "bore of 0.006 m");
}

TEST(CommandLine, PackingsThatCannotBePressedAreRefused) {
  ScratchFolder scratch;
  auto const file = (scratch / "packing.csv").string();
  auto const with_grains = [&](std::string const& rows, std::string const& reason) {
    support::put_bytes(file, "x [m],y [m],z [m],diameter [m],component\n" + rows);
    expect_run_refused({"Powder/Fill method=file", "Powder/Fill file=" + file}, reason);
  };
  with_grains("0,0,nan,1e-3,MgO\n", "nan");
  with_grains("0,0,4e-3,1e-3,MgO\n0.01,0,4e-3,1e-3,MgO\n", "1 of 2 grains start outside the die");
  with_grains("0,0,4e-3,1e-3,MgO\n0,0,4e-3,1e-3,MgO\n", "1 pairs of grains overlap");
  with_grains("0,0,4e-3,1e-3,quartz\n", "quartz");
}

TEST(CommandLine, AnotherRunsFolderIsNotOverwritten) {
  ScratchFolder scratch;
  auto const folder = (scratch / "out").string();
  fs::create_directory(folder);
  support::put_bytes(folder + "/notes.txt", "mine");
  expect_refused(run({"run", tiny_case(), "-o", folder}), "is not empty");
  auto const forced = run({"run", tiny_case(), "-o", folder, "--force", "--quiet", "--threads", "1",
                           "--until", "loading"});
  EXPECT_EQ(forced.status, 0) << forced.error;
  EXPECT_TRUE(fs::exists(folder + "/curves.csv"));
  EXPECT_EQ(support::bytes_of(folder + "/notes.txt"), "mine");
}

TEST(CommandLine, AnUnwritableFolderIsRefused) {
  expect_refused(run({"run", tiny_case(), "-o", "/proc/presscheck"}),
                 "/proc/presscheck: cannot be made");
  ScratchFolder scratch;
  support::put_bytes(scratch / "file", "");
  expect_refused(run({"run", tiny_case(), "-o", (scratch / "file").string()}), "is a file");
}

TEST(CommandLine, AFullDiskIsAFailureInOneLineAndKeepsTheLastRestart) {
  ScratchFolder scratch;
  auto const folder = (scratch / "out").string();
  // Blocks of 512 bytes, half way between the restart after loading, which fits, and the next one.
  fs::path const roomy = scratch / "roomy";
  ASSERT_EQ(run({"run", tiny_case(), "-o", roomy.string(), "--quiet", "--threads", "1"}).status, 0);
  auto const fits = fs::file_size(roomy / "restart_stage_loading.h5");
  auto const bursts = fs::file_size(roomy / "restart_stage_unloading.h5");
  ASSERT_GT(bursts, fits + 4096);
  auto const limit = "ulimit -f " + std::to_string((fits + bursts) / 2 / 512);
  auto const outcome =
      program::run_after(limit, {"run", tiny_case(), "-o", folder, "--quiet", "--threads", "1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
  EXPECT_NE(outcome.error.find("restart_stage_unloading.h5"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("the last good restart is " + folder + "/restart_stage_loading.h5"),
            std::string::npos)
      << outcome.error;
  EXPECT_EQ(run({"resume", folder, "--quiet", "--threads", "1"}).status, 0);
}

TEST(CommandLine, DamagedRestartsAreRefused) {
  ScratchFolder scratch;
  auto const folder = (scratch / "out").string();
  expect_refused(run({"resume", folder}), "does not exist");
  ASSERT_EQ(
      run({"run", tiny_case(), "-o", folder, "--quiet", "--threads", "1", "--until", "loading"})
          .status,
      0);
  auto const restart = folder + "/restart_stage_loading.h5";
  auto bytes = support::bytes_of(restart);
  bytes[bytes.size() / 2] ^= 1;
  support::put_bytes(restart, bytes);
  expect_refused(run({"resume", restart}), "restart_stage_loading.h5");
  expect_refused(run({"resume", folder}), "restart_stage_loading.h5");
  support::put_bytes(restart, bytes.substr(0, bytes.size() / 3));
  expect_refused(run({"resume", folder}), "restart_stage_loading.h5");
}

TEST(CommandLine, UnknownStagesAreRefused) {
  ScratchFolder scratch;
  expect_refused(run({"run", tiny_case(), "-o", (scratch / "out").string(), "--until", "fired"}),
                 "there is no such stage");
}

TEST(CommandLine, CheckDescribesAndWritesNothing) {
  ScratchFolder scratch;
  auto const here = fs::current_path();
  fs::current_path(scratch.path());
  auto const outcome = run({"check", tiny_case(), "--set", "Powder/Packing seed=3"});
  fs::current_path(here);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  for (auto const* what : {"grains", "time step", "steps", "memory", "estimated duration",
                           "solid fraction", "Rayleigh time", "triangles"})
    EXPECT_NE(outcome.out.find(what), std::string::npos) << what;
  EXPECT_TRUE(scratch.names().empty());
}

TEST(CommandLine, ProgressIsALineEveryTwentiethAndCanBeSilenced) {
  ScratchFolder scratch;
  auto const loud = run({"run", tiny_case(), "-o", (scratch / "loud").string(), "--threads", "1"});
  // 0 %, 5 %, ... 100 %, and not one line more.
  EXPECT_EQ(std::ranges::count(loud.error, '\n'), 21) << loud.error;
  for (auto const* what : {"loading", "height", "force", "overlap", "steps/s", "left"})
    EXPECT_NE(loud.error.find(what), std::string::npos) << what;
  auto const silent =
      run({"run", tiny_case(), "-o", (scratch / "silent").string(), "--threads", "1", "--quiet"});
  EXPECT_EQ(silent.error, "");
}

TEST(CommandLine, AGuardStopsTheRunWithEvidenceAndTheLastRestart) {
  ScratchFolder scratch;
  auto const folder = (scratch / "out").string();
  // The tiny bed reaches an overlap of 0.4 at the end of loading; settling first makes a restart.
  auto const outcome =
      run({"run", tiny_case(), "-o", folder, "--quiet", "--threads", "1", "--set",
           "Time stepping/Largest relative overlap=0.3", "--set", "Powder/Settle time=1 ms"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
  for (auto const* what : {"stage 'loading'", "overlap", "limit of 0.3", "restart_stage_settle.h5"})
    EXPECT_NE(outcome.error.find(what), std::string::npos) << outcome.error;
  EXPECT_FALSE(fs::exists(folder + "/summary.json"));
  auto const curves = coupling::read_curves(folder + "/curves.csv");
  for (auto const& row : curves.rows())
    for (double const value : row)
      EXPECT_TRUE(std::isfinite(value));
}

TEST(CommandLine, AnUnstableStepIsCaughtByItsHeat) {
  ScratchFolder scratch;
  auto const folder = (scratch / "out").string();
  auto const outcome = run({"run", tiny_case(), "-o", folder, "--quiet", "--threads", "1", "--set",
                            "Time stepping/Rayleigh fraction=0.5", "--set",
                            "Press programme/Stage 1/Speed=-0.2 m/s"});
  EXPECT_EQ(outcome.status, 1) << outcome.error;
  EXPECT_NE(outcome.error.find("Rayleigh fraction"), std::string::npos) << outcome.error;
}
