#pragma once

#include "coupling/study/anova.hpp"
#include "coupling/study/calibration.hpp"
#include "coupling/study/cost_forecast.hpp"
#include "coupling/study/joint_region.hpp"
#include "coupling/study/results_table.hpp"
#include "coupling/study/screening.hpp"
#include "coupling/study/size_trend.hpp"

#include <optional>
#include <string>
#include <vector>

namespace coupling::study {

/// A response as a surface over the coded factors.
struct ResponseAnalysis {
  StudyResponse response;
  ResponseSurface surface;
  Anova anova;
  std::vector<FactorInfluence> influences;
};

/// Where one target alone is met exactly in the one factor that is free.
struct ResponseRoots {
  std::string response;
  std::vector<TargetRoot> roots;
};

struct ResponseTrend {
  std::string response;
  Extrapolation trend;
  std::vector<double> sizes, responses; ///< that it was fitted to, one a run
  std::vector<TrendForm> forms;         ///< that the study file names
};

/// A run beside the design against what the surface foretold for it.
struct ValidationCheck {
  std::string run, response;
  double value;
  SurfacePrediction foretold;
  bool is_inside; ///< the 95 % prediction interval
};

/// What the finished runs of a study say. Values in SI.
struct Analysis {
  std::vector<ResponseAnalysis> responses;
  std::vector<OverallInfluence> influences; ///< over all responses
  std::optional<Calibration> calibration;   ///< of the responses that have targets
  std::vector<ResponseRoots> roots;         ///< where one factor is free
  std::vector<ResponseTrend> trends;
  std::vector<JointRegion> regions; ///< of the calibration, a pair of free factors each
  std::optional<CostAnalysis> cost; ///< processor time against the cost's factor
  std::vector<ValidationCheck> validation;
};

/// @throws dem::InvalidInput  `file: Model = quadratic: problem` if the design does not determine
/// the model: before anything is run
void validate_model(StudyPlan const& plan);

/// Fits every response, screens, calibrates and extrapolates as the study file asks for.
/// @throws dem::InvalidInput if the finished runs do not determine the model
Analysis analyse(ResultsTable const& table);

/// The same where every run is done and the study has a response; else nothing: which runs fail
/// hangs on the factors, and what is left would be fitted as if it did not.
std::optional<Analysis> analyse_if_complete(ResultsTable const& table);

/// The factors where the calibration stands, as natural values of a run [SI].
std::vector<double> calibrated_point(Analysis const& analysis);

/// The curves that the study file names, for a response against a size; those that cannot hold for
/// such a response are in `left_out`, with the reason.
std::vector<TrendForm> trend_forms(ExtrapolationPlan const& plan, std::vector<double> const& sizes,
                                   std::vector<double> const& responses,
                                   std::vector<std::string>& left_out);

/// Tables and sentences for a reader, in the units of the study file.
std::string describe(Analysis const& analysis, StudyFile const& study);

/// Puts the analysis into the folder's study.json, under "analysis".
/// @throws dem::InvalidInput, WriteFailed
void write_analysis(Analysis const& analysis, StudyFile const& study,
                    std::filesystem::path const& folder);

} // namespace coupling::study
