#include "coupling/reduced/press_model.hpp"

#include "coupling/reduced/compact.hpp"
#include "dem/expect.hpp"

#include <algorithm>

namespace coupling::reduced {
namespace {

using diagnosis::Phase;
using Eigen::Index;
using Eigen::VectorXd;

double value_of(ChainReading const& at, std::string_view channel) {
  if (channel == "upper_punch_force")
    return at.load_cell;
  if (channel == "lower_punch_force")
    return at.forces.lower;
  EXPECT(channel == "wall_radial_pressure");
  return at.forces.radial_pressure;
}

/// Rows of one run, from `row` on. @return  the row after them
Index predict_run(Press const& press, PlannedRun const& run, Index row, VectorXd& rows) {
  auto const cycle = press_cycle(press.pressed, press.machine, run.course, run.times);
  for (auto const& block : run.blocks)
    for (auto const& [places] : block.rows)
      rows[row++] = block.phase == Phase::after ? compact_number(block.channel, press, cycle)
                                                : 0.5 * (value_of(cycle[places[0]], block.channel) +
                                                         value_of(cycle[places[1]], block.channel));
  return row;
}

} // namespace

Index PressPlan::n_rows() const {
  Index n = 0;
  for (auto const& run : runs)
    for (auto const& block : run.blocks)
      n += static_cast<Index>(block.rows.size());
  return n;
}

VectorXd predict_plan(Press const& press, PressPlan const& plan) {
  VectorXd rows(plan.n_rows());
  Index row = 0;
  for (auto const& run : plan.runs)
    row = predict_run(press, run, row, rows);
  return rows;
}

PressModel::PressModel(Press nominal, Sheet const& sheet, RepeatScatter const& scatter,
                       PressPlan plan)
    : nominal_(std::move(nominal)), sheet_(sheet), scatter_(scatter), plan_(std::move(plan)),
      scatters_(scatters_of(scatter)) {
  VALIDATE(plan_.n_rows() > 0, "press model: nothing is to be foretold. Does a run hold values?");
  nominal_.machine.gap_is_of_faces = plan_.gap_is_of_faces;
  nominal_.cohesion_density = sheet.cohesion;
  calibrated_.push_back({.name = "young_modulus",
                         .unit = "Pa",
                         .mean = sheet.young_modulus,
                         .sd = sheet.young_modulus_sd,
                         .is_logarithmic = true});
  if (sheet.cohesion > 0.0)
    calibrated_.push_back({.name = "cohesion",
                           .unit = "J/m^3",
                           .mean = sheet.cohesion,
                           .sd = sheet.cohesion_sd,
                           .is_logarithmic = true});
  for (auto const& cause : known_causes())
    mechanisms_.push_back(cause.mechanism);
}

Press PressModel::press_at(diagnosis::Parameters const& at) const {
  Press press = nominal_;
  auto& law = press.pressed.law;
  double const stiffer = at.calibrated[0] / sheet_.young_modulus;
  law.stiffness *= stiffer;
  law.cohesion *= stiffer;
  if (sheet_.cohesion > 0.0)
    law.cohesion =
        std::max(law.cohesion + cohesion_slope * (at.calibrated[1] - sheet_.cohesion), 0.0);
  auto const& causes = known_causes();
  for (std::size_t j = 0; j < causes.size(); ++j)
    if (double const size = at.sizes[static_cast<Index>(j)]; size != 0.0)
      causes[j].apply(press, size, at.shapes[j]);
  apply_scatter(press, at.scatter);
  return press;
}

VectorXd PressModel::predict(diagnosis::Parameters const& at) const {
  return predict_plan(press_at(at), plan_);
}

PressModel PressModel::with_plan(PressPlan plan) const {
  return {nominal_, sheet_, scatter_, std::move(plan)};
}

} // namespace coupling::reduced
