#pragma once

#include "coupling/measured/read_measured.hpp"
#include "coupling/measured/write_measured.hpp"
#include "dem/expect.hpp"
#include "tests/support/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// Measured data as texts, which a test spoils in one place.
class MeasuredTexts : public testing::Test {
protected:
  static constexpr double fill_height = 11e-3, end_gap = 8e-3, speed = 5e-5; // 60 s to close

  /// A row of a pressing: closing in 60 s, 2 s of dwell, opening at ten times the speed.
  struct Row {
    double time, gap, force;
  };
  static std::vector<Row> press_rows(double end = end_gap) {
    std::vector<Row> rows;
    double const stroke = fill_height - end;
    double const n = std::round(stroke / speed);
    for (int k = 0; k <= n; ++k) {
      double const s = k / n;
      rows.push_back({1.0 * k, fill_height - s * stroke, 25e3 * std::pow(s * stroke / 3e-3, 3)});
    }
    double const peak = rows.back().force;
    for (int k = 1; k <= 2; ++k)
      rows.push_back({n + k, end, peak * (1 - 0.01 * k)});
    for (int k = 1; k <= 6; ++k)
      rows.push_back({n + 2 + k, end + k * 10 * speed, std::max(0.0, peak * (0.97 - 0.4 * k))});
    return rows;
  }

  static std::string csv(std::vector<Row> const& rows) {
    std::string text = "time [s],punch_gap [m],upper_punch_force [N]\n";
    for (auto const& row : rows)
      text += fmt::format("{},{},{}\n", row.time, row.gap, row.force);
    return text;
  }

  static std::string press(double end = end_gap) {
    return fmt::format("{{\"speed_down\": {}, \"speed_up\": {}, \"end_gap\": {}, \"fill_height\": "
                       "{}, \"unit\": \"SI\"}}",
                       speed, 10 * speed, end, fill_height);
  }

  static std::string description(std::string const& more = "") {
    return "{\n"
           "  \"sample\": {\"mass\": {\"value\": 9.13, \"sd\": 0.01, \"unit\": \"g\"},\n"
           "    \"die_diameter\": {\"value\": 22.05, \"sd\": 0.005, \"unit\": \"mm\"}},\n"
           "  \"channels\": {\"upper_punch_force\": {\"unit\": \"N\", \"sd\": 12.0},\n"
           "    \"punch_gap\": {\"unit\": \"um\", \"sd\": 2}},\n"
           "  \"gap_source\": \"commanded\",\n" +
           more +
           "  \"runs\": [\n"
           "    {\"file\": \"run1.csv\", \"role\": \"fit\", \"press\": " +
           press() +
           "},\n"
           "    {\"file\": \"run2.csv\", \"role\": \"held-out\", \"press\": " +
           press(8.5e-3) + "}]\n}\n";
  }

  /// A pressing of which a force and a porosity are known, and nothing else.
  static std::string numbers_alone() {
    return "{\n"
           "  \"sample\": {\"mass\": {\"value\": 9.13, \"sd\": 0.01, \"unit\": \"g\"},\n"
           "    \"die_diameter\": {\"value\": 22.05, \"sd\": 0.005, \"unit\": \"mm\"},\n"
           "    \"solid_density\": {\"value\": 3.52, \"sd\": 0.08, \"unit\": \"g/cm^3\"}},\n"
           "  \"channels\": {\"upper_punch_force\": {\"unit\": \"N\", \"sd\": 12.0},\n"
           "    \"punch_gap\": {\"unit\": \"um\", \"sd\": 100}},\n"
           "  \"gap_source\": \"commanded\",\n"
           "  \"runs\": [\n"
           "    {\"name\": \"one\", \"role\": \"fit\", \"press\": " +
           press() +
           ",\n"
           "     \"scalars\": {\"max_force\": {\"value\": 25095, \"sd\": 25, \"unit\": \"N\"},\n"
           "       \"porosity\": {\"value\": 0.2608, \"sd\": 0.002, \"unit\": \"1\"}}}]\n}\n";
  }

  std::string json_ = description();
  std::map<std::string, std::string> files_ = {{"run1.csv", csv(press_rows())},
                                               {"run2.csv", csv(press_rows(8.5e-3))}};

  coupling::measured::MeasuredData read() const { return read(json_, files_); }

  static coupling::measured::MeasuredData read(std::string const& json,
                                               std::map<std::string, std::string> const& files) {
    return coupling::measured::parse_measured(json, "", [&](std::string const& file) {
      VALIDATE(files.contains(file), file + ": is not there");
      return files.at(file);
    });
  }

  /// What is refused, in words.
  std::string refusal() const {
    try {
      read();
      return "accepted";
    } catch (dem::InvalidInput const& problem) {
      return problem.what();
    }
  }

  std::vector<std::string> decisions() const {
    std::vector<std::string> words;
    for (auto const& decision : read().decisions)
      words.push_back(coupling::measured::in_words(decision));
    return words;
  }

  /// The first occurrence of `from` in the text replaced.
  static void replace(std::string& text, std::string const& from, std::string const& to) {
    auto const at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }

  /// Row k of run1.csv, 1 for the header.
  void set_row(std::size_t number, std::string const& row) {
    std::string& text = files_["run1.csv"];
    std::size_t begin = 0;
    for (std::size_t k = 1; k < number; ++k)
      begin = text.find('\n', begin) + 1;
    text.replace(begin, text.find('\n', begin) - begin, row);
  }
};
