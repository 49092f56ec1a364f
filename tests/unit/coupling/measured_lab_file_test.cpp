#include "coupling/measured/lab_file.hpp"
#include "coupling/measured/lab_numbers.hpp"
#include "coupling/measured/lab_words.hpp"
#include "coupling/measured/measured_data.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace coupling::measured {
namespace {

using Words = std::vector<std::string>;

LabTable table(std::string const& text, LabLayout const& layout = {}) {
  return parse_lab_table(text, "lab.txt", "lab.txt", layout,
                         {"time", "punch_gap", "upper_punch_force"});
}

std::string refusal(std::string const& text) {
  try {
    table(text);
    return "accepted";
  } catch (dem::InvalidInput const& problem) {
    return problem.what();
  }
}

Words decisions(std::string const& text, LabLayout const& layout = {}) {
  Words words;
  for (auto const& decision : table(text, layout).decisions)
    words.push_back(in_words(decision));
  return words;
}

/// All of these hold the readings (1 s, 9.5 mm, 1.25 kN) and (2 s, 9 mm, 1.5 kN).
void expect_two_rows(std::string const& text, LabLayout const& layout = {}) {
  auto const read = table(text, layout);
  EXPECT_EQ(read.time, (std::vector{1.0, 2.0})) << text;
  EXPECT_EQ(read.series.at("punch_gap"), (std::vector{9.5e-3, 9e-3})) << text;
  EXPECT_EQ(read.series.at("upper_punch_force"), (std::vector{1250.0, 1500.0})) << text;
}

TEST(LabFile, ReadsItsOwnForm) {
  expect_two_rows("time [s],punch_gap [m],upper_punch_force [N]\n1,0.0095,1250\n2,0.009,1500\n");
}

TEST(LabFile, ReadsSeveralLanguages) {
  expect_two_rows("Zeit;Abstand;Kraft\ns;mm;kN\n1;9,5;1,25\n2;9;1,5\n");
  expect_two_rows("Prüfzeit [s]\tSpalt [mm]\tStandardkraft [N]\n1\t9.5\t1250\n2\t9\t1500\n");
  expect_two_rows("tiempo (s);distancia (mm);fuerza (kN)\n1,0;9,5;1,25\n2,0;9,0;1,5\n");
  expect_two_rows("Time in s, Gap / mm, Force (kN)\n1, 9.5, 1.25\n2, 9, 1.5\n");
  expect_two_rows("Elapsed Time (sec),Gap (mm),Load (KN)\n1,9.5,1.25\n2,9,1.5\n");
  EXPECT_EQ(decisions("Elapsed Time (sec),Gap (mm),Load (KN)\n1,9.5,1.25\n"),
            (Words{"lab.txt: unit 'sec' is read as s", "lab.txt: unit 'KN' is read as kN"}));
}

TEST(LabFile, SkipsWhatStandsBeforeTheHeader) {
  auto const text = "Prüfer: M. Muster;;\nDatum;12.3.2020;\n\nZeit [min];Spalt [mm];Kraft [N]\n"
                    "0,5;9,5;1.250,5\n";
  auto const read = table(text);
  EXPECT_EQ(read.time, std::vector{30.0});
  EXPECT_EQ(read.series.at("upper_punch_force"), std::vector{1250.5});
  EXPECT_EQ(read.rows, std::vector<std::size_t>{5});
  EXPECT_EQ(decisions(text), (Words{"lab.txt: fields are parted by semicolons",
                                    "lab.txt: decimals are written with a comma",
                                    "lab.txt: lines before line 4, which names the columns, are no "
                                    "data"}));
}

TEST(LabFile, ReadsOtherEncodingsAndLineEnds) {
  expect_two_rows("\xef\xbb\xbftime [s],gap [mm],force [N]\r\n1,9.5,1250\r\n2,9,1500\r\n");
  expect_two_rows("time [s],gap [mm],force [N]\r1,9.5,1250\r2,9,1500\r");
  // Latin-1: micro sign and degree.
  auto const latin = "time [s];gap [\xb5m];force [N];T [\xb0"
                     "C]\n1;9500,0;1250,0;20,5\n2;9000,0;1500,0;20,5\n";
  expect_two_rows(latin);
  EXPECT_EQ(decisions(latin).front(), "lab.txt: is not UTF-8: read as Latin-1");
}

TEST(LabFile, ReadsThousandsWhereTheyAreClear) {
  expect_two_rows("t [s];gap [um];force [N]\n1;9.500,0;1.250,0\n2;9.000,0;1.500,0\n");
  expect_two_rows("t [s]\tgap [um]\tforce [N]\n1\t9'500.0\t1 250.0\n2\t9,000.0\t1\u00a0500.0\n");
  expect_two_rows("t [s],gap [um],force [N]\n1,\"9,500.0\",1250\n2,\"9,000.0\",1500\n");
}

TEST(LabFile, RefusesThousandsThatCouldBeDecimals) {
  auto const text = "t [s];gap [um];force [N]\n1;9.500;1.250\n2;9.000;1.500\n";
  EXPECT_EQ(refusal(text),
            "lab.txt:2: '9.500' could be a decimal number or thousands (no number of the file "
            "tells). Set \"decimal_mark\" in measured.json?");
  // Stated, either is read.
  expect_two_rows(text, {.decimal_mark = ","});
  EXPECT_EQ(table(text, {.decimal_mark = "."}).series.at("upper_punch_force")[0], 1.25);
  EXPECT_EQ(refusal("t [s];gap [mm];force [N]\n1,5;9.5;12\n2,5;9;12.5\n"),
            "lab.txt:2: '9.5' has a decimal point, and '1,5' in row 2 a decimal comma (both cannot "
            "be). Were two files joined?");
}

TEST(LabFile, TurnsATravelIntoAGapWhereItsZeroIsStated) {
  LabLayout layout;
  layout.columns["punch_gap"] = {.name = "Weg", .unit = "", .at_zero = 11e-3};
  auto const text = "Zeit [s];Weg [mm];Kraft [kN]\n1;1,5;1,25\n2;2;1,5\n";
  expect_two_rows(text, layout);
  EXPECT_EQ(decisions(text, layout).back(), "lab.txt: punch_gap = 0.011 m - 'Weg'");
}

TEST(LabFile, TakesTheColumnsThatAreNamed) {
  LabLayout layout;
  layout.columns["upper_punch_force"] = {.name = "Kanal 3", .unit = "kN", .at_zero = {}};
  expect_two_rows("Zeit [s];Spalt [mm];Kraft [N];Kanal 3\n1;9,5;7,5;1,25\n2;9;8;1,5\n", layout);
  layout.columns["upper_punch_force"].name = "Kanal 4";
  try {
    table("Zeit [s];Spalt [mm];Kraft [N]\n1;9,5;7,5\n", layout);
    FAIL();
  } catch (dem::InvalidInput const& problem) {
    EXPECT_STREQ(problem.what(),
                 "lab.txt:1: no column is upper_punch_force (the header names: Zeit [s], Spalt "
                 "[mm], Kraft [N]). Is a name misspelt (measured.json names 'Kanal 4'), or to be "
                 "given in measured.json, in \"columns\"?");
  }
}

TEST(LabFile, LeavesAClosingRemarkOut) {
  std::string text = "t [s],gap [mm],force [N]\n";
  for (int k = 0; k < 25; ++k)
    text += fmt::format("{},9.5,100\n", k);
  EXPECT_EQ(decisions(text + "End of test\n"),
            (Words{"lab.txt:27: left out: it has 1 fields and the header 3"}));
  // A delimiter after each row, and remarks, are no fault.
  EXPECT_EQ(decisions("# press 3\nt [s],gap [mm],force [N]\n1,9.5,100,\n# pause\n2,9,-,\n"),
            (Words{"lab.txt: lines before line 2, which names the columns, are no data"}));
}

TEST(LabNumbers, AreReadInBothNotations) {
  EXPECT_EQ(plain_number("-1.234.567,5e-3", ','), "-1234567.5e-3");
  EXPECT_EQ(plain_number("1,234.5", '.'), "1234.5");
  EXPECT_EQ(plain_number(",5", ','), "0.5");
  EXPECT_EQ(plain_number("5,", ','), "5");
  EXPECT_EQ(plain_number("+7", '.'), "7");
  for (auto const* const text :
       {"1.23.4", "12,34.5", "1e", "e5", "", "-", "--5", "0x10", "1.5.", ".", "inf", "1 23"})
    EXPECT_FALSE(plain_number(text, '.').has_value()) << text;
}

TEST(LabNumbers, TellTheirMark) {
  using enum MarkEvidence;
  EXPECT_EQ(mark_evidence("12"), none);
  EXPECT_EQ(mark_evidence("abc.d"), none);
  EXPECT_EQ(mark_evidence("1.5"), point);
  EXPECT_EQ(mark_evidence("0.125"), point);
  EXPECT_EQ(mark_evidence("1234.125"), point);
  EXPECT_EQ(mark_evidence("1.234e3"), point);
  EXPECT_EQ(mark_evidence("1,5"), comma);
  EXPECT_EQ(mark_evidence("1.234"), ambiguous_point);
  EXPECT_EQ(mark_evidence("1,234"), ambiguous_comma);
  EXPECT_EQ(mark_evidence("1.234.567"), comma);
  EXPECT_EQ(mark_evidence("1,234.5"), point);
  EXPECT_EQ(mark_evidence("1.234,5"), comma);
}

TEST(LabFile, IsReadFromAFile) {
  support::ScratchFolder folder;
  support::put_bytes(folder / "a.csv", "t [s],gap [mm],force [N]\n1,9.5,100\n");
  EXPECT_EQ(read_lab_file(folder / "a.csv").size(), 1u);
}

} // namespace
} // namespace coupling::measured
