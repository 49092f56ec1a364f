#pragma once

#include "coupling/measured/lab_file.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// What is wrong between the rows of a table: its clock, rows that repeat, single wild readings.
/// Everything that is left out is named among the table's decisions.
namespace coupling::measured {

/// Where a table came from, for messages and decisions.
struct TableName {
  std::string path; ///< for messages
  std::string file; ///< for decisions
};

/// Leaves out the rows that are not kept.
/// @param is_kept  one a row
void keep_rows(LabTable& table, std::vector<bool> const& is_kept);

/// Gives a table without a running clock the stated one: row k has time k interval. Refuses a
/// clock that stands still where no interval is stated, and a running one where it is.
void set_clock(LabTable& table, std::optional<double> interval, TableName const& name);

/// Leaves out rows that repeat the row before, and the few that contradict it at the same time;
/// spreads the rows of a coarse clock, where many rows share a tick, evenly over it.
/// @throws dem::InvalidInput  `path:line: ...` where time goes backwards
void order_rows(LabTable& table, TableName const& name);

/// Leaves out rows with a reading that left the line between its neighbours and came back at once,
/// by more than limits::spike_steps of the steps around it, spike_sds of its standard uncertainty
/// and spike_share of its range. The row of the smallest gap is never one: a sharp turn looks
/// alike. Two wild rows in a row are not seen here.
void drop_spikes(LabTable& table, std::span<Channel const> channels, TableName const& name);

/// @throws dem::InvalidInput  if more than limits::corrupt_share of n_rows was left out as corrupt
void check_corrupt_share(LabTable const& table, TableName const& name);

} // namespace coupling::measured
