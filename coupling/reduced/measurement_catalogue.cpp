#include "coupling/reduced/measurement_catalogue.hpp"

#include "coupling/measured/channel_kinds.hpp"
#include "coupling/reduced/compact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coupling::reduced {
namespace {

using diagnosis::CandidateMeasurement;
using diagnosis::ChannelError;
using diagnosis::Phase;
using measured::PressProtocol;

constexpr std::size_t n_stroke_rows = 12, n_dwell_rows = 6;
constexpr double readings_a_row = 20.0;
constexpr double minute = 60.0;

/// A measurement in words and as what is pressed and read.
struct Proposal {
  std::string name;
  double cost; ///< min
  PressProtocol press;
  std::vector<std::string> channels; ///< curves
  std::string scalar;                ///< or one number
  std::string unit;                  ///< of that
  double sd;                         ///< of that
};

/// Rows of one channel between two moments, a node each.
void add_rows(PlannedRun& run, std::vector<diagnosis::ChannelBlock>& blocks,
              std::string const& channel, Phase phase, double from, double to, std::size_t n) {
  PlannedBlock planned{.channel = channel, .phase = phase, .rows = {}};
  auto const size = static_cast<Eigen::Index>(n);
  diagnosis::ChannelBlock block{.run = run.name, .channel = channel, .phase = phase};
  block.coordinate = Eigen::VectorXd::LinSpaced(size, 0.0, 1.0);
  block.values = Eigen::VectorXd::Zero(size);
  if (phase != Phase::after)
    block.n_readings = Eigen::VectorXd::Constant(size, readings_a_row);
  for (std::size_t k = 0; k < n; ++k) {
    double const t = from + (to - from) * (static_cast<double>(k) + 0.5) / static_cast<double>(n);
    auto at = std::ranges::find(run.times, t);
    if (at == run.times.end())
      at = run.times.insert(run.times.end(), t);
    auto const place = static_cast<std::size_t>(at - run.times.begin());
    planned.rows.push_back({{place, place}});
  }
  run.blocks.push_back(std::move(planned));
  blocks.push_back(std::move(block));
}

/// A pressing with the rows of a proposal.
struct Pressing {
  PlannedRun run;
  std::vector<diagnosis::ChannelBlock> blocks;
};

Pressing pressing_of(Proposal const& proposal) {
  auto const& press = proposal.press;
  Pressing pressing{
      .run = {.name = proposal.name,
              .course = press_course(press.fill_height, press.end_gap, press.speed_down,
                                     press.speed_up, press.dwell.value_or(0.0)),
              .times = {},
              .blocks = {}},
      .blocks = {}};
  auto const turning = turning_of(pressing.run.course);
  // Where forces are: the last fifth of the stroke.
  double const reach = 0.2 * (press.fill_height - press.end_gap);
  double const begins = turning.closed - reach / press.speed_down;
  double const ends = turning.opens + reach / press.speed_up;
  for (auto const& channel : proposal.channels) {
    auto const add = [&](Phase phase, double from, double to, std::size_t n) {
      add_rows(pressing.run, pressing.blocks, channel, phase, from, to, n);
    };
    add(Phase::loading, begins, turning.closed, n_stroke_rows);
    if (turning.opens > turning.closed)
      add(Phase::dwell, turning.closed, turning.opens, n_dwell_rows);
    add(Phase::unloading, turning.opens, ends, n_stroke_rows);
  }
  if (!proposal.scalar.empty())
    add_rows(pressing.run, pressing.blocks, proposal.scalar, Phase::after, turning.closed,
             turning.closed, 1);
  if (std::ranges::find(pressing.run.times, turning.closed) == pressing.run.times.end())
    pressing.run.times.push_back(turning.closed);
  return pressing;
}

/// Times of a run sorted, its rows following them.
void sort_times(PlannedRun& run) {
  auto sorted = run.times;
  std::ranges::sort(sorted);
  for (auto& block : run.blocks)
    for (auto& row : block.rows)
      for (auto& place : row.places)
        place = static_cast<std::size_t>(std::ranges::lower_bound(sorted, run.times[place]) -
                                         sorted.begin());
  run.times = std::move(sorted);
}

std::vector<Proposal> proposals(measured::MeasuredData const& data) {
  auto const run = std::ranges::find(data.runs, measured::Role::fit, &measured::Run::role);
  PressProtocol const base = run->press;
  auto const has = [&](std::string const& name) {
    return std::ranges::any_of(data.runs, [&](auto const& r) {
      return r.role == measured::Role::fit && (r.has(name) || r.scalars.contains(name));
    });
  };
  auto const with = [&](auto change) {
    PressProtocol press = base;
    change(press);
    return press;
  };
  std::vector<std::string> gauges;
  for (auto const* const channel :
       {"upper_punch_force", "lower_punch_force", "wall_radial_pressure"})
    if (has(channel))
      gauges.emplace_back(channel);
  std::vector<Proposal> all;
  auto const gauge = [&](char const* name, char const* channel, double cost) {
    if (!has(channel))
      all.push_back({name, cost, base, {channel}, "", "", 0.0});
  };
  auto const number = [&](char const* name, char const* scalar, char const* unit, double cost,
                          double sd) {
    if (!has(scalar))
      all.push_back({name, cost, base, {}, scalar, unit, sd});
  };
  gauge("force on the lower punch", "lower_punch_force", 10.0);
  gauge("radial pressure on the die", "wall_radial_pressure", 20.0);
  number("height of the compact, by caliper", "compact_height", "m", 2.0, 20e-6);
  number("mass of the compact, by balance", "compact_mass", "kg", 2.0, 5e-6);
  number("diameter of the die, by bore gauge", "compact_diameter", "m", 3.0, 5e-6);
  number("ejection force", "ejection_force", "N", 5.0, 20.0);
  number("gap between the punches at the largest force, by gauge", "gap_at_peak", "m", 15.0, 5e-6);
  number("load cell under a dead weight of 10 kN", "dead_weight", "N", 15.0, 10.0);
  auto const pressing = [&](char const* name, double cost, auto change) {
    all.push_back({name, cost, with(change), gauges, "", "", 0.0});
  };
  pressing("a dwell of 60 s at the end gap", 3.0, [](auto& p) { p.dwell = 60.0; });
  pressing("a dwell of 600 s at the end gap", 12.0, [](auto& p) { p.dwell = 600.0; });
  pressing("a run at 25 times the speed", 2.0, [](auto& p) { p.speed_down *= 25.0; });
  pressing("a run at a fifth of the speed",
           5.0 * (base.fill_height - base.end_gap) / base.speed_down / minute,
           [](auto& p) { p.speed_down *= 0.2; });
  pressing("a run to an end gap 5 % larger", 3.0, [](auto& p) { p.end_gap *= 1.05; });
  return all;
}

/// The stated error of a channel, or a usual one.
ChannelError error_of(std::string const& channel, std::vector<ChannelError> const& stated) {
  auto const find = [&](std::string_view name) {
    return std::ranges::find(stated, name, &ChannelError::channel);
  };
  if (auto const own = find(channel); own != stated.end())
    return *own;
  if (channel == "wall_radial_pressure")
    return {.channel = channel, .sd = 0.1e6, .sd_relative = 0.002, .has_kink = true};
  auto like_upper = *find("upper_punch_force");
  like_upper.channel = channel;
  return like_upper;
}

/// Where the rows of a pressing are read.
std::vector<diagnosis::ReadingPlace> places_of(PlannedRun const& run, Proposal const& proposal) {
  std::vector<diagnosis::ReadingPlace> all;
  for (auto const& block : run.blocks)
    for (auto const& row : block.rows) {
      auto const* const kind = measured::find_kind(measured::channel_kinds(), block.channel);
      bool const is_scalar = block.phase == Phase::after;
      all.push_back(
          {.channel = block.channel,
           .unit = is_scalar || !kind ? proposal.unit : std::string(describe(kind->physical).si),
           .phase = block.phase,
           .gap =
               is_scalar ? turning_of(run.course).gap : run.course.at(run.times[row.places[0]])});
    }
  return all;
}

/// Errors of a pressing beside those of the measured rows.
/// @param model  of all these rows
diagnosis::ErrorSources errors_with(Proposal const& proposal, PressModel const& model,
                                    SimulatedPress const& simulated,
                                    std::vector<ChannelError> channels) {
  auto const stated = channels;
  for (auto const& channel : proposal.channels)
    if (std::ranges::find(stated, channel, &ChannelError::channel) == stated.end())
      channels.push_back(error_of(channel, stated));
  if (!proposal.scalar.empty())
    channels.push_back({.channel = proposal.scalar, .sd = proposal.sd});
  // A dead weight asks nothing of the simulation.
  for (auto& channel : channels)
    if (channel.channel == "dead_weight")
      channel.model_share = 0.0;
  return error_sources(model, std::move(channels), simulated.fit, uncertainty_of(simulated));
}

/// Covariances of a pressing's rows: with themselves, and with the measured ones.
void add_covariances(Proposal const& proposal, Pressing const& pressing, PressModel const& of,
                     SimulatedPress const& simulated, Measured const& measured,
                     CandidateMeasurement& result) {
  auto plan = of.plan();
  plan.runs.push_back(pressing.run);
  auto const model = of.with_plan(plan);
  auto blocks = measured.rows.blocks;
  blocks.insert(blocks.end(), pressing.blocks.begin(), pressing.blocks.end());
  auto const all = error_model(diagnosis::Observations(blocks), model,
                               errors_with(proposal, model, simulated, measured.rows.channels),
                               measured.at.at, measured.at.active)
                       .covariance;
  auto const n = result.baseline.size();
  result.covariance = all.bottomRightCorner(n, n);
  result.shared = measured.whitener.whiten(all.topRightCorner(all.rows() - n, n));
}

CandidateMeasurement candidate(Proposal const& proposal, PressModel const& of,
                               SimulatedPress const& simulated, Measured const& measured,
                               diagnosis::Parameters const& at) {
  auto pressing = pressing_of(proposal);
  sort_times(pressing.run);
  auto const model =
      of.with_plan({.runs = {pressing.run}, .gap_is_of_faces = of.plan().gap_is_of_faces});
  CandidateMeasurement result{
      .name = proposal.name, .cost = proposal.cost, .places = places_of(pressing.run, proposal)};
  result.baseline = model.predict(at);
  auto const n = result.baseline.size();
  // Slopes as finite differences over a tenth of a prior size, where laws are nearly straight.
  constexpr double part = 0.1;
  auto const& calibrated = model.calibrated();
  result.calibrated.resize(n, static_cast<Eigen::Index>(calibrated.size()));
  for (std::size_t k = 0; k < calibrated.size(); ++k) {
    auto moved = at;
    auto const place = static_cast<Eigen::Index>(k);
    moved.calibrated[place] *= std::exp(part * calibrated[k].sd);
    result.calibrated.col(place) = (model.predict(moved) - result.baseline) / part;
  }
  auto const& mechanisms = model.mechanisms();
  result.effects.resize(n, static_cast<Eigen::Index>(mechanisms.size()));
  for (std::size_t j = 0; j < mechanisms.size(); ++j) {
    auto moved = at;
    auto const place = static_cast<Eigen::Index>(j);
    moved.sizes[place] += part * mechanisms[j].scale;
    result.effects.col(place) = (model.predict(moved) - result.baseline) / part;
  }
  add_covariances(proposal, pressing, of, simulated, measured, result);
  return result;
}

} // namespace

std::vector<CandidateMeasurement> measurement_catalogue(PressModel const& model,
                                                        SimulatedPress const& simulated,
                                                        Measured const& measured,
                                                        diagnosis::Parameters const& baseline) {
  std::vector<CandidateMeasurement> all;
  for (auto const& proposal : proposals(measured.data))
    all.push_back(candidate(proposal, model, simulated, measured, baseline));
  return all;
}

} // namespace coupling::reduced
