#include "tests/support/scratch_folder.hpp"
#include "tests/unit/coupling/measured_folder.hpp"

#include <bit>
#include <cstdint>
#include <random>

namespace coupling::measured {
namespace {

class MeasuredProperty : public MeasuredTexts {
protected:
  static bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
    return std::ranges::equal(a, b, [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
  }
  static void expect_same(MeasuredData const& a, MeasuredData const& b) {
    EXPECT_EQ(a.sample, b.sample);
    EXPECT_EQ(a.channels, b.channels);
    EXPECT_EQ(a.gap_source, b.gap_source);
    ASSERT_EQ(a.runs.size(), b.runs.size());
    for (std::size_t k = 0; k < a.runs.size(); ++k) {
      auto const &x = a.runs[k], &y = b.runs[k];
      EXPECT_EQ(x.role, y.role);
      EXPECT_EQ(x.press, y.press);
      EXPECT_EQ(x.scalars, y.scalars);
      EXPECT_EQ(x.clock_sd, y.clock_sd);
      EXPECT_TRUE(same_bits(x.time, y.time));
      ASSERT_EQ(x.series.size(), y.series.size());
      for (auto const& [channel, values] : x.series)
        EXPECT_TRUE(same_bits(values, y.series.at(channel))) << channel;
    }
  }

  /// Numbers that no decimal text ends early for.
  static std::vector<Row> rough_rows(std::mt19937_64& random, double end) {
    std::normal_distribution<double> noise;
    auto rows = press_rows(end);
    for (auto& row : rows) {
      row.time += 0.1 * std::tanh(noise(random));
      row.gap += 2e-6 * noise(random);
      row.force += 12.0 * noise(random);
    }
    return rows;
  }
};

TEST_F(MeasuredProperty, WritesWhatItReadsBackToTheBit) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    files_ = {{"run1.csv", csv(rough_rows(random, end_gap))},
              {"run2.csv", csv(rough_rows(random, 8.5e-3))}};
    set_row(9, "7.3,nan,1e1");
    auto first = read();
    first.runs[0].scalars["compact_height"] = {9.55e-3 / 3.0, 2e-5 / 7.0};
    first.runs[0].clock_sd = 1.0 / 3.0;
    first.runs[1].press.dwell = 0.1;
    support::ScratchFolder folder;
    write_measured(first, folder / "data");
    auto const second = read_measured(folder / "data");
    expect_same(first, second);
    // The texts are the same, too, and so is every decision.
    EXPECT_EQ(print_measured(second), print_measured(read_measured(folder / "data")));
    EXPECT_EQ(first.decisions, second.decisions) << seed;
  }
}

TEST_F(MeasuredProperty, NoiseIsNeitherRefusedNorLeftOut) {
  for (std::uint64_t seed = 100; seed < 300; ++seed) {
    std::mt19937_64 random(seed);
    auto rows = rough_rows(random, end_gap);
    // Uneven sampling: a third of the readings was never taken.
    std::erase_if(rows, [&](Row const&) { return random() % 3 == 0; });
    files_["run1.csv"] = csv(rows);
    auto const data = read();
    EXPECT_EQ(data.runs[0].time.size(), rows.size()) << seed;
    EXPECT_TRUE(data.decisions.empty()) << seed;
  }
}

TEST_F(MeasuredProperty, UnitsChangeNothing) {
  auto const expected = read();
  // Powers of ten act on the decimal text, so no bit is lost.
  std::string text = "upper_punch_force [kN],time [ms],punch_gap [um]\n";
  for (auto const& row : press_rows())
    text += fmt::format("{}e-3,{}e3,{}e6\n", row.force, row.time, row.gap);
  files_["run1.csv"] = text;
  replace(json_, "{\"unit\": \"um\", \"sd\": 2}", "{\"sd\": \"0.002 mm\"}");
  replace(json_, "{\"value\": 9.13, \"sd\": 0.01, \"unit\": \"g\"}",
          "{\"value\": \"9130 mg\", \"sd\": 1e-5, \"unit\": \"kg\"}");
  expect_same(expected, read());
}

TEST_F(MeasuredProperty, ColumnsAndDialectChangeNothing) {
  auto const expected = read();
  std::string text = "Kraft [N];Zeit [s];Abstand [mm];Temperatur [°C]\r\n";
  for (auto const& row : press_rows()) {
    auto line = fmt::format("{};{};{}e3;21.5\r\n", row.force, row.time, row.gap);
    std::ranges::replace(line, '.', ',');
    text += line;
  }
  files_["run1.csv"] = text;
  expect_same(expected, read());
  EXPECT_EQ(decisions(),
            (std::vector<std::string>{"run1.csv: fields are parted by semicolons",
                                      "run1.csv: decimals are written with a comma",
                                      "run1.csv: column 'Temperatur [°C]' is not used"}));
}

TEST_F(MeasuredProperty, TheOrderOfRunsIsThatOfTheFile) {
  auto const data = read();
  auto swapped = json_;
  replace(swapped, "\"run1.csv\", \"role\": \"fit\", \"press\": " + press(),
          "\"x\", \"role\": \"held-out\", \"press\": " + press(8.5e-3));
  replace(swapped, "\"run2.csv\", \"role\": \"held-out\", \"press\": " + press(8.5e-3),
          "\"run1.csv\", \"role\": \"fit\", \"press\": " + press());
  replace(swapped, "\"x\"", "\"run2.csv\"");
  auto other = read(swapped, files_);
  std::swap(other.runs[0], other.runs[1]);
  expect_same(data, other);
}

TEST_F(MeasuredProperty, RowsOutOfOrderAreNotSorted) {
  auto rows = press_rows();
  std::ranges::reverse(rows);
  files_["run1.csv"] = csv(rows);
  EXPECT_EQ(refusal(), "run1.csv:3: time = 67 s is before the 68 s of row 2 (time goes backwards). "
                       "Are two records joined, or was the clock reset?");
}

} // namespace
} // namespace coupling::measured
