#include "coupling/record/curves.hpp"
#include "coupling/record/summary_file.hpp"

#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using coupling::parse_curves;
using coupling::PressRecord;
using coupling::Summary;
using support::ScratchFolder;

namespace {

PressRecord two_rows() {
  PressRecord record({{"time", "s"}, {"punch_gap", "m"}, {"upper_punch_force", "N"}});
  record.add_row("loading", {0.0, 0.02, -0.0});
  record.add_row("hold, \"long\"", {0.1, 1.0 / 3.0, 5e-324});
  return record;
}

std::string message_of(std::string const& text) {
  try {
    parse_curves(text, "run1.csv");
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Curves, HeaderNamesUnitsAndStageStandsSecond) {
  ScratchFolder const folder;
  write_curves(folder / "curves.csv", two_rows());
  EXPECT_EQ(support::bytes_of(folder / "curves.csv"),
            "time [s],stage,punch_gap [m],upper_punch_force [N]\n"
            "0,loading,0.02,-0\n"
            "0.1,\"hold, \"\"long\"\"\",0.3333333333333333,5e-324\n");
}

TEST(Curves, ReadBackToTheBit) {
  ScratchFolder const folder;
  PressRecord const before = two_rows();
  write_curves(folder / "curves.csv", before);
  PressRecord const after = coupling::read_curves(folder / "curves.csv");
  ASSERT_EQ(after.columns().size(), 3u);
  EXPECT_EQ(after.columns()[2].name, "upper_punch_force");
  EXPECT_EQ(after.columns()[2].unit, "N");
  EXPECT_EQ(after.stages(), before.stages());
  EXPECT_EQ(after.rows(), before.rows());
  EXPECT_TRUE(std::signbit(after.rows()[0][2]));
}

TEST(Curves, ObservedDataMayOrderItsColumnsAndLeaveValuesOut) {
  PressRecord const record = parse_curves("\xef\xbb\xbf# measured on Tuesday\r\n"
                                          "force [kN] , time [s]\r\n\r\n 1.5 , 0\r\nnan,+1e0\r\n",
                                          "run1.csv");
  EXPECT_EQ(record.columns()[0].unit, "kN");
  EXPECT_EQ(record.column("time"), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(record.column("force")[0], 1.5);
  EXPECT_TRUE(std::isnan(record.column("force")[1]));
  EXPECT_EQ(record.stages(), (std::vector<std::string>{"", ""}));
}

TEST(Curves, BadDataIsRefusedWithLineAndReason) {
  EXPECT_EQ(message_of("time [s],f [N]\n0,1\n"), "");
  EXPECT_TRUE(message_of("").starts_with("run1.csv: is empty"));
  EXPECT_TRUE(message_of("time [s]\n").starts_with("run1.csv: has no data"));
  EXPECT_TRUE(message_of("time\n0\n").starts_with("run1.csv:1: column 'time' has no unit"));
  EXPECT_TRUE(message_of("[s]\n0\n").starts_with("run1.csv:1: column '[s]' has no unit"));
  EXPECT_TRUE(message_of("time []\n0\n").starts_with("run1.csv:1: column 'time []' has no unit"));
  EXPECT_TRUE(
      message_of("#\nt [s],t [s]\n0,1\n").starts_with("run1.csv:2: column 't' occurs twice"));
  EXPECT_TRUE(message_of("t [s],f [N]\n0,1\n1\n").starts_with("run1.csv:3: has 1 fields"));
  EXPECT_TRUE(message_of("t [s],f [N]\n0,1\n1,2,3\n").starts_with("run1.csv:3: has 3 fields"));
  EXPECT_TRUE(
      message_of("t [s],f [N]\n0,1 N\n").starts_with("run1.csv:2: f = '1 N': is no number"));
  EXPECT_TRUE(message_of("t [s],f [N]\n0,\n").starts_with("run1.csv:2: f = '': is no number"));
  EXPECT_TRUE(message_of("t [s],f [N]\n0,1e999\n")
                  .starts_with("run1.csv:2: f = '1e999': is no number that"));
  EXPECT_TRUE(message_of("t [s],f [N]\n0,\"1\n").starts_with("run1.csv:2: a quote is not closed"));
}

TEST(Curves, ContinueFromTheTimeOfARestart) {
  PressRecord const record = two_rows();
  EXPECT_EQ(until(record, 0.05).size(), 1u);
  EXPECT_EQ(until(record, 0.1).size(), 2u); // the row at the restart's own time had been written
  EXPECT_EQ(until(record, -1.0).size(), 0u);
}

TEST(SummaryFile, HasTheKeysOfTheContractAndNullForWhatWasNotReached) {
  Summary summary;
  summary.max_force = 1471.25;
  summary.springback = std::numeric_limits<double>::quiet_NaN();
  summary.version = "0.1.0";
  summary.checks = {{"energy", 0.004, 0.01, true}};
  summary.tools = {{.name = "die"}};
  auto const json = nlohmann::json::parse(coupling::summary_json(summary));
  for (auto const* key :
       {"max_force_N", "porosity", "porosity_core", "compact_height_m", "springback",
        "shape_quality", "shape_similarity", "grains", "steps", "time_step_s", "wall_seconds",
        "particle_steps_per_second", "mode", "version", "checks", "tools", "ejection_force_N"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json.size(), 17u);
  EXPECT_EQ(json["max_force_N"], 1471.25);
  EXPECT_TRUE(json["springback"].is_null());
  EXPECT_TRUE(json["shape_quality"].is_null());
  EXPECT_EQ(json["checks"][0]["name"], "energy");
  EXPECT_EQ(json["checks"][0]["ok"], true);
  EXPECT_EQ(json["tools"][0]["name"], "die");
  EXPECT_TRUE(json["tools"][0]["max_von_mises_Pa"].is_null());
}

TEST(SummaryFile, ReadsBackWhatItWrote) {
  ScratchFolder const folder;
  Summary before;
  before.max_force = 1.0 / 3.0;
  before.ejection_force = 11.5;
  before.porosity = 0.1;
  before.porosity_core = 0.2;
  before.compact_height = 0.011;
  before.springback = std::numeric_limits<double>::quiet_NaN();
  before.shape_quality = 4;
  before.shape_similarity = 0.98;
  before.grains = 3000;
  before.steps = (std::uint64_t{1} << 53) + 1;
  before.time_step = 1e-7;
  before.wall_seconds = 12.5;
  before.particle_steps_per_second = 5e6;
  before.mode = "rigid";
  before.version = "0.1.0";
  before.checks = {{"a", 1.0, 2.0, true}, {"b", 3.0, 2.0, false}};
  before.tools = {{.name = "die",
                   .max_von_mises = 2e8,
                   .where = {1.0, 2.0, 3.0},
                   .valid_below_depth = 1e-4,
                   .yield_utilisation = 0.5,
                   .contact_share = 0.55},
                  {.name = "upper_punch"}};
  write_summary(folder / "summary.json", before);
  Summary const after = coupling::read_summary(folder / "summary.json");
  EXPECT_EQ(coupling::summary_json(after), coupling::summary_json(before));
  EXPECT_EQ(after.max_force, before.max_force);
  EXPECT_EQ(after.ejection_force, 11.5);
  EXPECT_EQ(after.tools[0].contact_share, 0.55);
  EXPECT_EQ(after.steps, before.steps);
  EXPECT_EQ(after.shape_quality, 4);
  EXPECT_TRUE(std::isnan(after.springback));
  EXPECT_FALSE(after.checks[1].ok);
  EXPECT_EQ(after.tools[0].where, before.tools[0].where);
  EXPECT_TRUE(std::isnan(after.tools[1].max_von_mises));
}

TEST(SummaryFile, RefusesWhatIsNoSummary) {
  ScratchFolder const folder;
  for (auto const* text : {"", "{", "[]", "{}", R"({"max_force_N": "much"})"}) {
    coupling::write_file(folder / "summary.json", text);
    EXPECT_THROW(coupling::read_summary(folder / "summary.json"), dem::InvalidInput) << text;
  }
}
