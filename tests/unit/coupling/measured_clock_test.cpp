#include "tests/unit/coupling/measured_folder.hpp"

namespace coupling::measured {
namespace {

using Words = std::vector<std::string>;

/// Forces and positions from two loggers; the position's clock is 17.3 s behind.
class MeasuredClocks : public MeasuredTexts {
protected:
  static constexpr double shift = 17.3;

  MeasuredClocks() {
    std::string forces = "time [s],force [N]\n", positions = "Zeit [s];Spalt [mm]\n";
    for (auto const& row : press_rows())
      forces += fmt::format("{},{}\n", row.time, row.force);
    // Twice as dense, and from before the bed until after the pressing.
    for (double t = -8.0; t <= 66.5; t += 0.5) {
      double const gap = t <= 60   ? fill_height - speed * t
                         : t <= 62 ? end_gap
                                   : end_gap + 10 * speed * (t - 62);
      auto line = fmt::format("{:.6f};{:.9f}\n", t - shift, gap * 1e3);
      std::ranges::replace(line, '.', ',');
      positions += line;
    }
    files_["run1.csv"] = forces;
    files_["position.csv"] = positions;
    use("");
  }
  void use(std::string const& clock) {
    json_ = description();
    replace(json_, "\"run1.csv\",", "\"run1.csv\", \"position_file\": \"position.csv\"," + clock);
  }
};

TEST_F(MeasuredClocks, AreAlignedByTheTurningPoint) {
  auto const run = read().runs[0];
  auto const rows = press_rows();
  // Readings every 1 s and 0.5 s: 0.289 s and 0.144 s; 2 um at 50 um/s: 0.04 s.
  EXPECT_NEAR(run.clock_sd, std::sqrt((1.0 + 0.25) / 12.0 + 0.04 * 0.04), 1e-6);
  // The largest force stands at 60 s, where the closing ends: here no error is made.
  auto const gap = run.channel("punch_gap");
  for (std::size_t k = 0; k <= 60; ++k)
    EXPECT_NEAR(gap[k], rows[k].gap, 1e-9);
  // The positions end at 66.5 s.
  EXPECT_EQ(run.time.back(), 66.0);
  auto const words = decisions();
  EXPECT_EQ(
      words[words.size() - 2],
      "run1.csv: the time of position.csv is shifted by 17.3 s, with a standard uncertainty of "
      "0.33 s, by turning point (the closing ends when the force is highest); the gap is "
      "interpolated between its readings; such data cannot tell a lag of the force");
  EXPECT_EQ(words.back(), "run1.csv: 2 rows are left out: position.csv has no gap at their time");
}

TEST_F(MeasuredClocks, AreAlignedByFirstContact) {
  use("\"clock\": {\"align\": \"first_contact\"},");
  auto const run = read().runs[0];
  // 25 kN (t / 60)^3 passes 5 x 12 N at 8.03 s and eight times that at 16.07 s; readings: 9 s, 17
  // s. So contact is put at 9 - 2/3 x 8 s, 3.7 s late for this law, with 8 s / 27^(1/2) of its own
  // uncertainty, and 3 s (5 % of 3 mm at 50 um/s) of the fill height's.
  double const sd = std::sqrt(3.0 * 3.0 + 1.0 / 12.0 + 64.0 / 27.0);
  EXPECT_NEAR(run.clock_sd, sd, 1e-9);
  auto const gap = run.channel("punch_gap");
  EXPECT_NEAR(gap[30], fill_height - speed * (30 - (9 - 16.0 / 3.0)), 1e-8);
  auto const words = decisions();
  auto const names_it = [](auto const& what) { return what.find("first contact") != what.npos; };
  EXPECT_EQ(std::ranges::count_if(words, names_it), 1);
}

TEST_F(MeasuredClocks, AreAlignedAsStated) {
  use("\"clock\": {\"align\": \"stated\", \"shift\": \"17.3 s\", \"sd\": \"20 ms\"},");
  auto const run = read().runs[0];
  EXPECT_EQ(run.clock_sd, 0.02);
  EXPECT_NEAR(run.channel("punch_gap")[30], fill_height - 30 * speed, 1e-9);
  use("\"clock\": {\"align\": \"stated\", \"shift\": \"17.3 s\"},");
  EXPECT_EQ(refusal(),
            "measured.json:8: runs[0]/clock/shift = 17.3 s: has no uncertainty (a stated "
            "shift is a measured value). Add \"sd\"?");
  use("\"clock\": {\"align\": \"stated\", \"shift\": \"1700 s\", \"sd\": \"20 ms\"},");
  EXPECT_EQ(refusal(),
            "run1.csv: overlaps nowhere with position.csv, whose time is shifted by 1700 s "
            "(a force needs its gap). State the shift in measured.json, in \"clock\"?");
  use("\"clock\": {\"shift\": \"17.3 s\"},");
  EXPECT_EQ(refusal(), "measured.json:8: runs[0]/clock/shift = 17.3 s: is not used (align is not "
                       "'stated'). Set align to stated, or remove it?");
}

TEST_F(MeasuredClocks, AreRefusedWhenTheyAreOneClockAndDoNotFit) {
  use("\"clock\": {\"align\": \"common\"},");
  EXPECT_NE(refusal().find("but punch_gap is smallest in row"), std::string::npos) << refusal();
}

TEST_F(MeasuredClocks, AreMadeWhereAFileHasNone) {
  std::string text = "gap [m],force [N]\n";
  for (auto const& row : press_rows())
    text += fmt::format("{},{}\n", row.gap, row.force);
  json_ = description();
  files_["run1.csv"] = text;
  EXPECT_EQ(refusal(), "run1.csv:1: no column is time (the header names: gap [m], force [N]). Is a "
                       "name misspelt, or to be given in measured.json, in \"columns\"?");
  replace(json_, "\"run1.csv\",", "\"run1.csv\", \"clock\": {\"interval\": \"1 s\"},");
  EXPECT_EQ(read().runs[0].time[10], 10.0);
  EXPECT_EQ(decisions(), (Words{"run1.csv: has no clock: rows are 1 s apart, as stated"}));
  files_["run1.csv"] = csv(press_rows());
  EXPECT_EQ(refusal(),
            "run1.csv:2: has a running clock (clock/interval = 1 s in measured.json says "
            "that it has none). Remove the interval?");
}

TEST_F(MeasuredClocks, AreSpreadWhereTheyAreCoarse) {
  json_ = description();
  auto rows = press_rows();
  for (auto& row : rows)
    row.time = 2 * std::floor(row.time / 2);
  files_["run1.csv"] = csv(rows);
  auto const run = read().runs[0];
  for (std::size_t k = 0; k < run.time.size(); ++k)
    EXPECT_DOUBLE_EQ(run.time[k], k + 1 == run.time.size() ? 68.0 : 1.0 * static_cast<double>(k));
  EXPECT_EQ(decisions(),
            (Words{"run1.csv: the clock is coarse: 34 rows share a tick with the row before (the "
                   "first: row 3); rows of a tick are spread evenly over it"}));
}

} // namespace
} // namespace coupling::measured
