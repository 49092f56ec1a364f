#pragma once

#include "coupling/study/study_factor.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A study file: which runs of a case, what of them counts, what to fit and to say.
namespace coupling::study {

enum class DesignKind { table, full_factorial, central_composite, latin_hypercube };

/// A number that the runs are judged by.
struct StudyResponse {
  std::string name;                  ///< F
  std::string quantity;              ///< max_force
  std::string where;                 ///< `study.prm:31`
  std::string unit;                  ///< SI; `1` for a ratio
  std::optional<double> target;      ///< [SI]
  std::optional<double> uncertainty; ///< [SI], standard uncertainty of the target
};

/// Rows of another table of results, which count only where `column` says `text`.
struct ResultsFilter {
  std::string column;
  std::string text;
};

struct StudyDesign {
  DesignKind kind = DesignKind::table;
  std::string kind_name;
  std::filesystem::path table;   ///< absolute; of a table design
  std::vector<std::string> rows; ///< of the table; empty: all
  std::filesystem::path results; ///< absolute; empty: the runs are made
  std::vector<ResultsFilter> filter;
  int replicates = 1;
  int runs = 20;
  int centre_runs = 1;
  std::string axial_points;
  std::uint64_t seed = 1;
};

struct CalibrationPlan {
  std::map<std::string, double> held; ///< [SI], by name of a factor; the others are fitted
  bool is_validated = false;          ///< run the calibrated point
  int validation_replicates = 1;
};

struct ExtrapolationPlan {
  std::string factor;                 ///< name; empty: none
  double value = 0.0;                 ///< [SI]
  std::vector<std::string> responses; ///< names; never empty where there is a factor
};

struct StudyFile {
  StudyText text;             ///< what was written and where, for messages
  std::filesystem::path file; ///< as it was named
  std::string title;
  std::filesystem::path case_file = {}; ///< absolute
  std::vector<PlacedValue> common = {}; ///< for every run
  StudyDesign design = {};
  std::string model = "quadratic";           ///< linear, interactions, quadratic
  std::vector<StudyFactor> factors = {};     ///< none: a batch without statistics (a table only)
  std::vector<StudyResponse> responses = {}; ///< at least one where there are factors
  CalibrationPlan calibration = {};
  ExtrapolationPlan extrapolation = {};
  std::string cost_factor = {};   ///< name; empty: none
  std::string resolved_text = {}; ///< the study as understood, .prm, paths absolute

  bool is_data() const { return !design.results.empty(); }
  StudyFactor const* factor(std::string_view name) const;
};

/// @throws dem::InvalidInput  `file:line: entry = value: problem (why). Way out?`
StudyFile read_study(std::filesystem::path const& file);

/// Every entry of a study file with default, choices and meaning, as text.
std::string describe_study_entries();

} // namespace coupling::study
