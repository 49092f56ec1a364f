#pragma once

#include "coupling/diagnosis/error_terms.hpp"
#include "coupling/reduced/press_model.hpp"

#include <string>
#include <vector>

namespace coupling::reduced {

/// What the instruments of a laboratory are good for: standard deviations of a single reading y,
/// sqrt(sd^2 + (relative y)^2), and how often the logger reads.
struct Instruments {
  double force_sd = 12.0, force_relative = 5e-4;       ///< [N], [1], both punches
  double pressure_sd = 80e3, pressure_relative = 1e-3; ///< [Pa], [1], radial
  double height_sd = 15e-6;                            ///< [m], of the compact, by caliper
  double ejection_sd = 10.0;                           ///< [N], largest ejection force
  double reading_rate = 10.0;                          ///< [1/s], of the logger
  int n_repeats = 1;                                   ///< pressings whose mean a run is
};

/// One pressing of a set.
struct SetPressing {
  double speed; ///< [m/s], closing
  double gap;   ///< [m], where the closing ends
  double dwell; ///< [s], there
};

/// What a laboratory reads, and in which pressings.
struct InstrumentSet {
  std::string name;                  ///< "A"
  std::string words;                 ///< "upper force, one run"
  std::vector<std::string> channels; ///< curves
  std::vector<std::string> scalars;  ///< of the compact
  std::vector<SetPressing> pressings;
};

/// The five sets of the diagnosis note's 4.2 around a pressing at one speed to one gap:
///   A  upper force, one run
///   D  all gauges (both forces, radial pressure, ejection force, compact height), one run
///   E  all gauges, that and a run at 25 times the speed
///   F  upper force and compact height, five runs: those, one to a gap 5 % larger, one with a dwell
///      of 60 s, one at 5 times the speed to a gap 2.5 % larger
///   G  all gauges, five runs
std::vector<InstrumentSet> usual_instrument_sets(double speed, double gap);

/// Rows that are not measured yet.
struct PlannedRows {
  PressPlan plan;
  std::vector<diagnosis::ChannelBlock> blocks;   ///< values: as the press foretells them
  std::vector<diagnosis::ChannelError> channels; ///< by the instruments
};

/// Rows of a set on a press that is as it should be: as `measured_rows` makes them of readings, so
/// 24 rows of a channel while the punch closes on the bed, 6 in a dwell, 16 while it opens (fewer
/// if the logger reads less), one of the upper force before contact and one after it. Punches open
/// at 25 times the speed of `speed`.
/// @param fill_height  [m], gap at which a pressing begins
/// @param speed        [m/s], of the first pressing
/// @throws dem::InvalidInput if the bed does not bear at a set's gap, or as press_course does
PlannedRows planned_rows(Press const& press, InstrumentSet const& set,
                         Instruments const& instruments, double fill_height);

} // namespace coupling::reduced
