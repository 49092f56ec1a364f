#pragma once

#include "coupling/diagnosis/observations.hpp"
#include "coupling/reduced/gap_course.hpp"

#include <array>
#include <string>
#include <vector>

namespace coupling::reduced {

/// A row that is the mean of many readings: the mean of the curve at two moments, one standard
/// deviation of the readings' times before and after their mean, which is exact for a parabola.
struct RowNodes {
  std::array<std::size_t, 2> places; ///< in PlannedRun::times
};

/// One channel of one run in one phase.
struct PlannedBlock {
  std::string channel; ///< of the outward contract; a scalar's name in the phase `after`
  diagnosis::Phase phase = diagnosis::Phase::loading;
  std::vector<RowNodes> rows; ///< of a scalar: one, whose places count for nothing
};

/// One pressing that is to be foretold.
struct PlannedRun {
  std::string name;
  GapCourse course;
  std::vector<double> times; ///< [s], increasing
  std::vector<PlannedBlock> blocks;
};

/// Rows of all blocks of all runs, in their order.
struct PressPlan {
  std::vector<PlannedRun> runs;
  bool gap_is_of_faces = false;
  Eigen::Index n_rows() const;
};

} // namespace coupling::reduced
