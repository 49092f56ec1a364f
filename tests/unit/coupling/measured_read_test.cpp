#include "tests/unit/coupling/measured_folder.hpp"

namespace coupling::measured {
namespace {

using testing::Test;
using Words = std::vector<std::string>;

class MeasuredRead : public MeasuredTexts {};

TEST_F(MeasuredRead, TakesValuesInSi) {
  auto const data = read();
  EXPECT_EQ(data.sample.mass, (Uncertain{9.13e-3, 1e-5}));
  EXPECT_EQ(data.sample.die_diameter, (Uncertain{22.05e-3, 5e-6}));
  EXPECT_EQ(*data.channel("punch_gap"), (Channel{"punch_gap", "m", 2e-6}));
  EXPECT_EQ(*data.channel("upper_punch_force"), (Channel{"upper_punch_force", "N", 12.0}));
  EXPECT_EQ(data.channel("ejection_force"), nullptr);
  EXPECT_EQ(data.gap_source, GapSource::commanded);
  ASSERT_EQ(data.runs.size(), 2u);
  auto const& run = data.runs[0];
  EXPECT_EQ(run.file, "run1.csv");
  EXPECT_EQ(run.role, Role::fit);
  EXPECT_EQ(data.runs[1].role, Role::held_out);
  EXPECT_EQ(run.press, (PressProtocol{5e-5, 5e-4, 8e-3, 11e-3, {}}));
  auto const rows = press_rows();
  ASSERT_EQ(run.time.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(run.time[k], rows[k].time);
    EXPECT_EQ(run.channel("punch_gap")[k], rows[k].gap);
    EXPECT_EQ(run.channel("upper_punch_force")[k], rows[k].force);
    EXPECT_EQ(run.rows[k], k + 2);
  }
  EXPECT_EQ(decisions(), Words{});
}

TEST_F(MeasuredRead, TakesScalarsAndDwell) {
  replace(json_, "\"role\": \"fit\"",
          "\"role\": \"fit\", \"scalars\": {\"compact_height\": {\"value\": \"9.55 mm\", \"sd\": "
          "\"20 um\"}, \"porosity\": {\"value\": 26.08, \"sd\": 0.5, \"unit\": \"%\"}}");
  replace(json_, "\"speed_down\": 5e-05", "\"dwell\": \"2 s\", \"speed_down\": \"3 mm/min\"");
  auto const run = read().runs[0];
  EXPECT_EQ(run.scalars.at("compact_height"), (Uncertain{9.55e-3, 20e-6}));
  EXPECT_EQ(run.scalars.at("porosity"), (Uncertain{0.2608, 0.005}));
  EXPECT_EQ(run.press.dwell, 2.0);
  EXPECT_DOUBLE_EQ(run.press.speed_down, 5e-5);
}

TEST_F(MeasuredRead, TakesAPressingWithoutACurve) {
  json_ = numbers_alone();
  auto const data = read();
  EXPECT_TRUE(data.has_numbers_alone());
  EXPECT_FALSE(MeasuredTexts::read(description(), files_).has_numbers_alone());
  ASSERT_EQ(data.runs.size(), 1u);
  EXPECT_EQ(data.runs[0].file, "one");
  EXPECT_EQ(data.runs[0].scalars.at("max_force"), (Uncertain{25095.0, 25.0}));
  EXPECT_EQ(data.sample.solid_density, (Uncertain{3520.0, 80.0}));
  // The canonical form reads back the same.
  auto const texts = print_measured(data);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_EQ(print_measured(MeasuredTexts::read(texts.at("measured.json"), {})), texts);
}

TEST_F(MeasuredRead, KeepsGapsAndCountsThem) {
  for (std::size_t const row : {7, 8, 9, 20})
    set_row(row,
            fmt::format("{},{},nan", row - 2, fill_height - speed * static_cast<double>(row - 2)));
  auto const run = read().runs[0];
  EXPECT_EQ(run.time.size(), press_rows().size());
  EXPECT_TRUE(std::isnan(run.channel("upper_punch_force")[5]));
  EXPECT_EQ(decisions(), (Words{"run1.csv: 4 of 69 readings of upper_punch_force are missing and "
                                "stay gaps: rows 7 to 9 and 20"}));
}

TEST_F(MeasuredRead, SeesASpikeBesideALargerOne) {
  set_row(12, "10,0.0105,99999999");
  set_row(14, "12,0.0104,999999");
  auto const run = read().runs[0];
  EXPECT_EQ(run.time.size(), press_rows().size() - 2);
  EXPECT_EQ(std::ranges::count(run.rows, 12u) + std::ranges::count(run.rows, 14u), 0);
}

TEST_F(MeasuredRead, LeavesAFewCorruptRowsOutAndNamesThem) {
  set_row(10, "8,0.0106");
  set_row(30, "28,0.0096,2.5e3e");
  set_row(50, "48,0.0086,99999999");
  auto const run = read().runs[0];
  EXPECT_EQ(run.time.size(), press_rows().size() - 3);
  EXPECT_EQ(std::ranges::count(run.rows, 50u), 0);
  EXPECT_EQ(decisions(),
            (Words{"run1.csv:10: left out: it has 2 fields and the header 3",
                   "run1.csv:30: left out: upper_punch_force = '2.5e3e' is no number",
                   "run1.csv:50: left out: upper_punch_force = 1e+08 N leaves the line between its "
                   "neighbours, 12016.6 and 13616.8, for one reading (an error of transmission)"}));
}

TEST_F(MeasuredRead, LeavesRepeatedRowsOut) {
  set_row(21, "18,0.0101,675");
  set_row(20, "18,0.0101,675");
  EXPECT_EQ(decisions(), (Words{"run1.csv:21: left out: repeats row 20"}));
  set_row(21, "18,0.0101,700");
  EXPECT_EQ(decisions(),
            (Words{"run1.csv:21: left out: contradicts row 20 at the same time, 18 s"}));
}

TEST_F(MeasuredRead, DoesNotTakeTheTurnForASpike) {
  // Three readings in all of the way back: the peak stands alone.
  auto rows = press_rows();
  std::erase_if(rows, [](Row const& row) { return row.force > 2e3 && row.gap > end_gap; });
  for (auto& row : rows)
    if (row.time > 60)
      row.force = 0;
  files_["run1.csv"] = csv(rows);
  auto const force = read().runs[0].series.at("upper_punch_force");
  EXPECT_NEAR(*std::ranges::max_element(force), 25e3, 1e-9);
}

TEST_F(MeasuredRead, SaysWhatOneRunCannotShow) {
  json_ = json_.substr(0, json_.find(",\n    {\"file\": \"run2.csv\"")) + "]}";
  EXPECT_EQ(
      decisions(),
      (Words{"one run only: it is fitted, no gain on unseen data can be measured, and scatter "
             "between pressings is not known"}));
}

TEST_F(MeasuredRead, SaysThatNothingIsHeldOut) {
  replace(json_, "held-out", "fit");
  EXPECT_EQ(decisions(), (Words{"no run is held out: no gain on unseen data can be measured"}));
}

TEST_F(MeasuredRead, FindsRepeatsAndSaysSoWhereOneIsHeldOut) {
  auto const at = json_.find("]\n}");
  json_.insert(at,
               ", {\"file\": \"run3.csv\", \"role\": \"held-out\", \"press\": " + press() + "}");
  files_["run3.csv"] = files_["run1.csv"];
  EXPECT_EQ(repeats(read()), (std::vector<std::vector<std::size_t>>{{0, 2}, {1}}));
  EXPECT_EQ(decisions(), (Words{"held-out run run3.csv repeats the protocol of run1.csv: its gain "
                                "shows nothing of other protocols"}));
}

TEST_F(MeasuredRead, LetsAMeasuredGapStayAboveByWhatTheFrameYields) {
  // 25 kN on 40 kN/mm: 0.625 mm between command and faces, as the seed's press may have had.
  auto rows = press_rows();
  for (auto& row : rows)
    row.gap += row.force / 40e6;
  files_["run1.csv"] = csv(rows);
  EXPECT_EQ(refusal(),
            "run1.csv: the run's smallest punch_gap is 8.6125 mm, but its press block says "
            "end_gap = 8 mm (it may be 0.16 mm below and 0.21 mm above). Is it the file of "
            "another run?");
  replace(json_, "commanded", "measured");
  EXPECT_EQ(refusal(), "accepted");
}

TEST_F(MeasuredRead, SaysWhenTheSpeedCannotBeChecked) {
  files_["run1.csv"] = "time [s],punch_gap [m],upper_punch_force [N]\n60,0.008,25095\n";
  EXPECT_EQ(decisions(),
            (Words{"run1.csv: too few readings while the gap closes to check the speed"}));
}

} // namespace
} // namespace coupling::measured
