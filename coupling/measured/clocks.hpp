#pragma once

#include "coupling/measured/clean_rows.hpp"
#include "coupling/measured/lab_file.hpp"

#include <string>

namespace coupling::measured {

/// A time with its standard uncertainty [s].
struct Instant {
  double time;
  double sd;
};

/// When the force is highest first: the first reading within three standard uncertainties of the
/// largest.
Instant force_turn(LabTable const& forces, Channel const& force);

/// When the closing ends: the straight line through the readings between half and nine tenths of
/// the travel meets the smallest gap. So a dwell does not blur it.
Instant gap_turn(LabTable const& positions, Channel const& gap);

/// When the bed begins to push. A force F = c (t - t0)^p passes the level of its noise,
/// limits::noise_sds, at t1 and eight times that level at t2, so t1 - t0 = (t2 - t1) / (8^(1/p) -
/// 1). With p between 1.5 (one Hertz contact) and 3 (as press curves rise) t0 is t1 - 2/3 (t2 -
/// t1), give or take the same spread evenly: (t2 - t1) / 27^(1/2).
Instant force_contact(LabTable const& forces, Channel const& force);

/// When the gap passes the fill height.
Instant gap_contact(LabTable const& positions, PressProtocol const& press);

/// The forces' table with the gap of the positions' table, whose time is shifted as `choice` says
/// and which is interpolated straight between its readings; force readings before its first or
/// after its last one are left out. Clocks that are aligned by the data can no longer tell a lag of
/// the force.
/// @param clock_sd  [s], out: standard uncertainty of the shift
/// @throws dem::InvalidInput  if the criterion is not met in the data or the records do not overlap
LabTable joined_by_time(LabTable forces, LabTable const& positions, ClockChoice const& choice,
                        PressProtocol const& press, MeasuredData const& data, TableName const& name,
                        std::string const& position_file, double& clock_sd);

} // namespace coupling::measured
