#pragma once

#include "coupling/diagnosis/error_model.hpp"
#include "coupling/diagnosis/size_interval.hpp"
#include "coupling/diagnosis/verdict.hpp"

namespace coupling::diagnosis {

struct DiagnosisSettings {
  MisfitSettings misfit{};
  SelectionSettings selection{};
  VerdictRules rules{};
  int n_iterations = 2; ///< how often Sigma is computed again at the best hypothesis
};

/// The smallest size of a mechanism that these data would have shown, 5 standard uncertainties.
struct Detectable {
  std::string name, unit;
  double size; ///< infinite if the data do not see it
};

struct CauseEstimate {
  int mechanism;
  double probability; ///< P(not none) p_j, at most VerdictRules::largest_printed
  SizeInterval size;
};

/// Where a Sigma is taken: it grows with predictions, and the forms of active mechanisms have
/// slack.
struct SigmaPoint {
  Parameters at;
  std::vector<int> active;
};

struct Diagnosis {
  ErrorModel errors; ///< at the calibrated baseline, under which the tests were made
  Fit baseline;      ///< under that
  MisfitTests tests;
  std::vector<Detectable> detectable;   ///< in the model's order
  Comparison comparison;                ///< under the common Sigma of the selection
  SigmaPoint sigma_at;                  ///< where that Sigma was taken
  Fit baseline_in_common;               ///< under that
  SignatureLibrary library;             ///< under that
  Selection selection;                  ///< empty without an alarm
  std::vector<CauseEstimate> estimates; ///< of the causes of the best hypothesis
  Verdict verdict;
};

/// The whole way: error model, calibrated baseline, tests, selection under a common Sigma that is
/// computed again at the best hypothesis, intervals, verdict. Causes are looked for only after an
/// alarm. Deterministic: the same input and seed give the same bits.
/// @throws dem::InvalidInput as its parts do
Diagnosis diagnose(Observations const& observations, Model const& model,
                   ErrorSources const& sources, DiagnosisSettings const& settings = {});

/// r.m.s. size that each mechanism takes, refitted alone, on data sets without any effect, made by
/// the finest own simulator: the empirical null (Efron 2004). At least 100 sets are advised.
/// @param clean  n_rows x n_sets, in the place of the measured values
/// @throws dem::InvalidInput for no set or another number of rows
Eigen::VectorXd sizes_on_clean_data(Observations const& observations, Eigen::MatrixXd const& clean,
                                    Model const& model, ErrorSources const& sources);

} // namespace coupling::diagnosis
