#pragma once

#include "coupling/study/results_table.hpp"

#include <string>

namespace coupling::study {

/// Curves of the finished runs for figure 4, as JSON text: {"stages": [{"name", "from", "to"}] [s]
/// of the first run, "runs": [{"run", "setup", "factors": [coded], "validation", "time",
/// "upper_punch_force", "compact_height", "mean_overlap", "punch_gap"}]}, thinned to about `most`
/// rows a run; the peak, the smallest gap and the ends of the stages are kept. Runs without a
/// curves.csv are left out.
std::string curves_json(ResultsTable const& table, std::size_t most);

/// Final shapes of the finished runs for figure 5, as JSON text: {"width", "height", "metres": the
/// frame's width, "runs": [{"run", "pixels": base64}]}, grain_picture.hpp, all in one frame. Runs
/// without a run.h5 are left out.
std::string shapes_json(ResultsTable const& table, int width);

} // namespace coupling::study
