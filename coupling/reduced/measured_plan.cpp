#include "coupling/reduced/measured_plan.hpp"

#include "coupling/reduced/compact.hpp"
#include "coupling/reduced/measured_course.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace coupling::reduced {
namespace {

using diagnosis::Phase;
using measured::MeasuredData;
using measured::Run;

/// Places of a run's readings.
using Places = std::vector<std::size_t>;

/// A row: its readings' places.
struct Part {
  Phase phase;
  Places places;
  bool is_free = false; ///< the upper punch has left the compact
};

void append_parts(std::vector<Part>& parts, Phase phase, Places const& places, std::size_t most) {
  std::size_t const n = std::min(most, places.size());
  for (std::size_t k = 0; k < n; ++k) {
    auto const at = [&](std::size_t i) {
      return places.begin() + static_cast<std::ptrdiff_t>(i * places.size() / n);
    };
    parts.push_back({.phase = phase, .places = Places(at(k), at(k + 1))});
  }
}

/// As many parts of an opening, half by number and half by the fall of the force: at a pressing's
/// end a few readings see most of it.
void append_opening(std::vector<Part>& parts, Places const& places, std::span<double const> force,
                    std::size_t most) {
  std::vector<double> fallen; // so far, noise left out
  double least = places.empty() ? 0.0 : force[places.front()];
  for (std::size_t const k : places)
    fallen.push_back(least = std::isfinite(force[k]) ? std::min(least, force[k]) : least);
  double const fall = places.empty() ? 0.0 : fallen.front() - fallen.back();
  if (!(fall > 0.0))
    return append_parts(parts, Phase::unloading, places, most);
  std::size_t last = most;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double const gone = 0.5 * static_cast<double>(i) / static_cast<double>(places.size()) +
                        0.5 * (fallen.front() - fallen[i]) / fall;
    auto const place =
        std::min(static_cast<std::size_t>(gone * static_cast<double>(most)), most - 1);
    if (place != last)
      parts.push_back({.phase = Phase::unloading, .places = {}}), last = place;
    parts.back().places.push_back(places[i]);
  }
}

/// Medians of five readings; nan where none is a number.
std::vector<double> medians(std::span<double const> force) {
  std::vector<double> all(force.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < force.size(); ++k) {
    std::vector<double> near;
    for (std::size_t i = k < 2 ? 0 : k - 2; i < std::min(k + 3, force.size()); ++i)
      if (std::isfinite(force[i]))
        near.push_back(force[i]);
    if (near.empty())
      continue;
    auto const middle = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::ranges::nth_element(near, middle);
    all[k] = *middle;
  }
  return all;
}

/// Readings of the upper force in which the bed bears, first and last: it is above its lowest, so
/// that a cell with a false zero bears nothing, by a share of its range and what noise may do (the
/// lowest of a thousand medians lies 2 sd low, and the highest as high).
/// @param sd  of a reading [N]
std::pair<std::size_t, std::size_t> bearing(std::span<double const> force, double share,
                                            double sd) {
  auto const middle = medians(force);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (double const f : middle)
    if (std::isfinite(f))
      low = std::min(low, f), high = std::max(high, f);
  auto const bears = [&](std::size_t k) {
    return middle[k] > low + share * (high - low) + 4.0 * sd;
  };
  std::size_t first = 0, last = force.size() - 1;
  while (first < last && !bears(first))
    ++first;
  while (last > first && !bears(last))
    --last;
  return {first, last};
}

/// Rows of a run, by the upper force; other channels take the same readings, but none of a compact
/// that hangs in the die: no press run tells how it does.
std::vector<Part> parts_of(Run const& run, GapCourse const& course, double force_sd,
                           Binning const& binning) {
  auto const [first, last] =
      bearing(run.channel("upper_punch_force"), binning.contact_share, force_sd);
  auto const turning = turning_of(course);
  // A little before it bears: the readings in which the onset lies.
  double const lead = 0.05 * (turning.closed - run.time[first]);
  Places before, closing, held, opening, after;
  for (std::size_t k = 0; k < run.time.size(); ++k) {
    double const t = run.time[k];
    auto& place = t < run.time[first] - lead ? before
                  : t <= turning.closed      ? closing
                  : t <= turning.opens       ? held
                  : k <= last                ? opening
                                             : after;
    place.push_back(k);
  }
  std::vector<Part> parts;
  append_parts(parts, Phase::loading, before, before.size() < 5 ? 0 : 1);
  append_parts(parts, Phase::loading, closing, binning.n_loading);
  append_parts(parts, Phase::dwell, held, binning.n_dwell);
  append_opening(parts, opening, run.channel("upper_punch_force"), binning.n_unloading);
  append_parts(parts, Phase::unloading, after, after.size() < 5 ? 0 : 1);
  parts.back().is_free = after.size() >= 5;
  return parts;
}

/// Mean of some readings of a channel: value, time and its spread, number.
struct PartMean {
  double value = 0.0, time = 0.0, spread = 0.0;
  std::size_t n = 0;
};
PartMean mean_of(Run const& run, std::span<double const> series, Places const& places) {
  PartMean mean;
  for (std::size_t const k : places)
    if (std::isfinite(series[k]))
      mean.value += series[k], mean.time += run.time[k], ++mean.n;
  if (mean.n == 0)
    return mean;
  auto const n = static_cast<double>(mean.n);
  mean.value /= n, mean.time /= n;
  for (std::size_t const k : places)
    if (std::isfinite(series[k]))
      mean.spread += (run.time[k] - mean.time) * (run.time[k] - mean.time);
  mean.spread = std::sqrt(mean.spread / n);
  return mean;
}

/// Collects the rows of all runs.
class Collector {
public:
  Collector(MeasuredData const& data, Binning const& binning) : data_(&data), binning_(binning) {
    rows_.plan.gap_is_of_faces = data.gap_source == measured::GapSource::measured;
  }

  void add(Run const& run) {
    PlannedRun planned{
        .name = run.file, .course = measured_course(*data_, run), .times = {}, .blocks = {}};
    auto const parts =
        parts_of(run, planned.course, data_->channel("upper_punch_force")->sd, binning_);
    std::map<double, std::size_t> places;
    std::vector<std::vector<std::array<double, 2>>> moments;
    for (auto const* const channel :
         {"upper_punch_force", "lower_punch_force", "wall_radial_pressure"})
      if (run.has(channel))
        for (auto const phase : {Phase::loading, Phase::dwell, Phase::unloading})
          add_block(run, channel, phase, parts, planned, moments);
    for (auto const& block : moments)
      for (auto const& pair : block)
        for (double const t : pair)
          places.emplace(t, 0);
    places.emplace(turning_of(planned.course).closed, 0);
    for (auto& [t, place] : places)
      place = planned.times.size(), planned.times.push_back(t);
    for (std::size_t b = 0; b < moments.size(); ++b)
      for (auto const& [early, late] : moments[b])
        planned.blocks[b].rows.push_back({{places.at(early), places.at(late)}});
    add_scalars(run, planned);
    if (run.has("ejection_force"))
      rows_.left_out.push_back(
          fmt::format("{}: the course of the ejection force is not foretold; its largest value as "
                      "a scalar would be used",
                      run.file));
    rows_.plan.runs.push_back(std::move(planned));
  }

  void leave_out(Run const& run) {
    rows_.left_out.push_back(fmt::format(
        "{}: has no curve, so its numbers are not used beside runs that have one", run.file));
  }

  MeasuredRows take() {
    for (auto const& channel : used_) {
      auto const* const described = data_->channel(channel);
      rows_.channels.push_back({.channel = channel,
                                .sd = described->sd,
                                .sd_relative = described->sd_relative,
                                .has_kink = true});
    }
    return std::move(rows_);
  }

private:
  void add_block(Run const& run, std::string const& channel, Phase phase,
                 std::vector<Part> const& parts, PlannedRun& planned,
                 std::vector<std::vector<std::array<double, 2>>>& moments) {
    std::vector<PartMean> means;
    for (auto const& part : parts)
      if (part.phase == phase && (!part.is_free || channel == "upper_punch_force"))
        if (auto const mean = mean_of(run, run.channel(channel), part.places); mean.n > 0)
          means.push_back(mean);
    if (means.empty())
      return;
    auto const n = static_cast<Eigen::Index>(means.size());
    diagnosis::ChannelBlock block{.run = run.file, .channel = channel, .phase = phase};
    block.coordinate = block.values = block.n_readings = Eigen::VectorXd(n);
    double const start = means.front().time, length = means.back().time - start;
    moments.emplace_back();
    used_.insert(channel);
    for (Eigen::Index k = 0; k < n; ++k) {
      auto const& mean = means[static_cast<std::size_t>(k)];
      block.coordinate[k] = length > 0.0 ? (mean.time - start) / length : 0.0;
      block.values[k] = mean.value;
      moments.back().push_back({mean.time - mean.spread, mean.time + mean.spread});
      block.n_readings[k] = static_cast<double>(mean.n);
    }
    rows_.blocks.push_back(std::move(block));
    planned.blocks.push_back({.channel = channel, .phase = phase, .rows = {}});
  }

  /// Each is a channel of its own with one row.
  void add_scalars(Run const& run, PlannedRun& planned) {
    for (auto const& [name, number] : run.scalars) {
      if (!is_foretold(name)) {
        rows_.left_out.push_back(fmt::format("{}: {} is not foretold", run.file, name));
        continue;
      }
      rows_.blocks.push_back({.run = run.file,
                              .channel = name,
                              .phase = Phase::after,
                              .coordinate = Eigen::VectorXd::Zero(1),
                              .values = Eigen::VectorXd::Constant(1, number.value)});
      planned.blocks.push_back({.channel = name, .phase = Phase::after, .rows = {{{0, 0}}}});
      auto const known = std::ranges::find(rows_.channels, name, &diagnosis::ChannelError::channel);
      if (known == rows_.channels.end())
        rows_.channels.push_back({.channel = name, .sd = number.sd});
      else
        known->sd = std::max(known->sd, number.sd);
    }
  }

  MeasuredData const* data_;
  Binning binning_;
  MeasuredRows rows_;
  std::set<std::string> used_; ///< channels of curves
};

} // namespace

MeasuredRows measured_rows(MeasuredData const& data, measured::Role role, Binning const& binning) {
  Collector collector(data, binning);
  std::size_t n = 0;
  for (auto const& run : data.runs)
    if (run.role == role && run.has_curve())
      collector.add(run), ++n;
    else if (run.role == role)
      collector.leave_out(run);
  VALIDATE(n > 0, "measured data: no run with a curve has the role that is asked for");
  return collector.take();
}

} // namespace coupling::reduced
