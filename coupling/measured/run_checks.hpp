#pragma once

#include "coupling/measured/lab_file.hpp"
#include "coupling/measured/measured_data.hpp"

#include <string>

/// Whether a run can be what it says that it is: columns in their places, units, protocol. All
/// throw dem::InvalidInput with the numbers; limits.hpp has the limits and why they are so.
namespace coupling::measured {

/// What the checks look at.
struct RunCheck {
  MeasuredData const& data; ///< sample and channels
  Run const& run;
  LabTable const& table; ///< for the units that were written
  std::string path;      ///< of the run's file, for messages
};

/// Mass, die and end gap make a density that powders have, else one of their units is wrong.
void check_sample(Sample const& sample, PressProtocol const& press, std::string const& where);

/// A run of single numbers alone holds a force and what its compact measures, in units that are not
/// wrong by 1000.
void check_numbers(Sample const& sample, Run const& run, std::string const& where);

/// Gap and force are not in each other's column: read the other way round they would fit the
/// protocol, and as they stand they do not.
void check_not_swapped(RunCheck const& check);

/// Gap against end gap, force against what the die's area allows, the other channels against the
/// force, uncertainties against readings: none is off by a factor nearer to 1000 than to 1.
void check_units(RunCheck const& check);

/// The force is highest where the gap is smallest, and positive in compression.
void check_turning(RunCheck const& check);

/// The smallest gap is the end gap, and the closing as fast as the protocol says, within the
/// limits; a measured gap may stay above by what the frame yields.
/// @return  what could not be checked, in words; empty if all could
std::string check_protocol(RunCheck const& check);

} // namespace coupling::measured
