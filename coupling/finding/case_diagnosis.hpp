#pragma once

#include "coupling/finding/extended_case.hpp"
#include "coupling/finding/finding_of.hpp"
#include "coupling/finding/held_out.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/error_sources.hpp"
#include "coupling/reduced/measured_plan.hpp"
#include "coupling/reduced/simulated_press.hpp"

namespace coupling::finding {

struct CaseQuestion {
  Case const& setup;
  measured::MeasuredData const& data;
  reduced::SimulatedPress const& simulated; ///< a simulation of the case
  Provenance provenance;
  diagnosis::DiagnosisSettings settings = {};
};

/// Measured data against a simulation of the case: the whole way from measured runs to a verdict
/// and, where runs are held out, to the gain. What the question refers to outlives it.
class CaseDiagnosis {
public:
  /// @throws dem::InvalidInput as its parts do
  explicit CaseDiagnosis(CaseQuestion const& question);

  /// Everything that the files hold; gains by the emulator unless they were measured by re-runs.
  Finding finding() const;
  /// Whether a cause is named and held-out runs are there to show its worth.
  bool can_gain() const { return named_ != nullptr && !held_out_.empty(); }
  /// Effect of a named cause as simulations without and with it show it, over the one that was
  /// found:  e . s / e . e,  e = L^-1 (f(a) - f(0)) of the emulator, s = L^-1 (f_with - f_without)
  /// of the simulated beds in the laboratory's machine, over the fitted rows.
  /// @throws std::out_of_range for a cause that is not named
  double effect_shown(std::string_view cause, reduced::SimulatedPress const& without,
                      reduced::SimulatedPress const& with) const;
  /// Gains with simulations of the calibrated and the extended case in the place of the emulator's
  /// own extrapolation: what lies between grains is theirs, machine, mass and die are exact, and E
  /// and cohesion are calibrated once more against the fitted runs.
  void score_simulations(reduced::SimulatedPress const& calibrated,
                         reduced::SimulatedPress const& extended);

private:
  reduced::Press in_machine(reduced::SimulatedPress const& simulated,
                            diagnosis::Parameters const& at) const;
  FittedPress calibrated_press() const;
  FittedPress extended_press(diagnosis::Hypothesis const& by) const;
  FittedPress recalibrated(reduced::SimulatedPress const& simulated,
                           diagnosis::Parameters const& at) const;
  ScoredGain scored(FittedPress const& before, FittedPress const& after) const;

  CaseQuestion question_;
  reduced::MeasuredRows rows_;
  reduced::PressModel model_;
  diagnosis::Observations observations_;
  diagnosis::ErrorSources sources_;
  diagnosis::Diagnosis found_;
  HeldOutRuns held_out_;
  diagnosis::Hypothesis const* named_ = nullptr; ///< in found_
  std::optional<ScoredGain> gain_, placebo_;
  std::vector<RunCurve> held_out_curves_;
};

} // namespace coupling::finding
