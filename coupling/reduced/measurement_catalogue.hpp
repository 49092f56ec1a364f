#pragma once

#include "coupling/diagnosis/diagnose.hpp"
#include "coupling/diagnosis/next_measurement.hpp"
#include "coupling/reduced/error_sources.hpp"
#include "coupling/reduced/measured_plan.hpp"

namespace coupling::reduced {

/// What was measured, and how it is weighed.
struct Measured {
  measured::MeasuredData const& data;
  MeasuredRows const& rows;
  diagnosis::Whitener const& whitener; ///< of the rows' Sigma
  diagnosis::SigmaPoint const& at;     ///< where that was taken
};

/// What a laboratory with this press could measure next, foretold at a fitted baseline: gauges that
/// the runs do not have, a dwell, other speeds and end gaps, a caliper, a balance, a dead weight, a
/// gauge between the punches. Costs are minutes. Each is a further pressing with the instruments'
/// errors as stated, or usual ones for gauges that are not there yet; the simulation errs in it as
/// it does in what is measured.
std::vector<diagnosis::CandidateMeasurement>
measurement_catalogue(PressModel const& model, SimulatedPress const& simulated,
                      Measured const& measured, diagnosis::Parameters const& baseline);

} // namespace coupling::reduced
