#pragma once

#include <string>
#include <vector>

namespace performance {

using Samples = std::vector<double>;

/// What a number must reach.
struct Bar {
  double low, high;
};
Bar at_least(double value);
Bar at_most(double value);
Bar no_bar();

/// Prints name, unit, smallest, median, largest, and the verdict on the median. @returns whether
/// the bar is met
bool print_row(std::string const& name, std::string const& unit, Samples samples,
               Bar bar = no_bar());

/// Model name of /proc/cpuinfo.
std::string processor_name();

} // namespace performance
