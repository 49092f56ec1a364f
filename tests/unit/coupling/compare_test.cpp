#include "coupling/compare/compare.hpp"
#include "coupling/compare/force_curve.hpp"
#include "coupling/compare/kept_observed.hpp"
#include "coupling/record/summary_file.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace {

using coupling::Agreement;
using coupling::compare;
using coupling::Comparison;
using coupling::PressRecord;
using coupling::read_sources;
using coupling::Source;

double const nan = std::numeric_limits<double>::quiet_NaN();

/// Force rises linearly from 0 at 10 mm to `peak` at 8 mm and falls linearly to 0 at 8.5 mm; then
/// the punch goes on to 10 mm.
PressRecord triangle(double peak, int n_rows = 81) {
  PressRecord record({{"time", "s"}, {"punch_gap", "m"}, {"upper_punch_force", "N"}});
  for (int k = 0; k < n_rows; ++k) {
    double const down = static_cast<double>(k) / (n_rows - 1);
    record.add_row("loading", {down, 10e-3 - 2e-3 * down, peak * down});
  }
  for (int k = 1; k < n_rows; ++k) {
    double const up = 2e-3 * k / (n_rows - 1);
    record.add_row("unloading", {1.0 + up, 8e-3 + up, peak * std::max(0.0, 1.0 - up / 0.5e-3)});
  }
  return record;
}

Source curve(std::string label, double peak) {
  return {.label = std::move(label), .record = triangle(peak), .values = {}};
}

coupling::QuantityRow const& row(Comparison const& c, std::string const& name) {
  auto const found = std::ranges::find(c.quantities, name, &coupling::QuantityRow::name);
  if (found == c.quantities.end())
    throw std::out_of_range("no row " + name);
  return *found;
}

std::string message_of(auto const& act) {
  try {
    act();
  } catch (dem::InvalidInput const& error) {
    return error.what();
  }
  return "no error";
}

#define EXPECT_IN(part, text) EXPECT_NE((text).find(part), std::string::npos) << (text)

// Work of a triangle: 1/2 peak x base. Down: 1/2 1000 N 2 mm = 1 J; back: 1/2 1000 N 0.5 mm = 0.25
// J. The trapezoidal rule is exact on straight lines whose corners are rows: 80 rows over 2 mm put
// one at 8.5 mm.
TEST(ForceCurve, IntegratesTheTrianglesOfAPressCycle) {
  auto const found = coupling::force_curve(triangle(1000.0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->loading_work, 1.0, 1e-12);
  EXPECT_NEAR(found->unloading_work, 0.25, 1e-12);
  EXPECT_DOUBLE_EQ(found->smallest_gap, 8e-3);
  EXPECT_DOUBLE_EQ(found->peak, 1000.0);
  EXPECT_EQ(found->loading.gap.size(), 81U);
  EXPECT_DOUBLE_EQ(found->loading.gap.front(), 8e-3);
}

TEST(ForceCurve, LeavesOutRowsThatWereNotMeasured) {
  auto record = triangle(1000.0);
  record.add_row("after", {3.0, nan, 5000.0});
  record.add_row("after", {3.1, 1e-3, nan});
  auto const found = coupling::force_curve(record);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->loading_work, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(found->peak, 1000.0);
  EXPECT_DOUBLE_EQ(found->smallest_gap, 8e-3);
}

// A dwell holds the gap while the force relaxes from 1000 N to 800 N: no work in between, and
// unloading starts at 800 N.
TEST(ForceCurve, DoesNoWorkInADwell) {
  PressRecord record({{"punch_gap", "m"}, {"upper_punch_force", "N"}});
  for (auto const& [gap, force] :
       {std::pair{10e-3, 0.0}, {8e-3, 1000.0}, {8e-3, 900.0}, {8e-3, 800.0}, {9e-3, 0.0}})
    record.add_row("", {gap, force});
  auto const found = coupling::force_curve(record);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->loading_work, 1.0, 1e-12);
  EXPECT_NEAR(found->unloading_work, 0.4, 1e-12);
  EXPECT_DOUBLE_EQ(found->unloading.force.front(), 800.0);
  EXPECT_DOUBLE_EQ(found->loading.force.front(), 1000.0);
}

TEST(ForceCurve, NeedsGapAndForce) {
  PressRecord record({{"time", "s"}, {"upper_punch_force", "N"}});
  record.add_row("", {0.0, 1.0});
  EXPECT_FALSE(coupling::force_curve(record));
}

// Forces 1.5 % higher everywhere: the largest difference is 1.5 % of the peak, at the smallest gap;
// over a straight line through zero the root mean square is that / sqrt(3) = 0.866 % (0.867 % on
// 401 points).
TEST(BranchDifference, OfAStretchedTriangleIsItsClosedForm) {
  auto const reference = coupling::force_curve(triangle(1000.0));
  auto const other = coupling::force_curve(triangle(1015.0, 301));
  auto const found = coupling::difference(reference->loading, other->loading, reference->peak);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->largest, 0.015, 1e-9);
  EXPECT_NEAR(found->at_gap, 8e-3, 1e-12);
  EXPECT_NEAR(found->rms, 0.015 / std::sqrt(3.0), 1.5e-5);
}

// Unloading carries force up to 8.5 mm only; the empty way to 10 mm must not dilute the root mean
// square.
TEST(BranchDifference, CountsOnlyGapsWhereSomethingIsCarried) {
  auto const reference = coupling::force_curve(triangle(1000.0));
  auto const other = coupling::force_curve(triangle(1020.0));
  auto const found = coupling::difference(reference->unloading, other->unloading, reference->peak);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rms, 0.02 / std::sqrt(3.0),
              6e-4); // the grid may reach one row of 25 um past 8.5 mm
}

TEST(BranchDifference, NeedsGapsInCommon) {
  coupling::ForceBranch const low{{1e-3, 2e-3}, {5.0, 0.0}};
  coupling::ForceBranch const high{{3e-3, 4e-3}, {5.0, 0.0}};
  EXPECT_FALSE(coupling::difference(low, high, 5.0));
}

TEST(Compare, JudgesEachQuantityAgainstItsTolerance) {
  auto const c = compare({curve("a", 1000.0), curve("b", 1009.0), curve("c", 1011.0)});
  auto const& force = row(c, "max_force");
  EXPECT_NEAR(force.differences[1], 0.009, 1e-12);
  EXPECT_TRUE(std::isnan(force.differences[0]));
  EXPECT_EQ(force.agreement[0], Agreement::unknown);
  EXPECT_EQ(force.agreement[1], Agreement::within); // 0.9 % of 1 %
  EXPECT_EQ(force.agreement[2], Agreement::beyond); // 1.1 % of 1 %
  EXPECT_EQ(row(c, "loading_work").agreement[2], Agreement::within);
  EXPECT_EQ(c.curves.size(), 4U);
  EXPECT_EQ(c.n_beyond(), 1U);
  // force, gap, two works, two branches for each of two sources
  EXPECT_EQ(c.n_compared(), 12U);
  EXPECT_IN("1 of 12", in_words(c));
  EXPECT_IN("largest punch force of c +1.10 %", in_words(c));
}

TEST(Compare, FindsACurveThatLeavesWhileThePeakStays) {
  auto bent = triangle(1000.0);
  PressRecord changed(bent.columns());
  for (auto values : bent.rows()) {
    if (values[0] < 1.0)
      values[2] *=
          1.0 - 0.12 * (1.0 - values[0]); // at half way 500 N become 470 N: 3 % of the peak
    changed.add_row("", values);
  }
  auto const c = compare({curve("a", 1000.0), {.label = "b", .record = changed, .values = {}}});
  EXPECT_EQ(row(c, "max_force").agreement[1], Agreement::within);
  EXPECT_EQ(c.curves[0].branch, "loading");
  EXPECT_NEAR(c.curves[0].largest, 0.03, 1e-5);
  EXPECT_NEAR(c.curves[0].at_gap, 9e-3, 1e-5);
  EXPECT_EQ(c.curves[0].agreement, Agreement::beyond);
  EXPECT_EQ(c.curves[1].agreement, Agreement::within);
}

// springback = compact height / smallest gap - 1 = 9.6 / 8 - 1 = 0.2
TEST(Compare, TakesSpringbackFromHeightAndGap) {
  auto a = curve("a", 1000.0);
  auto b = curve("b", 1000.0);
  a.values["compact_height"] = {9.6e-3};
  b.values["compact_height"] = {9.7e-3};
  auto const c = compare({a, b});
  EXPECT_NEAR(row(c, "springback").values[0], 0.2, 1e-12);
  EXPECT_NEAR(row(c, "springback").differences[1], 0.0125, 1e-12);
  EXPECT_EQ(row(c, "springback").agreement[1], Agreement::beyond);
  EXPECT_EQ(row(c, "compact_height").agreement[1], Agreement::beyond); // 1.04 % of 1 %
}

TEST(Compare, GrantsTwoStandardUncertainties) {
  Source a{.label = "a", .record = PressRecord({}), .values = {{"max_force", {1000.0, 30.0}}}};
  Source b{.label = "b", .record = PressRecord({}), .values = {{"max_force", {1099.0, 40.0}}}};
  auto const c = compare({a, b});
  EXPECT_TRUE(c.agrees()); // 2 sqrt(30^2 + 40^2) = 100
  EXPECT_NEAR(row(c, "max_force").allowed[1], 0.1, 1e-12);
  b.values["max_force"].value = 1101.0;
  EXPECT_FALSE(compare({a, b}).agrees());
}

TEST(Compare, SaysWhatIsMissing) {
  Source paper{.label = "paper", .record = PressRecord({}), .values = {{"max_force", {1000.0}}}};
  auto const c = compare({curve("run", 1000.0), paper});
  std::string all;
  for (auto const& sentence : c.missing)
    all += sentence;
  EXPECT_IN("no rows with both punch_gap and upper_punch_force in paper", all);
  EXPECT_IN("work of loading: not known for paper", all);
  EXPECT_EQ(c.quantities.size(), 1U);
}

TEST(Compare, RefusesOneSourceAndSourcesWithNothingInCommon) {
  EXPECT_IN("only source", message_of([] { compare({curve("alone", 1.0)}); }));
  Source a{.label = "a", .record = PressRecord({}), .values = {{"porosity", {0.4}}}};
  Source b{.label = "b", .record = PressRecord({}), .values = {{"max_force", {1.0}}}};
  EXPECT_IN("no quantity in common", message_of([&] { compare({a, b}); }));
}

TEST(Compare, NamesTheFirstFewOfManyDifferences) {
  std::vector<Source> sources = {curve("a", 1000.0)};
  for (int k = 0; k < 9; ++k)
    sources.push_back(
        {.label = "b", .record = PressRecord({}), .values = {{"max_force", {2000.0}}}});
  auto const text = in_words(compare(sources));
  EXPECT_IN("9 of 9", text);
  EXPECT_IN("of b (6) +100.00 %; and 3 more.", text);
}

TEST(Compare, TellsEqualLabelsApart) {
  auto const c = compare({curve("run", 1.0), curve("run", 1.0)});
  EXPECT_EQ(c.sources[0].label, "run");
  EXPECT_EQ(c.sources[1].label, "run (2)");
}

TEST(ReadSources, ReadsARunFolder) {
  support::ScratchFolder folder;
  support::put_bytes(folder / "curves.csv", "time [s],stage,punch_gap [m],upper_punch_force [N]\n"
                                            "0,loading,0.01,0\n1,loading,0.008,1000\n");
  coupling::Summary summary;
  summary.max_force = 1001.0;
  summary.porosity = 0.4;
  summary.compact_height = nan;
  coupling::write_summary(folder / "summary.json", summary);
  auto const sources = read_sources(folder.path());
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].label, folder.path().filename().string());
  EXPECT_EQ(sources[0].values.at("max_force").value, 1001.0);
  EXPECT_FALSE(sources[0].values.contains("compact_height"));
  EXPECT_EQ(sources[0].record.size(), 2U);
}

TEST(ReadSources, ConvertsUnitsAndRefusesTheWrongOnes) {
  support::ScratchFolder folder;
  support::put_bytes(folder / "observed.csv",
                     "punch_gap [mm],upper_punch_force [kN]\n10,0\nnan,0.5\n8,1.25\n");
  auto const source = read_sources(folder / "observed.csv").front();
  EXPECT_EQ(source.label, "observed");
  EXPECT_DOUBLE_EQ(source.record.column("punch_gap")[2], 8e-3);
  EXPECT_DOUBLE_EQ(source.record.column("upper_punch_force")[2], 1250.0);
  support::put_bytes(folder / "wrong.csv", "punch_gap [N],upper_punch_force [N]\n1,2\n");
  EXPECT_IN("punch_gap is in N", message_of([&] { read_sources(folder / "wrong.csv"); }));
  support::put_bytes(folder / "unknown.csv", "punch_gap [furlong]\n1\n");
  EXPECT_IN("furlong", message_of([&] { read_sources(folder / "unknown.csv"); }));
}

TEST(ReadSources, ReadsATableOfPublishedValues) {
  support::ScratchFolder folder;
  support::put_bytes(
      folder / "paper.csv",
      "# source: a paper\n"
      "setup,simulator,max_force [kN],porosity [%],porosity_sd [%],shape_quality [1]\n"
      "E0250,EDEM,1.618,42.01,0.5,4\nE0250,LIGGGHTS,1.6,,,nan\nE2500,EDEM,16,,,\n");
  auto const sources = read_sources(folder / "paper.csv");
  ASSERT_EQ(sources.size(), 3U);
  EXPECT_EQ(sources[2].label, "paper E2500 EDEM");
  EXPECT_NEAR(sources[0].values.at("porosity").value, 0.4201, 1e-12);
  EXPECT_NEAR(sources[0].values.at("porosity").sd, 0.005, 1e-12);
  EXPECT_NEAR(sources[0].values.at("max_force").value, 1618.0, 1e-9);
  EXPECT_EQ(sources[1].values.size(), 1U); // the empty and the nan field are left out
  EXPECT_EQ(read_sources(folder.path().string() + "/paper.csv:E0250").size(), 2U);
  EXPECT_IN("has no setup E9",
            message_of([&] { read_sources(folder.path().string() + "/paper.csv:E9"); }));
  auto const of_setup = coupling::read_observed_values(folder / "paper.csv", "E2500");
  ASSERT_EQ(of_setup.size(), 1U);
  EXPECT_EQ(of_setup[0].unit, "N");
  EXPECT_EQ(of_setup[0].source, "paper E2500 EDEM");
  coupling::Summary summary;
  summary.max_force = 15000.0;
  auto const rows = coupling::beside_observed(summary, of_setup);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].theirs, 16000.0, 1e-9);
}

TEST(KeptObserved, RowsOfTheSetupTravelWithTheRun) {
  support::ScratchFolder folder;
  std::filesystem::create_directories(folder / "observed");
  support::put_bytes(folder / "observed/paper.csv", "# source: a paper\n"
                                                    "setup,simulator,max_force [kN]\n"
                                                    "E0250,\"EDEM, 2\",1.6\nE2500,EDEM,16\n");
  support::put_bytes(folder / "observed/machine.csv", "max_force [N]\n25095\n");
  EXPECT_TRUE(coupling::observed_rows(folder / "case.prm", "").empty());
  EXPECT_TRUE(coupling::observed_rows(folder / "case.prm", "E9").empty());
  auto const run = folder / "run";
  std::filesystem::create_directories(run);
  coupling::keep_observed(coupling::observed_rows(folder / "case.prm", "E0250"), run);
  auto const kept = coupling::kept_observed(run);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_NEAR(kept[0].value, 1600.0, 1e-9);
  EXPECT_EQ(kept[0].source, "paper E0250 EDEM, 2");
  EXPECT_TRUE(coupling::kept_observed(folder / "elsewhere").empty());
}

TEST(ReadSources, ReadsMeasuredDataWithItsScalars) {
  support::ScratchFolder folder;
  support::put_bytes(
      folder / "measured.json",
      R"({"runs": [{"file": "run1.csv", "scalars": {"compact_height": {"value": 9.55, "sd": 0.02, "unit": "mm"}}}]})");
  support::put_bytes(folder / "run1.csv",
                     "time [s],punch_gap [m],upper_punch_force [N]\n0,0.01,0\n1,0.008,10\n");
  auto const source = read_sources(folder.path()).front();
  EXPECT_NEAR(source.values.at("compact_height").value, 9.55e-3, 1e-15);
  EXPECT_NEAR(source.values.at("compact_height").sd, 2e-5, 1e-15);
  EXPECT_EQ(source.record.size(), 2U);
  support::put_bytes(folder / "measured.json", R"({"runs": [{"scalars": {}}]})");
  EXPECT_IN("measured.json", message_of([&] { read_sources(folder.path()); }));
}

TEST(ReadSources, RefusesWhatIsNoSource) {
  support::ScratchFolder folder;
  EXPECT_IN("does not exist", message_of([&] { read_sources(folder / "nothing"); }));
  EXPECT_IN("neither curves.csv nor measured.json",
            message_of([&] { read_sources(folder.path()); }));
  auto const t = folder / "t.csv";
  auto const message_for = [&](char const* text) {
    support::put_bytes(t, text);
    return message_of([&] { read_sources(t); });
  };
  EXPECT_IN("t.csv:1: has no column 'name [unit]'", message_for("max_force,porosity\n1,2\n"));
  EXPECT_IN("t.csv:2", message_for("max_force [N]\nmany\n"));
  EXPECT_IN("max_force_sd = -1", message_for("max_force [N],max_force_sd [N]\n5,-1\n"));
  EXPECT_IN("t.csv:2: has 1 fields", message_for("max_force [N],porosity [1]\n1\n"));
  EXPECT_IN("holds no values", message_for("max_force [N]\n"));
}

TEST(WriteComparison, WritesThePageAndItsNumbers) {
  support::ScratchFolder folder;
  auto const attack = std::string("</script><script>alert(1)</script>");
  auto const c = compare({curve("a", 1000.0), curve(attack, 1011.0)});
  coupling::write_comparison(folder / "out.html", c);
  auto const page = support::bytes_of(folder / "out.html");
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_IN("They differ.", page);
  auto const json = nlohmann::json::parse(support::bytes_of(folder / "comparison.json"));
  EXPECT_EQ(json["ok"], false);
  EXPECT_EQ(json["beyond"], 1);
  EXPECT_EQ(json["sources"][1], attack);
  EXPECT_EQ(json["quantities"][0]["name"], "max_force");
  EXPECT_TRUE(json["quantities"][0]["differences"][0].is_null());
  EXPECT_NEAR(json["quantities"][0]["differences"][1], 0.011, 1e-12);
  EXPECT_EQ(json["quantities"][0]["ok"][1], false);
  EXPECT_NEAR(json["curves"][0]["max_difference"], 0.011, 1e-9);
}

} // namespace
