#include "tests/unit/coupling/measured_folder.hpp"

namespace coupling::measured {
namespace {

/// What a run's file holds and cannot be right.
class MeasuredRunRefused : public MeasuredTexts {
protected:
  /// All rows of run1.csv changed.
  template <class Change> std::string with_rows(Change const& change) {
    auto rows = press_rows();
    for (auto& row : rows)
      change(row);
    files_["run1.csv"] = csv(rows);
    return refusal();
  }
  std::string with_header(std::string const& header) {
    files_["run1.csv"] = csv(press_rows());
    set_row(1, header);
    return refusal();
  }
};

TEST_F(MeasuredRunRefused, WhenItIsEmpty) {
  files_["run1.csv"] = "";
  EXPECT_EQ(refusal(),
            "run1.csv: is empty (a header and rows are needed). Was its writing interrupted?");
  files_["run1.csv"] = " \n\n";
  EXPECT_EQ(refusal(),
            "run1.csv: is empty (a header and rows are needed). Was its writing interrupted?");
  files_["run1.csv"] = csv({});
  EXPECT_EQ(refusal(), "run1.csv: has no rows below its header (nothing was measured). Was its "
                       "writing interrupted?");
  files_["run1.csv"] = "time [s],punch_gap [m],upper_punch_force [N]\n1,nan,nan\n2,nan,nan\n";
  EXPECT_EQ(refusal(),
            "run1.csv: holds no value of punch_gap (every row is a gap). Is it the right file?");
}

TEST_F(MeasuredRunRefused, WhenTimeGoesBackwards) {
  set_row(20, "3,0.0102,100");
  EXPECT_EQ(refusal(), "run1.csv:20: time = 3 s is before the 17 s of row 19 (time goes "
                       "backwards). Are two records joined, or was the clock reset?");
}

TEST_F(MeasuredRunRefused, WhenTheClockStandsStill) {
  EXPECT_EQ(with_rows([](Row& row) { row.time = 7.0; }),
            "run1.csv:2: the clock stands still at 7 s (every row has the same time). Give the "
            "time between rows in measured.json, \"clock\": {\"interval\": \"0.1 s\"}?");
}

TEST_F(MeasuredRunRefused, WhenGapAndForceAreSwapped) {
  EXPECT_EQ(with_rows([](Row& row) { std::swap(row.gap, row.force); }),
            "run1.csv: punch_gap goes up to 25000 m and upper_punch_force down to 0.008 N; read "
            "the other way round they are a gap down to 8 mm, where the press block says 8 mm, and "
            "a force up to 25 kN (gap and force are swapped). Swap the two names in the header?");
  // In mm and kN both columns look plausible: 0 to 25 and 8 to 11.
  auto rows = press_rows();
  for (auto& row : rows)
    row = {row.time, row.force / 1e3, row.gap * 1e3};
  files_["run1.csv"] = csv(rows);
  set_row(1, "time [s],punch_gap [mm],upper_punch_force [kN]");
  EXPECT_EQ(refusal(),
            "run1.csv: punch_gap goes up to 0.025 m and upper_punch_force down to 8000 N; read the "
            "other way round they are a gap down to 8 mm, where the press block says 8 mm, and a "
            "force up to 25 kN (gap and force are swapped). Swap the two names in the header?");
  // Units that belong to the other name say it at once.
  EXPECT_EQ(with_header("time [s],upper_punch_force [m],punch_gap [N]"),
            "run1.csv:1: column 'upper_punch_force [m]': is in m (a force is needed: N, kN). Are "
            "two names swapped?");
}

TEST_F(MeasuredRunRefused, ForUnitsWrongBy1000) {
  EXPECT_EQ(with_header("time [s],punch_gap [mm],upper_punch_force [N]"),
            "run1.csv: the smallest punch_gap, 8e-06 m in row 62, is 0.001 times the end gap of "
            "the press block, 0.008 m. Is its unit wrong by 1000?");
  EXPECT_EQ(with_rows([](Row& row) { row.gap *= 1e3; }),
            "run1.csv: the smallest punch_gap, 8 m in row 62, is 1e+03 times the end gap of the "
            "press block, 0.008 m. Is its unit wrong by 1000?");
  EXPECT_EQ(with_header("time [s],punch_gap [m],upper_punch_force [kN]"),
            "run1.csv: the largest upper_punch_force, 2.5e+07 N in row 62, is 6.547e+04 MPa on the "
            "die's area of 381.86 mm^2 (powders are pressed at 0.5 to 2000 MPa). Is its unit, or "
            "that of the die's diameter, wrong by 1000?");
  EXPECT_EQ(with_rows([](Row& row) { row.force /= 1e3; }),
            "run1.csv: the largest upper_punch_force, 25 N in row 62, is 0.06547 MPa on the die's "
            "area of 381.86 mm^2 (powders are pressed at 0.5 to 2000 MPa). Is its unit, or that of "
            "the die's diameter, wrong by 1000?");
  EXPECT_EQ(with_header("time [ms],punch_gap [m],upper_punch_force [N]"),
            "run1.csv: the run's gap closes at 50 mm/s, but its press block says speed_down = 0.05 "
            "mm/s (10 % may lie between). Is the unit of the time, or of the speed, wrong?");
  EXPECT_EQ(with_header("time [min],punch_gap [m],upper_punch_force [N]"),
            "run1.csv: the run's gap closes at 0.0008333 mm/s, but its press block says speed_down "
            "= 0.05 mm/s (10 % may lie between). Is the unit of the time, or of the speed, wrong?");
  files_["run1.csv"] = csv(press_rows());
  replace(json_, "\"unit\": \"N\", \"sd\": 12.0", "\"unit\": \"MN\", \"sd\": 12.0");
  EXPECT_EQ(refusal(), "run1.csv: the uncertainty of upper_punch_force, 1.2e+07 N, is above all "
                       "its readings, up to 25000 N (they say nothing then). Is its unit wrong?");
}

TEST_F(MeasuredRunRefused, ForALowerPunchThatCarriesAThousandTimesMore) {
  replace(json_, "\"upper_punch_force\"",
          "\"lower_punch_force\": {\"unit\": \"N\", \"sd\": 12.0}, \"wall_radial_pressure\": "
          "{\"unit\": \"MPa\", \"sd\": 0.1}, \"upper_punch_force\"");
  std::string text = "time [s],punch_gap [m],upper_punch_force [N],lower_punch_force [kN]\n";
  for (auto const& row : press_rows())
    text += fmt::format("{},{},{},{}\n", row.time, row.gap, row.force, 0.8 * row.force);
  files_["run1.csv"] = text;
  EXPECT_EQ(
      refusal(),
      "run1.csv: the largest lower_punch_force, 2e+07 N in row 62, is 800 times what the upper "
      "punch gives, 25000 N (the same powder carries both). Is its unit wrong by 1000?");
  text = "time [s],punch_gap [m],upper_punch_force [N],wall_radial_pressure [Pa]\n";
  for (auto const& row : press_rows())
    text += fmt::format("{},{},{},{}\n", row.time, row.gap, row.force, row.force * 1e-3);
  files_["run1.csv"] = text;
  EXPECT_EQ(refusal(), "run1.csv: the largest wall_radial_pressure, 25 Pa in row 62, is 3.82e-07 "
                       "times what the upper punch gives, 6.54686e+07 Pa (the same powder carries "
                       "both). Is its unit wrong by 1000?");
}

TEST_F(MeasuredRunRefused, ForACurveThatNoPressMakes) {
  EXPECT_EQ(with_rows([](Row& row) { row.force = -row.force; }),
            "run1.csv: upper_punch_force goes from -25000 to -0 N (compression is positive). Is "
            "its sign turned?");
  EXPECT_EQ(
      with_rows([](Row& row) { row.gap = fill_height + end_gap - row.gap + 1e-12 * row.time; }),
      "run1.csv: upper_punch_force is highest in row 62, where punch_gap is 11 mm, but "
      "punch_gap is smallest in row 2, 8 mm (a bed pushes hardest where it is pressed most). "
      "Do the columns belong to one clock, and is the gap no travel?");
  EXPECT_EQ(with_rows([](Row& row) { row.gap -= 8.5e-3; }),
            "run1.csv:62: punch_gap = -0.0005 m is not positive (powder lies between the punches). "
            "Is it a travel, or its zero wrong?");
}

TEST_F(MeasuredRunRefused, WhenItContradictsItsProtocol) {
  auto const run2 = files_["run2.csv"];
  files_["run2.csv"] = csv(press_rows(8e-3));
  EXPECT_EQ(
      refusal(),
      "run2.csv: the held-out run's smallest punch_gap is 8 mm, but its press block says end_gap = "
      "8.5 mm (it may be 0.135 mm below and 0.185 mm above). Is it the file of another run?");
  files_["run2.csv"] = run2;
  EXPECT_EQ(with_rows([](Row& row) { row.time *= 1.2; }),
            "run1.csv: the run's gap closes at 0.04167 mm/s, but its press block says speed_down = "
            "0.05 mm/s (10 % may lie between). Is it the file of another run?");
  // Within a tenth it is the same protocol.
  EXPECT_EQ(with_rows([](Row& row) { row.time *= 1.08; }), "accepted");
}

TEST_F(MeasuredRunRefused, ForManyCorruptRows) {
  for (std::size_t const row : {5, 9, 12, 20})
    set_row(row, "1,x");
  EXPECT_EQ(
      refusal(),
      "run1.csv: 4 of 69 rows are corrupt (at most 5 % may be; the first: row 5, left out: it has "
      "2 fields and the header 3). Is it the right file, or its header or decimal mark another?");
  files_["run1.csv"] = csv(press_rows());
  for (std::size_t const row : {10, 20, 30, 40})
    set_row(row,
            fmt::format("{},{},9e5", row - 2, fill_height - speed * static_cast<double>(row - 2)));
  EXPECT_EQ(refusal(),
            "run1.csv: 4 of 69 rows are corrupt (at most 5 % may be; the last: row 40, left out: "
            "upper_punch_force = 900000 N leaves the line between its neighbours, 5862.62 and "
            "6865.62, for one reading (an error of transmission)). Is the record damaged?");
}

TEST_F(MeasuredRunRefused, ForItsHeader) {
  EXPECT_EQ(with_header("time [s],punch_gpa [m],upper_punch_force [N]"),
            "run1.csv:1: no column is punch_gap (the header names: time [s], punch_gpa [m], "
            "upper_punch_force [N]). Is a name misspelt ('punch gap' is known), or to be given in "
            "measured.json, in \"columns\"?");
  EXPECT_EQ(with_header("time [s],punch_gap [m],upper_punch_force"),
            "run1.csv:1: column 'upper_punch_force': has no unit (a number without unit means "
            "nothing). Write 'name [unit]', or give it in measured.json, in \"columns\"?");
  EXPECT_EQ(with_header("time [s],punch_gap [metre],upper_punch_force [N]"),
            "run1.csv:1: column 'punch_gap [metre]': 'metre' is no unit that presscheck knows "
            "(units are case-sensitive). Write it in SI units?");
  EXPECT_EQ(with_header("time [s],gap [m],punch_gap [m]"),
            "run1.csv:1: column 'punch_gap [m]': is punch_gap, and so is 'gap' (one of them would "
            "be lost). Say which in measured.json, in \"columns\"?");
  EXPECT_EQ(with_header("a,b,c"),
            "run1.csv:1: no line names the columns (looked for names such as 'time [s]', "
            "'punch_gap [m]', 'upper_punch_force [N]' between commas, semicolons or tabs). Name "
            "them in measured.json, in \"columns\"?");
  EXPECT_EQ(with_header("time [s],displacement [m],upper_punch_force [N]"),
            "run1.csv:1: column 'displacement [m]': is a travel (its zero is not said, so it is no "
            "gap yet). Give in measured.json \"columns\": {\"punch_gap\": {\"name\": "
            "\"displacement\", \"at_zero\": ...}}, the gap where it reads zero?");
}

TEST_F(MeasuredRunRefused, ForBytesThatAreNoTable) {
  files_["run1.csv"] = "\xff\xfet\1i\1";
  EXPECT_EQ(refusal(), "run1.csv: is UTF-16 (UTF-8 and Latin-1 are read). Save it as UTF-8?");
  files_["run1.csv"] = std::string("PK\0\3", 4);
  EXPECT_EQ(refusal(), "run1.csv: holds bytes that are no text (a table of text is read, no "
                       "spreadsheet and no binary record). Export it as CSV?");
}

} // namespace
} // namespace coupling::measured
