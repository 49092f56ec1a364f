#include "tests/unit/coupling/measured_folder.hpp"

namespace coupling::measured {
namespace {

/// What measured.json says and cannot be right.
class MeasuredFileRefused : public MeasuredTexts {
protected:
  std::string with(std::string const& from, std::string const& to) {
    json_ = description();
    replace(json_, from, to);
    return refusal();
  }
};

TEST_F(MeasuredFileRefused, ForItsForm) {
  json_ = "";
  EXPECT_EQ(refusal(), "measured.json: is empty (it describes the sample, the channels and the "
                       "runs). Was its writing interrupted?");
  json_ = "{\"sample\": }";
  EXPECT_EQ(refusal(),
            "measured.json:1: is no JSON. Is a comma, quote or bracket missing or left over?");
  json_ = "[]";
  EXPECT_EQ(refusal(), "measured.json:1: is no object (it holds: sample, channels, gap_source, "
                       "runs, decisions, columns, decimal_mark, clock). Write it in braces?");
  json_ = "{\"runs\": [], \"runs\": []}";
  EXPECT_EQ(refusal(), "measured.json:1: 'runs' is set twice (first on line 1). Remove one?");
  EXPECT_EQ(with("\"sample\"", "\"smaple\""),
            "measured.json:2: smaple = {...}: is no entry of measured data (known here: sample, "
            "channels, gap_source, runs, decisions, columns, decimal_mark, clock). Did you mean "
            "'sample'?");
  EXPECT_EQ(with("\"gap_source\": \"commanded\",", ""),
            "measured.json:1: gap_source is missing (commanded, or measured at the punch faces). "
            "Add it?");
  EXPECT_EQ(with("\"commanded\"", "\"comanded\""),
            "measured.json:6: gap_source = comanded: is none of the choices (commanded | "
            "measured). Did you mean 'commanded'?");
  json_ = std::string(40, '[');
  EXPECT_EQ(refusal(), "measured.json:1: [0][0][0][0][0][0][0][0][0][0][0][0][0][0][0][0] = [...]: "
                       "is nested too deeply (no entry lies so deep). Is it the right file?");
}

TEST_F(MeasuredFileRefused, WithoutAnUncertainty) {
  EXPECT_EQ(with(", \"sd\": 0.01", ""),
            "measured.json:2: sample/mass = {...}: has no uncertainty (without it nobody can say "
            "what departs from what). Add \"sd\", the standard uncertainty?");
  EXPECT_EQ(with("\"sd\": 0.005", "\"sd\": 0"),
            "measured.json:3: sample/die_diameter/sd = 0: is not positive (a value without error "
            "would outweigh all others). State the standard uncertainty?");
  EXPECT_EQ(
      with(", \"sd\": 12.0", ""),
      "measured.json:4: channels/upper_punch_force = {...}: has no uncertainty (without it nobody "
      "can say what departs from what). Add \"sd\", the standard uncertainty of a reading?");
  EXPECT_EQ(with("\"sd\": 12.0", "\"sd\": -12.0"),
            "measured.json:4: channels/upper_punch_force/sd = -12.0: is not positive (a reading "
            "without error would outweigh all others). State the standard uncertainty?");
  EXPECT_EQ(with("\"sd\": 12.0", "\"sd\": 12.0, \"sd_relative\": 5"),
            "measured.json:4: channels/upper_punch_force/sd_relative = 5: is no share of a reading "
            "(0 to below 1). Is it in per cent?");
  EXPECT_EQ(with("\"upper_punch_force\": {\"unit\": \"N\", \"sd\": 12.0},", ""),
            "measured.json:4: channels/upper_punch_force is missing (every run has it, and without "
            "its uncertainty it says nothing). Add it?");
  json_ = description();
  replace(files_["run1.csv"], "upper_punch_force [N]",
          "upper_punch_force [N],lower_punch_force [N]");
  for (int row = 2; row <= 70; ++row)
    set_row(row, fmt::format("{},{},{},{}", row, 9e-3, 1e4, 1e4));
  EXPECT_EQ(refusal(),
            "run1.csv: column lower_punch_force has no uncertainty (measured.json, \"channels\", "
            "does not name it). Add {\"unit\": ..., \"sd\": ...}, or remove the column?");
}

TEST_F(MeasuredFileRefused, ForItsValues) {
  EXPECT_EQ(with("9.13", "\"heavy\""),
            "measured.json:2: sample/mass/value = heavy: does not start with a number (a mass is "
            "needed, in kg, g, mg). Give it a value?");
  EXPECT_EQ(with("9.13", "true"), "measured.json:2: sample/mass/value = true: is no number (a mass "
                                  "is needed). Write a number, or a text such as \"1 kg\"?");
  EXPECT_EQ(with("9.13", "-9.13"), "measured.json:2: sample/mass/value = -9.13: is not positive "
                                   "(there is something to press). Is the sign wrong?");
  EXPECT_EQ(with("\"unit\": \"g\"", "\"unit\": \"mm\""),
            "measured.json:2: sample/mass/value = 9.13: has a unit that does not fit (a mass is "
            "needed). Write it in kg, g, mg?");
  EXPECT_EQ(with("0.01, \"unit\": \"g\"", "0.01"),
            "measured.json:2: sample/mass/value = 9.13: has no unit (a measured number without "
            "unit means nothing). Add \"unit\"?");
  EXPECT_EQ(with("\"unit\": \"SI\"", "\"unit\": \"mm\""),
            "measured.json:8: runs[0]/press/unit = mm: is not 'SI' (bare numbers are SI; others "
            "carry their units, as \"1 mm/min\"). Write the values as texts with units?");
  EXPECT_EQ(with("\"end_gap\": 0.008", "\"end_gap\": 0.012"),
            "measured.json:8: runs[0]/press/end_gap = 0.012: is not below fill_height = 0.011 m "
            "(pressing closes the gap). Are the two swapped?");
  EXPECT_EQ(with("\"speed_down\": 5e-05", "\"speed_down\": \"3 N\""),
            "measured.json:8: runs[0]/press/speed_down = 3 N: has a unit that does not fit (a "
            "speed is needed). Write it in m/s, mm/s, mm/min?");
  EXPECT_EQ(with("\"held-out\"", "\"heldout\""),
            "measured.json:9: runs[1]/role = heldout: is none of the choices (fit | held-out). Did "
            "you mean 'held-out'?");
  EXPECT_EQ(with("\"role\": \"fit\", ", ""),
            "measured.json:8: runs[0]/role is missing (fit or held-out). Add it?");
}

TEST_F(MeasuredFileRefused, ForItsFiles) {
  EXPECT_EQ(with("\"run2.csv\"", "\"./run1.csv\""),
            "measured.json:9: runs[1]/file = run1.csv: is named twice (first at measured.json:8: "
            "runs[0]; one pressing is one run). Remove one?");
  EXPECT_EQ(with("\"run2.csv\"", "\"../run2.csv\""),
            "measured.json:9: runs[1]/file = ../run2.csv: leaves the folder (measured data hold "
            "all their files). Copy it into the folder?");
  EXPECT_EQ(with("\"run2.csv\"", "\"/etc/passwd\""),
            "measured.json:9: runs[1]/file = /etc/passwd: leaves the folder (measured data hold "
            "all their files). Copy it into the folder?");
  EXPECT_EQ(
      with("\"fit\"", "\"held-out\""),
      "measured.json: runs: all are held out (nothing is left to fit). Give one the role \"fit\"?");
}

TEST_F(MeasuredFileRefused, ForNumbersThatSayNothing) {
  auto const alone = [&](std::string const& from, std::string const& to) {
    json_ = numbers_alone();
    replace(json_, from, to);
    return refusal();
  };
  EXPECT_EQ(alone("\"name\": \"one\", ", ""),
            "measured.json:9: runs[0]/file is missing (the run's curve; of single numbers alone "
            "give a \"name\"). Add it?");
  EXPECT_EQ(alone("\"name\"", "\"file\": \"run1.csv\", \"name\""),
            "measured.json:9: runs[0]/name = one: stands beside a file (a run with a curve has the "
            "file's name). Remove one?");
  EXPECT_EQ(alone("\"max_force\"", "\"ejection_force\""),
            "measured.json:9: runs[0]: a run without a file has no max_force (a curve is missing, "
            "so only numbers can be held together: force, gap and compact). Add it to its scalars, "
            "or a file?");
  EXPECT_EQ(alone("\"porosity\": {\"value\": 0.2608, \"sd\": 0.002, \"unit\": \"1\"}",
                  "\"compact_mass\": {\"value\": 9, \"sd\": 0.1, \"unit\": \"g\"}"),
            "measured.json:9: runs[0]: a run without a file has no compact_height and no porosity "
            "(a curve is missing, so only numbers can be held together: force, gap and compact). "
            "Add it to its scalars, or a file?");
  EXPECT_EQ(alone("25095, \"sd\": 25, \"unit\": \"N\"", "25095, \"sd\": 25, \"unit\": \"kN\""),
            "measured.json:9: runs[0]: max_force = 2.5095e+07 N is 6.572e+04 MPa on the die's area "
            "(powders are pressed at 0.5 to 2000 MPa). Is its unit wrong by 1000?");
  EXPECT_EQ(alone("0.2608", "26.08"),
            "measured.json:9: runs[0]: porosity = 26.08 is not between 0 and 1 (a share of the "
            "compact's volume). Is it in per cent?");
  EXPECT_EQ(alone("\"porosity\": {\"value\": 0.2608, \"sd\": 0.002, \"unit\": \"1\"}",
                  "\"compact_height\": {\"value\": 9.5, \"sd\": 0.1, \"unit\": \"m\"}"),
            "measured.json:9: runs[0]: compact_height = 9500 mm does not belong to a bed of 11 mm "
            "that is pressed to 8 mm. Is its unit wrong by 1000?");
  EXPECT_EQ(alone("3.52", "-3.52"),
            "measured.json:4: sample/solid_density/value = -3.52: is not positive (there is "
            "something to press). Is the sign wrong?");
}

TEST_F(MeasuredFileRefused, WhenMassAndDieMakeNoPowder) {
  EXPECT_EQ(with("\"unit\": \"g\"", "\"unit\": \"kg\""),
            "measured.json:8: runs[0]: 9130 g in a die of 22.05 mm at the end gap of 8 mm makes "
            "2.989e+06 kg/m^3 (powders have 50 to 25000). Is a unit wrong by 1000?");
  EXPECT_EQ(with("\"unit\": \"mm\"", "\"unit\": \"um\""),
            "measured.json:8: runs[0]: 9.13 g in a die of 0.02205 mm at the end gap of 8 mm makes "
            "2.989e+09 kg/m^3 (powders have 50 to 25000). Is a unit wrong by 1000?");
}

TEST_F(MeasuredFileRefused, WhenALinkLeavesTheFolder) {
  support::ScratchFolder folder, elsewhere;
  support::put_bytes(folder / "measured.json", json_);
  support::put_bytes(elsewhere / "run1.csv", files_["run1.csv"]);
  std::filesystem::create_symlink(elsewhere / "run1.csv", folder / "run1.csv");
  try {
    read_measured(folder.path());
    FAIL();
  } catch (dem::InvalidInput const& problem) {
    EXPECT_NE(std::string(problem.what()).find("outside the folder"), std::string::npos)
        << problem.what();
  }
}

} // namespace
} // namespace coupling::measured
