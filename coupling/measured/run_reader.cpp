#include "coupling/measured/run_reader.hpp"

#include "coupling/measured/clean_rows.hpp"
#include "coupling/measured/clocks.hpp"
#include "coupling/measured/curve_numbers.hpp"
#include "coupling/measured/lab_file.hpp"
#include "coupling/measured/row_words.hpp"
#include "coupling/measured/run_checks.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::measured {
namespace {

using Names = std::vector<std::string>;

/// The layout as it holds for one of two files: the other's time is none of its columns.
LabLayout layout_of(LabLayout layout, bool is_position) {
  auto const own = layout.columns.find("position_time");
  if (own != layout.columns.end()) {
    if (is_position)
      layout.columns["time"] = own->second;
    layout.columns.erase("position_time");
  }
  return layout;
}

/// A table of one file, with its rows in order and the wild ones left out.
LabTable clean_table(TableName const& name, std::string const& text, LabLayout const& layout,
                     Names needed, std::vector<Channel> const& channels) {
  if (!layout.interval)
    needed.insert(needed.begin(), "time");
  LabTable table = parse_lab_table(text, name.path, name.file, layout, needed);
  set_clock(table, layout.interval, name);
  order_rows(table, name);
  drop_spikes(table, channels, name);
  check_corrupt_share(table, name);
  return table;
}

/// Of the position's file only the gap counts, and of the run's own everything else.
LabTable joined_table(RunEntry const& entry, TableName const& name, std::string const& folder,
                      FileText const& text_of, MeasuredData const& data, double& clock_sd) {
  LabTable forces = clean_table(name, text_of(entry.run.file), layout_of(entry.layout, false),
                                {"upper_punch_force"}, data.channels);
  TableName const other{folder + entry.position_file, entry.position_file};
  LabTable positions = clean_table(other, text_of(entry.position_file),
                                   layout_of(entry.layout, true), {"punch_gap"}, data.channels);
  VALIDATE(
      !forces.series.contains("punch_gap"),
      fmt::format("{}: holds a punch_gap, and so does {} (one of them would be lost). Name one "
                  "file only?",
                  name.path, other.path));
  return joined_by_time(std::move(forces), positions, entry.clock, entry.run.press, data, name,
                        entry.position_file, clock_sd);
}

void take_series(Run& run, LabTable& table, MeasuredData const& data, std::string const& path) {
  for (auto& [channel, values] : table.series) {
    bool const is_held = std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
    bool const must_be = channel == "punch_gap" || channel == "upper_punch_force";
    VALIDATE(is_held || !must_be,
             fmt::format("{}: holds no value of {} (every row is a gap). Is it the right file?",
                         path, channel));
    VALIDATE(data.channel(channel) != nullptr,
             fmt::format("{}: column {} has no uncertainty (measured.json, \"channels\", does not "
                         "name it). Add {{\"unit\": ..., \"sd\": ...}}, or remove the column?",
                         path, channel));
    if (is_held)
      run.series[channel] = std::move(values);
    else
      table.decisions.push_back(
          {run.file, 0, fmt::format("column {} holds no value and is left out", channel)});
  }
  run.time = std::move(table.time);
  run.rows = std::move(table.rows);
}

void note_gaps(Run const& run, std::vector<Decision>& decisions) {
  for (auto const& [channel, values] : run.series) {
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!std::isfinite(values[k]))
        rows.push_back(run.rows[k]);
    if (!rows.empty())
      decisions.push_back({run.file, 0,
                           fmt::format("{} of {} readings of {} are missing and stay gaps: {}",
                                       rows.size(), values.size(), channel, rows_in_words(rows))});
  }
}

} // namespace

Run read_run_series(RunEntry const& entry, std::string const& folder, FileText const& text_of,
                    MeasuredData& data) {
  Run run = entry.run;
  TableName const name{folder + run.file, run.file};
  check_sample(data.sample, run.press, entry.where);
  run.clock_sd = entry.clock.sd;
  LabTable table = entry.position_file.empty()
                       ? clean_table(name, text_of(run.file), layout_of(entry.layout, false),
                                     {"punch_gap", "upper_punch_force"}, data.channels)
                       : joined_table(entry, name, folder, text_of, data, run.clock_sd);
  take_series(run, table, data, name.path);
  note_gaps(run, table.decisions);
  RunCheck const check{.data = data, .run = run, .table = table, .path = name.path};
  check_not_swapped(check);
  check_units(check);
  check_turning(check);
  if (auto const unchecked = check_protocol(check); !unchecked.empty())
    table.decisions.push_back({run.file, 0, unchecked});
  data.decisions.insert(data.decisions.end(), table.decisions.begin(), table.decisions.end());
  return run;
}

Run read_run_numbers(RunEntry const& entry, MeasuredData const& data) {
  check_sample(data.sample, entry.run.press, entry.where);
  check_numbers(data.sample, entry.run, entry.where);
  return entry.run;
}

} // namespace coupling::measured
