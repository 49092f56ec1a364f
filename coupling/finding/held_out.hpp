#pragma once

#include "coupling/finding/finding_of.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/error_sources.hpp"
#include "coupling/reduced/measured_plan.hpp"
#include "coupling/reduced/press_model.hpp"

namespace coupling::finding {

/// A model at one point.
struct FittedPress {
  reduced::PressModel model;
  diagnosis::Parameters at;
  std::vector<int> active; ///< mechanisms that are on
};

/// Runs that no fit has seen, and what fitted presses foretell of them.
class HeldOutRuns {
public:
  /// @param sources  of the fitted runs: shares and tolerances are taken over
  /// @param fit, uncertainty  of the simulation that the presses stand for
  HeldOutRuns(measured::MeasuredData const& data, diagnosis::ErrorSources const& sources,
              reduced::BedFit const& fit, reduced::BedUncertainty const& uncertainty);

  bool empty() const { return runs_.empty(); }
  std::vector<diagnosis::HeldOutRun> compared(FittedPress const& before,
                                              FittedPress const& after) const;
  std::vector<RunCurve> curves(FittedPress const& before, FittedPress const& after) const;

private:
  struct Run {
    reduced::PressPlan plan;
    diagnosis::Observations observations;
    std::vector<diagnosis::ChannelError> channels;
  };
  diagnosis::HeldOutRun compared(Run const& run, FittedPress const& before,
                                 FittedPress const& after) const;
  std::vector<Run> runs_;
  diagnosis::Tolerances tolerances_;
  reduced::BedFit fit_;
  reduced::BedUncertainty uncertainty_;
};

} // namespace coupling::finding
