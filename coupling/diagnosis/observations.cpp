#include "coupling/diagnosis/observations.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <set>
#include <tuple>

namespace coupling::diagnosis {
namespace {

void validate(ChannelBlock const& block) {
  auto const label = label_of(block);
  VALIDATE(block.values.size() > 0,
           fmt::format("{}: has no values. Was the channel recorded?", label));
  VALIDATE(block.coordinate.size() == block.values.size(),
           fmt::format("{}: has {} coordinates for {} values (each value has one). Were rows "
                       "dropped from one of them?",
                       label, block.coordinate.size(), block.values.size()));
  VALIDATE(block.values.allFinite() && block.coordinate.allFinite(),
           fmt::format("{}: holds a value that is no number. Should that row be left out?", label));
  for (Eigen::Index k = 0; k < block.coordinate.size(); ++k) {
    double const s = block.coordinate[k];
    VALIDATE(s >= 0.0 && s <= 1.0 && (k == 0 || s >= block.coordinate[k - 1]),
             fmt::format("{}: coordinate {} is {:g} (it goes from 0 to 1 and never back). Is the "
                         "phase cut where it ends?",
                         label, k + 1, s));
  }
  VALIDATE(
      block.n_readings.size() == 0 || (block.n_readings.size() == block.values.size() &&
                                       (block.n_readings.array() >= 1.0).all()),
      fmt::format("{}: numbers of readings are {} for {} values, or below 1. One for each row?",
                  label, block.n_readings.size(), block.values.size()));
  VALIDATE(block.n_repeats >= 1, fmt::format("{}: is the mean of {} repeats. How many were there?",
                                             label, block.n_repeats));
}

} // namespace

std::string_view name_of(Phase phase) {
  switch (phase) {
  case Phase::loading:
    return "loading";
  case Phase::dwell:
    return "dwell";
  case Phase::unloading:
    return "unloading";
  case Phase::after:
    return "after";
  }
  return "";
}

std::string label_of(ChannelBlock const& block) {
  return fmt::format("{}, {}, {}", block.run, block.channel, name_of(block.phase));
}

Observations::Observations(std::vector<ChannelBlock> blocks) : blocks_(std::move(blocks)) {
  VALIDATE(!blocks_.empty(), "diagnosis: has no measured data. Which runs are meant?");
  std::set<std::tuple<std::string, std::string, Phase>> seen;
  Eigen::Index n_rows = 0;
  for (auto const& block : blocks_) {
    validate(block);
    VALIDATE(seen.emplace(block.run, block.channel, block.phase).second,
             fmt::format("{}: is given twice. Is it another run?", label_of(block)));
    rows_.push_back({n_rows, block.values.size()});
    n_rows += block.values.size();
  }
  values_.resize(n_rows);
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    values_.segment(rows_[b].first, rows_[b].n) = blocks_[b].values;
}

} // namespace coupling::diagnosis
