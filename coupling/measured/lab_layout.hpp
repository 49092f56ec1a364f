#pragma once

#include <map>
#include <optional>
#include <string>

/// What a person may state about a laboratory file where its header does not say it.
namespace coupling::measured {

struct ColumnChoice {
  std::string name;              ///< as the header of the file writes it
  std::string unit = {};         ///< empty: the header's
  std::optional<double> at_zero; ///< [m], gap where a travel reads zero: gap = at_zero - travel
};

struct LabLayout {
  std::map<std::string, ColumnChoice> columns = {}; ///< by channel, and `time`
  std::string decimal_mark = {};                    ///< "." or ","; empty: found out
  std::optional<double> interval = {}; ///< [s], between rows, for a file whose clock stands still
};

/// How the clocks of a file of forces and a file of positions are brought together.
enum class Alignment {
  common,        ///< they are one clock
  stated,        ///< a shift was written down
  first_contact, ///< gap passes the fill height when the force leaves its noise
  turning_point  ///< closing ends when the force is highest
};

struct ClockChoice {
  Alignment align = Alignment::turning_point;
  bool is_stated = false; ///< a person chose it
  double shift = 0.0;     ///< [s], added to the position's time; of `stated`
  double sd = 0.0;        ///< [s], its standard uncertainty; of `common` and `stated`
};

} // namespace coupling::measured
