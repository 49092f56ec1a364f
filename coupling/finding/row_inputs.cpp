#include "coupling/finding/row_inputs.hpp"

#include <cmath>

namespace coupling::finding {
namespace {

using diagnosis::Phase;
using Eigen::Index;
using Eigen::VectorXd;

double time_of(reduced::PlannedRun const& run, reduced::PlannedBlock const& block,
               reduced::RowNodes const& row) {
  return block.phase == Phase::after ? turning_of(run.course).closed
                                     : 0.5 * (run.times[row.places[0]] + run.times[row.places[1]]);
}

/// A number for every row.
VectorXd for_rows(reduced::PressPlan const& plan, auto const& number) {
  VectorXd all(plan.n_rows());
  Index row = 0;
  for (auto const& run : plan.runs)
    for (auto const& block : run.blocks)
      for (auto const& one : block.rows)
        all[row++] = number(run, block, one);
  return all;
}

double closing_speed(reduced::PlannedRun const& run) {
  auto const turning = turning_of(run.course);
  double const before = turning.closed - 0.2 * (turning.closed - run.course.time.front());
  return (run.course.at(before) - turning.gap) / (turning.closed - before);
}

} // namespace

RowPlaces places_of(reduced::PressPlan const& plan) {
  return {.time = for_rows(plan, time_of),
          .gap = for_rows(plan, [](auto const& run, auto const& block, auto const& row) {
            return run.course.at(time_of(run, block, row));
          })};
}

std::vector<diagnosis::RowInput> row_inputs(reduced::PressPlan const& plan,
                                            diagnosis::Observations const& observations,
                                            VectorXd const& predicted) {
  auto const places = places_of(plan);
  VectorXd coordinate(observations.size());
  for (std::size_t b = 0; b < observations.blocks().size(); ++b) {
    auto const& [first, n] = observations.rows()[b];
    coordinate.segment(first, n) = observations.blocks()[b].coordinate;
  }
  return {{"phase", "1", coordinate},
          {"gap", "m", places.gap},
          {"time", "s", places.time},
          {"force", "channel", predicted},
          {"ln speed", "1", for_rows(plan, [](auto const& run, auto const&, auto const&) {
             return std::log(closing_speed(run));
           })}};
}

} // namespace coupling::finding
