#pragma once

#include "coupling/diagnosis/diagnose.hpp"
#include "coupling/diagnosis/next_measurement.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/press_model.hpp"

namespace coupling::reduced {

/// What a laboratory with this press could measure next, foretold at a fitted baseline: gauges that
/// the runs do not have, a dwell, other speeds and end gaps, a caliper, a balance, a dead weight, a
/// gauge between the punches. Costs are minutes. Each is a further pressing with the instruments'
/// errors as stated, or usual ones for gauges that are not there yet.
std::vector<diagnosis::CandidateMeasurement>
measurement_catalogue(PressModel const& model, measured::MeasuredData const& data,
                      std::vector<diagnosis::ChannelError> const& channels,
                      diagnosis::ErrorSources const& sources,
                      diagnosis::Parameters const& baseline);

} // namespace coupling::reduced
