#pragma once

#include "coupling/diagnosis/identifiability.hpp"
#include "coupling/diagnosis/selection.hpp"

#include <optional>
#include <string>

namespace coupling::diagnosis {

enum class VerdictKind {
  consistent, ///< nothing wrong found
  named,      ///< these causes
  undecided,  ///< one of a group
  unknown     ///< something is wrong that no known cause explains
};
std::string_view name_of(VerdictKind kind);

/// Where one verdict ends and the next begins. Source: diagnosis note 2c to 2e.
struct VerdictRules {
  double naming = 0.9; ///< probability from which a cause is named
  double rival = 0.05; ///< probability over the best's from which a hypothesis stays possible
  double near_objective = 6.0; ///< a rival in a cause's place that fits so nearly as well (chi^2
                               ///< and priors, over S) stays possible, however wide its prior
  double indistinct = 2.0;     ///< Delta below which a rival is possible whatever its probability
  double failing_sds = 4.0;    ///< chi^2 above its expectation from which a hypothesis has failed
  double explained = 0.9;      ///< share of the misfit above which a failed hypothesis still names
  double prior_sds = 3.0;      ///< a calibrated parameter that far from its sheet is a finding
  double shape_sds = 3.0;      ///< a shape that far from what is known makes its name incomplete
  double gate_errors = 2.0;    ///< standard errors by which a name must win on held-out runs
  double largest_printed = 0.97; ///< probabilities are printed at most so large until calibrated
};

/// A calibrated parameter that does not have the value of its sheet.
struct ParameterFinding {
  int parameter;               ///< among the calibrated
  double value, z;             ///< [unit]; departure in prior standard deviations
  std::vector<int> equivalent; ///< mechanisms that do the same to these data (Delta < separable)
};

struct Verdict {
  VerdictKind kind = VerdictKind::consistent;
  bool is_incomplete = false; ///< named, but structure remains, or in a form that it hardly has
  std::vector<int> causes;    ///< of `named`
  std::vector<int> group;     ///< of `undecided`, the most probable first
  std::vector<ParameterFinding> parameters;
  double explained_share = 1.0; ///< 1 - (chi^2_best - E) / (chi^2_none - E), only if that is misfit
  std::vector<std::string> statements; ///< a sentence each
};

/// What a verdict stands on. `chi_squared_none` and the selection are under the same Sigma.
struct Findings {
  Model const& model;
  Fit const& baseline;
  MisfitTests const& tests;
  Selection const& selection;
  SignatureLibrary const& library;   ///< under the Sigma of the selection
  Eigen::VectorXd const& null_sizes; ///< r.m.s. on clean data, empty = none
  double null_multiple;
  /// With it a cause's effect is what its fitted size does; without, its signature times its size,
  /// which is less for an effect that goes with a power of its size.
  Comparison const* comparison = nullptr;
};

/// No alarm: consistent, or a parameter's value. An alarm: the most probable set of causes,
/// - unknown if it fails and explains too little, or if "none" is more probable and T1 alarms;
/// - its causes of probability >= naming that exceed null_multiple null sizes and have no rival
///   (indistinct by Delta, or near by its own fit): named, incomplete if the hypothesis fails or a
///   part of it cannot be named;
/// - undecided otherwise, with the group of the possible causes.
/// The rule of the near fit is there because evidence pays for the width of a prior: of two causes
/// that fit alike, the one with the narrower prior is more probable, which is no measurement.
Verdict decide(Findings const& findings, VerdictRules const& rules = {});

/// A named cause that does not beat the calibrated baseline on runs that were left out is not
/// named: undecided, its causes the group.
/// @param elpd_difference  sum over left-out runs of ln density, named minus baseline
/// @param standard_error   of that sum, >= 0, with runs as the units
Verdict pass_gate(Verdict verdict, double elpd_difference, double standard_error,
                  VerdictRules const& rules = {});

} // namespace coupling::diagnosis
