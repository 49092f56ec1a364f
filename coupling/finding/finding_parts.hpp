#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The parts of a finding: plain values, SI units where no other is named.
namespace coupling::finding {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Whether anything is wrong at all. T1 asks for any departure, T2 for one that a cause would make.
struct Alarm {
  bool is_raised = false;
  double level = not_known;       ///< probability of an alarm when nothing is wrong
  double p_omnibus = not_known;   ///< of T1
  double p_targeted = not_known;  ///< of T2
  double chi_squared = not_known; ///< T1
  double expected = not_known;    ///< of T1 when nothing is wrong
  double expected_sd = not_known; ///< standard deviation of that
  std::string best_cause = {};    ///< the one that T2 points at; empty without causes
};

/// One channel in one phase, over all runs.
struct MisfitCell {
  std::string channel, phase;
  double size;       ///< [1], standard uncertainties; positive: measured is above the simulation
  double p;          ///< after Holm
  std::string sign;  ///< "above", "below"
  std::string shape; ///< "measured is above the model, more and more"
  std::string test;  ///< the one with that p
};

/// The mean of one channel in one run.
struct RunLevel {
  std::string run, channel;
  double size, p; ///< [1], standard uncertainties; after Holm
};

/// A number of a cause: first its size, then the parameters of its law.
struct CauseParameter {
  std::string name;
  double value, low, high; ///< [unit]; 95 %
  std::string unit;
  bool is_open_low = false, is_open_high = false; ///< the data do not end the interval there
};

struct FoundCause {
  std::string name;
  double probability;       ///< [1]
  double log_evidence;      ///< ln of the evidence over that of "nothing is wrong"; NaN: not fitted
  std::string plausibility; ///< of its size, in words
  std::vector<CauseParameter> parameters = {};
  bool is_named = false;      ///< the verdict claims it
  bool is_calibrated = false; ///< a calibrated parameter that is far from its sheet

  double size() const { return parameters.empty() ? not_known : parameters.front().value; }
};

/// What one cause foretells of a measurement, in the order of its readings.
struct Foretold {
  std::string cause;
  std::vector<double> value, sd; ///< [units of the readings]
};

/// Where to look in a measurement.
struct Reading {
  std::string channel, unit, phase;
  double gap; ///< [m]
};

struct Measurement {
  std::string name;
  double cost;          ///< minutes, or what the catalogue counts in
  double before, after; ///< [1], separation of the nearest two causes, standard uncertainties
  bool is_enough;       ///< that all causes are told apart
  std::vector<Reading> readings = {}; ///< one a channel, where the causes differ most
  std::vector<Foretold> outcomes = {};
};

/// One channel over all held-out runs; "all": every row over its standard deviation.
struct ChannelGained {
  std::string channel, unit;
  double before, after;    ///< [unit], r.m.s. errors
  double ratio, low, high; ///< [1], after over before; 95 %, NaN with fewer than three runs
  double coverage;         ///< [1], share of rows inside the 95 % band, after
};

struct MeasuredGain {
  std::vector<std::string> causes = {}; ///< what the extended model has
  std::vector<ChannelGained> channels = {};
  double elpd_difference = not_known; ///< sum of ln densities, extended minus calibrated
  double elpd_error = not_known;      ///< its standard error
  int n_runs = 0;
};

/// The smallest size that these data would have shown.
struct DetectableSize {
  std::string cause;
  double size; ///< [unit], infinite if they do not see it
  std::string unit;
};

/// Something that was assumed about errors.
struct StatedError {
  std::string name;
  double value;
  std::string unit, meaning, source;
};

/// Something that the misfit depends on, and how much of it.
struct DependsOn {
  std::string input;
  double share, p; ///< [1]
};

/// A form that the misfit has: a proposal, no cause.
struct Form {
  std::string form, input;
  double place, width, amplitude, share; ///< NaN where the form has none
};

/// What can be said of a misfit that no known cause explains.
struct Unknown {
  std::string channel, phase, run;
  double run_share;             ///< [1], of the misfit that is in that run
  double value_low, value_high; ///< [unit of the channel], where most of it is
  double size;                  ///< [unit of the channel], the largest departure
  std::string unit;
  std::vector<DependsOn> inputs = {};
  std::string nearest; ///< cause that looks most alike; empty without causes
  double nearest_cosine;
  std::vector<Form> forms = {};
};

struct CalibratedValue {
  std::string name;
  double value, sd;       ///< [unit], as these data have it
  double sheet, sheet_sd; ///< [unit], as the material sheet has it; sd of its logarithm if so said
  std::string unit;
  bool is_logarithmic = false;
};

/// One entry that the extended case has otherwise than the user's.
struct ChangedEntry {
  std::string path, before, after; ///< values as the resolved case writes them; before: "" if new
  std::string because;             ///< cause, size, 95 % interval; or calibrated value and sd
};

/// One channel of one run in the order of time.
struct RunCurve {
  std::string run, channel, unit;
  bool is_held_out = false;
  std::vector<std::string> phase = {};
  std::vector<double> time = {}, gap = {}; ///< [s], [m]; empty where they are not known
  std::vector<double> measured = {};
  std::vector<double> calibrated = {}; ///< the simulation with calibrated parameters alone
  std::vector<double> extended = {};   ///< with the causes; empty if there are none
  std::vector<double> sd = {};         ///< of the error model, in all
};

struct Seed {
  std::string purpose;
  std::string value;
};

struct Provenance {
  std::string case_file, data_folder, version;
  std::string simulation; ///< where the simulation that was used lies
  std::string made = {};  ///< date; empty: files that do not change from run to run
};

} // namespace coupling::finding
