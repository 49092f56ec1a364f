#pragma once

#include "coupling/diagnosis/error_terms.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/press_plan.hpp"

namespace coupling::reduced {

/// How readings become rows.
struct Binning {
  std::size_t n_loading = 24, n_dwell = 6, n_unloading = 16; ///< rows of a channel in a phase, most
  double contact_share = 0.005; ///< of the largest force, where the bed begins or ceases to bear
};

/// What a laboratory measured, as rows, and what must be foretold for each of them.
struct MeasuredRows {
  PressPlan plan;
  std::vector<diagnosis::ChannelBlock> blocks;   ///< the same blocks in the same order
  std::vector<diagnosis::ChannelError> channels; ///< as the laboratory states them
  std::vector<std::string> left_out;             ///< what was measured and is not used, in words
};

/// Readings of one channel in one phase are put in time's order into parts of equal number; a row
/// is the mean of one part. Closing begins a little before the bed bears; all readings before are
/// one row, and all after it ceases to bear one more, of the upper force alone. The course of the
/// gap is that of the gap's own readings, smoothed likewise, with corners where its straight ends
/// meet.
/// @param role  runs of that role
/// @throws dem::InvalidInput if a run never closes, or none has the role
MeasuredRows measured_rows(measured::MeasuredData const& data, measured::Role role,
                           Binning const& binning = {});

} // namespace coupling::reduced
