#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What a laboratory measured on a press, as plain values in SI units, and everything that was
/// decided while it was read.
namespace coupling::measured {

/// A value and its standard uncertainty, both in the same SI unit.
struct Uncertain {
  double value;
  double sd; ///< > 0
  bool operator==(Uncertain const&) const = default;
};

struct Sample {
  Uncertain mass;         ///< [kg], powder in the die
  Uncertain die_diameter; ///< [m]
  /// [kg/m^3], of the grains, with which a porosity was computed from mass and outer dimensions.
  std::optional<Uncertain> solid_density = {};
  bool operator==(Sample const&) const = default;
};

/// A measured quantity and how far a reading may be off: standard uncertainty of a reading y is
/// sqrt(sd^2 + (sd_relative y)^2).
struct Channel {
  std::string name; ///< punch_gap, upper_punch_force, ... (see channel_kinds)
  std::string unit; ///< SI: m, N, Pa
  double sd;        ///< [unit], > 0
  double sd_relative = 0.0;
  bool operator==(Channel const&) const = default;
};

/// commanded: speed times time, or a transducer on the frame; measured: at the punch faces.
enum class GapSource { commanded, measured };

/// A held-out run is never used for fitting or for naming, only for the gain.
enum class Role { fit, held_out };

/// What the press was told to do.
struct PressProtocol {
  double speed_down;           ///< [m/s], > 0, closing
  double speed_up;             ///< [m/s], > 0, opening
  double end_gap;              ///< [m], > 0, where the closing ends
  double fill_height;          ///< [m], > end_gap, height of the filled bed
  std::optional<double> dwell; ///< [s], time at the end gap
  bool operator==(PressProtocol const&) const = default;
};

/// One pressing. All series have as many values as `time`; NaN where nothing was read. A pressing
/// of which single numbers alone are known has neither.
struct Run {
  std::string file; ///< relative to the folder; names the run (that of numbers alone: its name)
  Role role;
  PressProtocol press;
  std::map<std::string, Uncertain> scalars = {}; ///< compact_height [m], compact_mass [kg], ...
  std::vector<double> time = {};                 ///< [s], increasing
  std::map<std::string, std::vector<double>> series = {}; ///< by channel [SI]
  std::vector<std::size_t> rows = {}; ///< line of the file that each value came from, from 1
  double clock_sd = 0.0; ///< [s], standard uncertainty of the gap's clock against the force's

  bool has_curve() const { return !time.empty(); }
  bool has(std::string const& channel) const { return series.contains(channel); }
  std::span<double const> channel(std::string const& name) const { return series.at(name); }
};

/// Something that the reader did, left out or could not know, for the report.
struct Decision {
  std::string file;
  std::size_t row = 0; ///< line of the file; 0 if it is about the whole file
  std::string what;
  bool operator==(Decision const&) const = default;
};

struct MeasuredData {
  Sample sample;
  std::vector<Channel> channels;
  GapSource gap_source;
  std::vector<Run> runs;
  std::vector<Decision> decisions = {};

  /// @return  the channel of that name, or nullptr
  Channel const* channel(std::string_view name) const;
  /// Whether no run has a curve.
  bool has_numbers_alone() const;
};

/// Runs of the same protocol, as groups of places in `runs`, in the order of their first; a run
/// that was not repeated is a group of its own.
std::vector<std::vector<std::size_t>> repeats(MeasuredData const& data);

/// `run1.csv:7: left out: ...`
std::string in_words(Decision const& decision);

} // namespace coupling::measured
