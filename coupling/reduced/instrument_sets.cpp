#include "coupling/reduced/instrument_sets.hpp"

#include "coupling/reduced/measured_plan.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coupling::reduced {
namespace {

using diagnosis::Phase;

constexpr double opening_ratio = 25.0; // the laboratory's press opens at its rapid speed

/// Readings between two moments whose mean is a row.
struct Span {
  double from, to; ///< [s]
};

/// The parts of a pressing in which rows lie.
struct Phases {
  Span before, closing, dwell, opening, after;
};

/// Where the bed begins and ceases to bear, from a fine course of the pressing.
Phases phases_of(Press const& press, GapCourse const& course, std::string const& set) {
  constexpr int n = 400; // a moment each 0.3 % of the stroke
  auto const turning = turning_of(course);
  double const end = course.time.back();
  std::vector<double> times;
  for (int k = 0; k <= n; ++k)
    times.push_back(turning.closed * k / n);
  for (int k = 0; k <= n; ++k)
    if (double const t = turning.opens + (end - turning.opens) * k / n; t > times.back())
      times.push_back(t);
  auto const cycle = press_cycle(press.pressed, press.machine, course, times);
  double const least = Binning{}.contact_share *
                       std::ranges::max_element(cycle, {}, &ChainReading::load_cell)->load_cell;
  VALIDATE(least > 0.0,
           fmt::format("set {}: the bed does not bear at a gap of {:g} m (it is higher than the "
                       "powder). Is the end gap right?",
                       set, turning.gap));
  auto const bears = [&](ChainReading const& at) { return at.load_cell > least; };
  double const first = std::ranges::find_if(cycle, bears)->time;
  double const last = std::find_if(cycle.rbegin(), cycle.rend(), bears)->time;
  // A little before it bears: the readings in which the onset lies.
  double const begins = std::max(first - 0.05 * (turning.closed - first), 0.0);
  return {.before = {0.0, begins},
          .closing = {begins, turning.closed},
          .dwell = {turning.closed, turning.opens},
          .opening = {turning.opens, last},
          .after = {last, end}};
}

/// Collects the rows of one set.
class Collector {
public:
  Collector(Press const& press, InstrumentSet const& set, Instruments const& instruments)
      : press_(press), set_(set), instruments_(instruments) {}

  void add(std::string const& run, GapCourse const& course) {
    PlannedRun planned{.name = run, .course = course, .times = {}, .blocks = {}};
    auto const phases = phases_of(press_, course, set_.name);
    std::map<double, std::size_t> places;
    std::vector<std::vector<Span>> nodes;
    for (auto const& channel : set_.channels) {
      bool const is_upper = channel == "upper_punch_force";
      add_block(planned, channel, Phase::loading, {parts(phases.before, 1), loading(phases)},
                nodes);
      add_block(planned, channel, Phase::dwell, {parts(phases.dwell, Binning{}.n_dwell)}, nodes);
      // No press run tells how a compact hangs in the die: the other gauges end with the contact.
      add_block(planned, channel, Phase::unloading,
                {parts(phases.opening, Binning{}.n_unloading),
                 is_upper ? parts(phases.after, 1) : std::vector<Span>{}},
                nodes);
    }
    for (auto const& block : nodes)
      for (auto const& [early, late] : block)
        places.emplace(early, 0), places.emplace(late, 0);
    places.emplace(turning_of(course).closed, 0);
    for (auto& [t, place] : places) {
      place = planned.times.size();
      planned.times.push_back(t);
    }
    for (std::size_t b = 0; b < nodes.size(); ++b)
      for (auto const& [early, late] : nodes[b])
        planned.blocks[b].rows.push_back({{places.at(early), places.at(late)}});
    for (auto const& scalar : set_.scalars)
      add_scalar(planned, scalar);
    rows_.plan.runs.push_back(std::move(planned));
  }

  PlannedRows take() {
    for (auto const& channel : set_.channels)
      rows_.channels.push_back(
          channel == "wall_radial_pressure"
              ? diagnosis::ChannelError{.channel = channel,
                                        .sd = instruments_.pressure_sd,
                                        .sd_relative = instruments_.pressure_relative,
                                        .has_kink = true}
              : diagnosis::ChannelError{.channel = channel,
                                        .sd = instruments_.force_sd,
                                        .sd_relative = instruments_.force_relative,
                                        .has_kink = true});
    for (auto const& scalar : set_.scalars)
      rows_.channels.push_back(
          {.channel = scalar,
           .sd = scalar == "compact_height" ? instruments_.height_sd : instruments_.ejection_sd});
    auto const values = predict_plan(press_, rows_.plan);
    Eigen::Index row = 0;
    for (auto& block : rows_.blocks) {
      auto const n = block.coordinate.size();
      block.values = values.segment(row, n);
      row += n;
    }
    return std::move(rows_);
  }

private:
  std::vector<Span> loading(Phases const& phases) const {
    return parts(phases.closing, Binning{}.n_loading);
  }

  double n_readings(Span const& span) const {
    return std::floor((span.to - span.from) * instruments_.reading_rate);
  }

  /// Equal parts of what the logger reads, none without a reading.
  std::vector<Span> parts(Span const& whole, std::size_t most) const {
    auto const n = std::min(most, static_cast<std::size_t>(n_readings(whole)));
    std::vector<Span> all;
    double const step = (whole.to - whole.from) / static_cast<double>(n);
    for (std::size_t k = 0; k < n; ++k)
      all.push_back({whole.from + step * static_cast<double>(k),
                     whole.from + step * static_cast<double>(k + 1)});
    return all;
  }

  void add_block(PlannedRun& run, std::string const& channel, Phase phase,
                 std::vector<std::vector<Span>> const& spans,
                 std::vector<std::vector<Span>>& nodes) {
    std::vector<Span> rows;
    for (auto const& some : spans)
      rows.insert(rows.end(), some.begin(), some.end());
    if (rows.empty())
      return;
    auto const n = static_cast<Eigen::Index>(rows.size());
    diagnosis::ChannelBlock block{.run = run.name, .channel = channel, .phase = phase};
    block.coordinate = block.n_readings = Eigen::VectorXd(n);
    block.n_repeats = instruments_.n_repeats;
    auto const middle = [](Span const& span) { return 0.5 * (span.from + span.to); };
    double const start = middle(rows.front()), length = middle(rows.back()) - start;
    nodes.emplace_back();
    for (Eigen::Index k = 0; k < n; ++k) {
      auto const& span = rows[static_cast<std::size_t>(k)];
      block.coordinate[k] = length > 0.0 ? (middle(span) - start) / length : 0.0;
      block.n_readings[k] = std::max(n_readings(span), 1.0);
      // Readings spread evenly over a span have this standard deviation of their times.
      double const spread = (span.to - span.from) / std::sqrt(12.0);
      nodes.back().push_back({middle(span) - spread, middle(span) + spread});
    }
    rows_.blocks.push_back(std::move(block));
    run.blocks.push_back({.channel = channel, .phase = phase, .rows = {}});
  }

  void add_scalar(PlannedRun& run, std::string const& scalar) {
    rows_.blocks.push_back({.run = run.name,
                            .channel = scalar,
                            .phase = Phase::after,
                            .coordinate = Eigen::VectorXd::Zero(1),
                            .values = {},
                            .n_readings = {},
                            .n_repeats = instruments_.n_repeats});
    run.blocks.push_back({.channel = scalar, .phase = Phase::after, .rows = {{{0, 0}}}});
  }

  Press const& press_;
  InstrumentSet const& set_;
  Instruments const& instruments_;
  PlannedRows rows_;
};

} // namespace

std::vector<InstrumentSet> usual_instrument_sets(double speed, double gap) {
  std::vector<std::string> const upper = {"upper_punch_force"},
                                 gauges = {"upper_punch_force", "lower_punch_force",
                                           "wall_radial_pressure"},
                                 numbers = {"compact_height", "ejection_force"};
  SetPressing const first{speed, gap, 0.0}, fast{25.0 * speed, gap, 0.0};
  std::vector<SetPressing> const five = {
      first, fast, {speed, 1.05 * gap, 0.0}, {speed, gap, 60.0}, {5.0 * speed, 1.025 * gap, 0.0}};
  return {{"A", "upper force, one run", upper, {}, {first}},
          {"D", "all gauges, one run", gauges, numbers, {first}},
          {"E", "all gauges, two speeds", gauges, numbers, {first, fast}},
          {"F", "upper force and height, five runs", upper, {"compact_height"}, five},
          {"G", "all gauges, five runs", gauges, numbers, five}};
}

PlannedRows planned_rows(Press const& press, InstrumentSet const& set,
                         Instruments const& instruments, double fill_height) {
  Collector collector(press, set, instruments);
  double const opening = opening_ratio * set.pressings.front().speed;
  for (std::size_t k = 0; k < set.pressings.size(); ++k) {
    auto const& [speed, gap, dwell] = set.pressings[k];
    collector.add(fmt::format("run{}", k + 1),
                  press_course(fill_height, gap, speed, opening, dwell));
  }
  return collector.take();
}

} // namespace coupling::reduced
