#include "coupling/measured/clean_rows.hpp"

#include "coupling/measured/limits.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::measured {
namespace {

/// Both gaps, or the same number.
bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool same_row(LabTable const& table, std::size_t i, std::size_t k) {
  return std::ranges::all_of(table.series,
                             [&](auto const& s) { return same(s.second[i], s.second[k]); });
}

/// Rows k, k+1, ... of one tick get times evenly up to the next tick.
void spread_ticks(LabTable& table) {
  std::vector<double> const ticks = table.time;
  double length = 0.0;
  for (std::size_t first = 0; first < ticks.size();) {
    std::size_t end = first + 1;
    while (end < ticks.size() && ticks[end] == ticks[first])
      ++end;
    // The last tick is taken to be as long as the one before.
    if (end < ticks.size())
      length = ticks[end] - ticks[first];
    for (std::size_t k = first; k < end; ++k)
      table.time[k] =
          ticks[first] + length * static_cast<double>(k - first) / static_cast<double>(end - first);
    first = end;
  }
}

/// Range of all but the lowest and highest hundredth, which may be wild.
double quiet_range(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.size() < 5)
    return 0.0;
  std::ranges::sort(values);
  std::size_t const tail = std::max<std::size_t>(1, values.size() / 100);
  return values[values.size() - 1 - tail] - values[tail];
}

/// By how much reading k left the line between its neighbours; 0 if that is no spike.
double spike(LabTable const& table, std::vector<double> const& y, std::size_t k,
             Channel const& channel, double range) {
  auto const& t = table.time;
  double const share = (t[k] - t[k - 1]) / (t[k + 1] - t[k - 1]);
  double const line = y[k - 1] + share * (y[k + 1] - y[k - 1]);
  double const steps = std::max({std::abs(y[k + 1] - y[k - 1]), std::abs(y[k - 1] - y[k - 2]),
                                 std::abs(y[k + 2] - y[k + 1])});
  double const sd = std::hypot(channel.sd, channel.sd_relative * line);
  double const off = std::abs(y[k] - line);
  bool const is_spike = off > limits::spike_steps * steps && off > limits::spike_sds * sd &&
                        off > limits::spike_share * range;
  return is_spike ? off : 0.0; // a gap among the neighbours makes `off` NaN, which is no spike
}

/// @return  whether there were any
bool drop_clear_spikes(LabTable& table, std::span<Channel const> channels, TableName const& name) {
  std::vector<bool> is_kept(table.size(), true);
  std::size_t turn = table.size();
  if (auto const gap = table.series.find("punch_gap"); gap != table.series.end())
    for (std::size_t k = 0; k < table.size(); ++k)
      if (std::isfinite(gap->second[k]) &&
          (turn == table.size() || gap->second[k] < gap->second[turn]))
        turn = k;
  for (auto const& channel : channels) {
    auto const found = table.series.find(channel.name);
    if (found == table.series.end())
      continue;
    auto const& y = found->second;
    double const range = quiet_range(y);
    for (std::size_t k = 2; k + 2 < table.size(); ++k) {
      double const off = spike(table, y, k, channel, range);
      bool const is_turn = k == turn && channel.name != "punch_gap";
      if (off == 0.0 || is_turn || !is_kept[k])
        continue;
      is_kept[k] = false;
      ++table.n_corrupt;
      table.decisions.push_back(
          {name.file, table.rows[k],
           fmt::format(
               "left out: {} = {:.6g} {} leaves the line between its neighbours, {:.6g} and "
               "{:.6g}, for one reading (an error of transmission)",
               channel.name, y[k], channel.unit, y[k - 1], y[k + 1])});
    }
  }
  keep_rows(table, is_kept);
  return std::ranges::find(is_kept, false) != is_kept.end();
}

} // namespace

void keep_rows(LabTable& table, std::vector<bool> const& is_kept) {
  auto const pick = [&](auto& values) {
    std::size_t n = 0;
    for (std::size_t k = 0; k < is_kept.size(); ++k)
      if (is_kept[k])
        values[n++] = values[k];
    values.resize(n);
  };
  for (auto& [channel, values] : table.series)
    pick(values);
  pick(table.time);
  pick(table.rows);
}

void set_clock(LabTable& table, std::optional<double> interval, TableName const& name) {
  auto const& t = table.time;
  bool const stands =
      t.empty() || (t.size() > 1 && std::ranges::all_of(t, [&](double v) { return v == t[0]; }));
  if (!interval) {
    VALIDATE(!stands, fmt::format("{}:{}: the clock stands still at {} s (every row has the same "
                                  "time). Give the time between rows in measured.json, "
                                  "\"clock\": {{\"interval\": \"0.1 s\"}}?",
                                  name.path, table.rows.front(), t.empty() ? 0.0 : t[0]));
    return;
  }
  VALIDATE(stands, fmt::format("{}:{}: has a running clock (clock/interval = {} s in measured.json "
                               "says that it has none). Remove the interval?",
                               name.path, table.rows.front(), *interval));
  table.time.resize(table.size());
  for (std::size_t k = 0; k < table.size(); ++k)
    table.time[k] = static_cast<double>(k) * *interval;
  table.decisions.push_back(
      {name.file, 0, fmt::format("has no clock: rows are {} s apart, as stated", *interval)});
}

void order_rows(LabTable& table, TableName const& name) {
  auto const& t = table.time;
  std::vector<bool> is_kept(table.size(), true);
  std::vector<std::size_t> contradicting;
  for (std::size_t k = 1; k < table.size(); ++k) {
    VALIDATE(t[k] >= t[k - 1],
             fmt::format("{}:{}: time = {} s is before the {} s of row {} (time goes backwards). "
                         "Are two records joined, or was the clock reset?",
                         name.path, table.rows[k], t[k], t[k - 1], table.rows[k - 1]));
    if (t[k] != t[k - 1])
      continue;
    if (!same_row(table, k, k - 1)) {
      contradicting.push_back(k);
      continue;
    }
    is_kept[k] = false;
    table.decisions.push_back(
        {name.file, table.rows[k], fmt::format("left out: repeats row {}", table.rows[k - 1])});
  }
  double const few = std::max(1.0, limits::corrupt_share * static_cast<double>(table.size()));
  bool const is_coarse = static_cast<double>(contradicting.size()) > few;
  for (std::size_t const k : contradicting) {
    if (is_coarse)
      break;
    is_kept[k] = false;
    ++table.n_corrupt;
    table.decisions.push_back({name.file, table.rows[k],
                               fmt::format("left out: contradicts row {} at the same time, {} s",
                                           table.rows[k - 1], t[k])});
  }
  keep_rows(table, is_kept);
  if (!is_coarse)
    return;
  spread_ticks(table);
  table.decisions.push_back(
      {name.file, 0,
       fmt::format("the clock is coarse: {} rows share a tick with the row before (the first: row "
                   "{}); rows of a tick are spread evenly over it",
                   contradicting.size(), table.rows[contradicting.front()])});
}

void drop_spikes(LabTable& table, std::span<Channel const> channels, TableName const& name) {
  // A large spike hides a smaller one beside it.
  while (drop_clear_spikes(table, channels, name)) {
  }
}

void check_corrupt_share(LabTable const& table, TableName const& name) {
  double const all = static_cast<double>(table.size() + table.n_corrupt);
  bool const are_few =
      table.n_corrupt <= 1 || static_cast<double>(table.n_corrupt) <= limits::corrupt_share * all;
  if (are_few)
    return;
  auto const last = std::ranges::find_if(table.decisions.rbegin(), table.decisions.rend(),
                                         [](auto const& decision) { return decision.row > 0; });
  throw dem::InvalidInput(fmt::format("{}: {} of {} rows are corrupt (at most {:.0f} % may be; the "
                                      "last: row {}, {}). Is the record "
                                      "damaged?",
                                      name.path, table.n_corrupt, all, 100 * limits::corrupt_share,
                                      last->row, last->what));
}

} // namespace coupling::measured
