#pragma once

#include "coupling/case.hpp"
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
  std::optional<double> observed;    ///< [SI], measured; the target, if there is one
  double reference_scale = 1.0;      ///< [1], published values times this are comparable
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

/// What the packing model needs to know of the mixture.
struct PackingPlan {
  double fine_share = 0.0;       ///< [1], of the solid volume
  double compaction_index = 9.0; ///< [1]
  std::vector<SizeClass> coarse; ///< empty: one size, which is fitted
};

struct ExtrapolationPlan {
  std::string factor;                 ///< name; empty: none
  double value = 0.0;                 ///< [SI]
  std::vector<std::string> responses; ///< names; never empty where there is a factor
  std::vector<std::string> forms;     ///< linear, quadratic, logarithmic, power, packing_model
  PackingPlan packing = {};           ///< of packing_model
};

/// Word for the number of grains where a cost asks for a factor.
inline constexpr std::string_view grains_word = "grains";

struct CostPlan {
  std::string factor;             ///< name of a factor, or grains_word; empty: none
  bool is_of_grains = false;      ///< and no factor is called so
  std::vector<double> predict_at; ///< [SI]

  /// A value of the factor as the study's author would write it.
  std::string text(double at, struct StudyFile const& study) const;
};

/// Published values that stand beside those of the runs.
struct ReferencePlan {
  std::vector<std::filesystem::path> tables; ///< absolute
  std::map<std::string, std::string> rows;   ///< set-up -> what the tables call it, if otherwise
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
  CostPlan cost = {};
  ReferencePlan references = {};
  std::string resolved_text = {}; ///< the study as understood, .prm, paths absolute

  bool is_data() const { return !design.results.empty(); }
  StudyFactor const* factor(std::string_view name) const;
};

/// @throws dem::InvalidInput  `file:line: entry = value: problem (why). Way out?`
StudyFile read_study(std::filesystem::path const& file);

/// Every entry of a study file with default, choices and meaning, as text.
std::string describe_study_entries();

} // namespace coupling::study
