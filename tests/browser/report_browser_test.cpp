#include "coupling/record/atomic_file.hpp"
#include "coupling/report/report.hpp"
#include "tests/browser/chromium.hpp"
#include "tests/support/sample_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using ::testing::Test;

struct ReportInBrowser : Test {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("presscheck-report-" +
       std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
  std::string const drive =
      coupling::read_file(PRESSCHECK_SOURCE_DIR "/tests/browser/drive_report.js");

  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  browser::Page use(coupling::ReportData const& data) {
    coupling::write_report(folder / "report.html", data);
    return browser::open(folder / "report.html", drive);
  }
};

void expect_between(browser::Page const& page, std::string const& name, double low, double high) {
  EXPECT_GE(page.number(name), low) << name;
  EXPECT_LE(page.number(name), high) << name;
}

TEST_F(ReportInBrowser, ShowsAllChartsAndGrainsWithoutNetworkOrErrors) {
  auto const page = use(sample::report_data());
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.note("driven"), "to the end");
  EXPECT_EQ(page.note("ready"), "1");
  EXPECT_EQ(page.note("charts"), "7");
  EXPECT_EQ(page.note("grains"), "3000");
  // 400 rows: 2 forces, 1 force over gap whose turning point is in both branches, 3 heights, 1
  // overlap, 2 of the wall, 5 energies.
  EXPECT_EQ(page.note("points"), std::to_string(400 * (2 + 1 + 3 + 1 + 2 + 5) + 1));
  EXPECT_EQ(page.note("fetched"), "");
  EXPECT_EQ(page.note("too-wide"), "false");
  EXPECT_EQ(page.note("nameless"), "0");
  EXPECT_EQ(page.note("bad-text"), "0");
}

TEST_F(ReportInBrowser, DrawsTheStressedTools) {
  auto data = sample::report_data();
  data.summary.tools = {{.name = "upper_punch", .max_von_mises = 40e6}};
  data.stressed = sample::stress_picture();
  auto const page = use(data);
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.note("driven"), "to the end");
  EXPECT_EQ(page.note("stressed"), "4"); // triangles
  expect_between(page, "stressed-painted", 2.0, 60.0);
  EXPECT_NE(page.note("bar-von-mises").find("von Mises stress [MPa]"), std::string::npos);
}

TEST_F(ReportInBrowser, TurnsCutsAndColoursTheCompact) {
  auto const page = use(sample::report_data());
  ASSERT_EQ(page.note("driven"), "to the end");
  // The bed covers about a quarter of the picture; each act changes a good part of that, and none
  // of the ground.
  expect_between(page, "painted", 10.0, 60.0);
  expect_between(page, "turned-by-mouse", 5.0, 60.0);
  expect_between(page, "turned-by-key", 5.0, 60.0);
  expect_between(page, "zoomed", 5.0, 70.0);
  expect_between(page, "cut", 2.0, 60.0);
  EXPECT_EQ(page.note("cut-text"), "50 per cent");
  expect_between(page, "cut-across", 2.0, 60.0);
  expect_between(page, "coloured-by-component", 5.0, 60.0);
  expect_between(page, "without-tools", 0.1, 10.0);
  EXPECT_EQ(page.note("after-reset"), "0.00");
  EXPECT_NE(page.note("bar-stress").find("[MPa]"), std::string::npos);
  EXPECT_NE(page.note("bar-overlap").find("[µm]"), std::string::npos);
  EXPECT_NE(page.note("bar-component").find("MgOAl2O3"), std::string::npos);
  EXPECT_NE(page.note("grain-under-pointer").find("stress"), std::string::npos)
      << page.note("grain-under-pointer");
}

TEST_F(ReportInBrowser, ReadsValuesOffTheChartsAndZooms) {
  auto const page = use(sample::report_data());
  ASSERT_EQ(page.note("driven"), "to the end");
  // Row 239 of 400 is the last one of the way down: t = 0.1 s * 239/399 = 59.90 ms, next to 60 % of
  // the axis.
  EXPECT_NE(page.note("tip").find("time 59.90 ms"), std::string::npos) << page.note("tip");
  EXPECT_NE(page.note("tip").find("kN"), std::string::npos);
  EXPECT_NE(page.note("tip-gap").find("gap between the punches"), std::string::npos)
      << page.note("tip-gap");
  EXPECT_EQ(page.note("lines"), "2");
  EXPECT_EQ(page.note("lines-without-upper"), "1");
  EXPECT_NE(page.note("zoomed-axis").find("|55|"), std::string::npos) << page.note("zoomed-axis");
  EXPECT_EQ(page.note("axis-restored"), "true");
}

TEST_F(ReportInBrowser, ShowsHostileTextAsText) {
  auto data = sample::report_data();
  std::string const attack =
      "</script><script>document.documentElement.dataset.hacked='1'</script>"
      "<img src=x onerror=\"document.documentElement.dataset.hacked='2'\">{{case}}";
  data.title = attack;
  data.components = {attack, attack};
  data.tools[0].name = attack;
  data.observed[0].source = attack;
  data.provenance[0] = {attack, attack};
  data.summary.checks[0].name = attack;
  data.resolved_case = attack;
  coupling::PressRecord record(
      {{"time", "s"}, {"punch_gap", "m"}, {"upper_punch_force", "N"}, {attack, "J"}});
  for (int k = 0; k < 3; ++k)
    record.add_row(attack, {0.1 * k, 0.02 - 0.001 * k, 10.0 * k, 1.0});
  data.record = record;
  auto const page = use(data);
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.note("driven"), "to the end");
  EXPECT_EQ(page.note("ready"), "1");
  EXPECT_EQ(page.note("hacked"), "(absent)");
  EXPECT_EQ(page.dom.find("<img"), std::string::npos);
}

TEST_F(ReportInBrowser, SurvivesARunThatReachedNothing) {
  coupling::ReportData data;
  double const nan = std::numeric_limits<double>::quiet_NaN();
  data.title = "stopped at once";
  data.summary.porosity = data.summary.compact_height = data.summary.springback =
      data.summary.max_force = nan;
  data.record = coupling::PressRecord(
      {{"time", "s"}, {"punch_gap", "m"}, {"upper_punch_force", "N"}, {"mean_overlap", "m"}});
  data.record.add_row("loading", {0.0, nan, nan, nan});
  auto const page = use(data);
  EXPECT_EQ(page.console, "");
  EXPECT_EQ(page.note("driven"), "to the end");
  EXPECT_EQ(page.note("charts"), "0");
  EXPECT_EQ(page.note("bad-text"), "0");
  EXPECT_NE(page.dom.find("This run kept no grains to show."), std::string::npos);
  EXPECT_NE(page.dom.find("not reached"), std::string::npos);
}

} // namespace
