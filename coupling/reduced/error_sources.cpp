#include "coupling/reduced/error_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::reduced {
namespace {

using diagnosis::ChannelError;
using diagnosis::Phase;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Radial pressure of a bed of grains scatters along the wall; the ejection of a compact hangs on a
/// friction at rest that no press run tells.
constexpr double radial_share = 0.005, ejection_share = 0.15;

/// Of opening, in which the friction of the wall turns round and curves bend most [m].
constexpr double turn_length = 0.25e-3;

/// Share of the prediction that the simulator and its emulator may be wrong by.
double share_of(std::string const& channel, BedFit const& fit, double declared) {
  auto const with = [&](Departure const& a, Departure const& b) {
    return std::hypot(declared, std::max(a.rms, b.rms));
  };
  if (channel == "upper_punch_force" || channel == "max_force")
    return with(fit.loading_upper, fit.unloading_upper);
  if (channel == "lower_punch_force")
    return with(fit.loading_lower, fit.unloading_lower);
  if (channel == "wall_radial_pressure")
    return std::hypot(declared, radial_share);
  if (channel == "ejection_force")
    return ejection_share;
  return channel == "compact_mass" || channel == "compact_diameter" ? 0.0 : declared;
}

/// Share of the largest value that the emulator misses in a row.
double missed_share(PlannedRun const& run, PlannedBlock const& block, RowNodes const& row,
                    BedFit const& fit) {
  if (block.phase == Phase::after || block.phase == Phase::dwell)
    return 0.0;
  bool const is_upper = block.channel == "upper_punch_force";
  if (block.phase == Phase::loading)
    return is_upper ? fit.loading_upper.rms : fit.loading_lower.rms;
  auto const& missed = is_upper ? fit.unloading_upper : fit.unloading_lower;
  auto const turning = turning_of(run.course);
  double const opened = run.course.at(run.times[row.places[0]]) - turning.gap;
  return opened < turn_length ? missed.largest : missed.rms;
}

/// What the emulator misses of its simulation, a standard deviation a row.
VectorXd missed_by_emulator(PressPlan const& plan, VectorXd const& rows, BedFit const& fit) {
  VectorXd missed(rows.size());
  Index row = 0;
  for (auto const& run : plan.runs)
    for (auto const& block : run.blocks) {
      auto const n = static_cast<Index>(block.rows.size());
      double const largest = rows.segment(row, n).cwiseAbs().maxCoeff();
      for (auto const& nodes : block.rows)
        missed[row++] = largest * missed_share(run, block, nodes, fit);
    }
  return missed;
}

} // namespace

BedUncertainty uncertainty_of(SimulatedPress const& simulated) {
  BedUncertainty uncertainty;
  uncertainty.n_packings = simulated.n_packings;
  if (simulated.n_grains == 0)
    return uncertainty;
  uncertainty.onset = 0.0; // is in the scatter of the packings
  uncertainty.packing = packing_scatter(static_cast<double>(simulated.n_grains));
  return uncertainty;
}

RepeatScatter repeat_scatter(SimulatedPress const& simulated,
                             std::vector<ChannelError> const& channels) {
  RepeatScatter scatter;
  if (simulated.n_grains > 0)
    scatter.onset = 0.0;
  auto const cell = std::ranges::find(channels, "upper_punch_force", &ChannelError::channel);
  if (cell != channels.end())
    scatter.force_zero = cell->sd / 3.0;
  return scatter;
}

std::string packings_in_words(SimulatedPress const& simulated) {
  auto const of = uncertainty_of(simulated);
  if (simulated.n_grains == 0)
    return fmt::format(
        "the simulation's grains are not known (no run.h5): its onset is taken to be "
        "unsure by {:.2g}",
        of.onset);
  return fmt::format(
      "{} packing{} of {} grains stand{} for the simulation; a packing, simulated or "
      "pressed, departs by {:.2g} % of sqrt(F F_max) (12 packings of 2204 grains, "
      "scaled with 1 / sqrt(grains))",
      of.n_packings, of.n_packings == 1 ? "" : "s", simulated.n_grains,
      of.n_packings == 1 ? "s" : "", 100.0 * of.packing.stress);
}

MatrixXd numerical_covariance(PressModel const& model, BedFit const& fit,
                              BedUncertainty const& uncertainty) {
  auto const nominal = model.press_at(nominal_parameters(model));
  auto const at_nominal = predict_plan(nominal, model.plan());
  MatrixXd changes(at_nominal.size(), 5);
  Index column = 0;
  auto const vary = [&](auto change) {
    Press press = nominal;
    change(press.pressed.law);
    changes.col(column++) = predict_plan(press, model.plan()) - at_nominal;
  };
  vary([&](BedLaw& law) { law.onset += uncertainty.onset; });
  vary([&](BedLaw& law) { law.recovery *= 1.0 - uncertainty.recovery; });
  vary([&](BedLaw& law) { law.wall_friction *= 1.0 + uncertainty.wall_friction; });
  vary([&](BedLaw& law) { law.radial_ratio *= 1.0 + uncertainty.radial_ratio; });
  vary([&](BedLaw& law) { stretch_turn(law, 1.0 + uncertainty.turn_length); });
  MatrixXd covariance = changes * changes.transpose();
  if (uncertainty.packing.stress > 0.0) {
    auto const packing = packing_covariance(nominal, model.plan(), uncertainty.packing);
    covariance +=
        packing / static_cast<double>(uncertainty.n_packings) + apart_by_run(packing, model.plan());
  }
  covariance.diagonal() +=
      missed_by_emulator(model.plan(), at_nominal, fit).array().square().matrix();
  return covariance;
}

diagnosis::ErrorSources error_sources(PressModel const& model, std::vector<ChannelError> channels,
                                      BedFit const& fit, BedUncertainty const& uncertainty) {
  diagnosis::ErrorSources sources{.channels = std::move(channels)};
  for (auto& channel : sources.channels)
    if (!channel.model_share)
      channel.model_share = share_of(channel.channel, fit, sources.tolerances.model_share);
  sources.numerical.covariance = numerical_covariance(model, fit, uncertainty);
  return sources;
}

} // namespace coupling::reduced
