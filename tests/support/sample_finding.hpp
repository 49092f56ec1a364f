#pragma once

#include "coupling/finding/finding.hpp"

#include <cmath>

/// A made-up finding that looks like one: for the tests of the diagnosis' files, and for looking at
/// its page. 25 kN on 9 g of powder; the frame gives 18 um/kN, and a held-out run goes to 33 kN.
namespace sample {

using namespace coupling::finding;

inline constexpr double frame = 18e-9; // [m/N]

/// A press cycle with 60 points down and 30 up.
/// @param given  [m/N], of the frame
inline double force_at(double gap, bool is_opening, double end, double given) {
  double low = 0.0, high = 1e5;
  for (int k = 0; k < 50; ++k) { // the bed and the frame in series
    double const force = 0.5 * (low + high), height = gap + given * force;
    double bed = 6.1e5 * std::pow(std::max(0.0, 1.0 - height / 11.3e-3), 2.4);
    if (is_opening)
      bed *= std::exp(-std::max(0.0, height - end) / 1.2e-4);
    (bed > force ? low : high) = force;
  }
  return low;
}

inline RunCurve curve(std::string run, std::string channel, double share, double end,
                      bool is_held_out) {
  RunCurve curve{.run = std::move(run),
                 .channel = std::move(channel),
                 .unit = "N",
                 .is_held_out = is_held_out};
  for (int k = 0; k < 90; ++k) {
    bool const is_opening = k >= 60;
    double const gap = is_opening ? end + (k - 59) * 1.5e-5 : 11.4e-3 + k * (end - 11.4e-3) / 59.0;
    double const true_end = end + frame * force_at(end, false, end, frame);
    double const noise = 14.0 * std::sin(12.9898 * k + share) * std::cos(4.1 * k);
    curve.phase.emplace_back(is_opening ? "unloading" : "loading");
    curve.time.push_back(2.2 * k);
    curve.gap.push_back(gap);
    curve.measured.push_back(share * force_at(gap, is_opening, true_end, frame) + noise);
    curve.calibrated.push_back(share * 0.82 * force_at(gap, is_opening, end, 0.0));
    curve.extended.push_back(share * force_at(gap, is_opening, true_end, 0.99 * frame));
    curve.sd.push_back(14.0 + 0.004 * curve.measured.back());
  }
  return curve;
}

inline std::vector<StatedError> tolerances() {
  std::string const note = "diagnosis note 2a (measured on hidden effects)";
  return {{"model_share", 0.003, "1", "sd of the simulator's own error over the prediction", note},
          {"phase_length", 0.4, "1", "length over which that error is alike, of a phase", note},
          {"kink_share", 0.004, "1", "sd at contact onset and loss over the largest prediction",
           note + ": 100 N at 25 kN"},
          {"upper_punch_force/sd", 12.0, "N", "standard uncertainty of one reading",
           "measured.json, channels"}};
}

inline MeasuredGain gain(std::string cause, double ratio, double difference) {
  return {.causes = {std::move(cause)},
          .channels = {{"upper_punch_force", "N", 912.0, 912.0 * ratio, ratio, ratio - 0.04,
                        ratio + 0.05, 0.95},
                       {"compact_height", "m", 4.1e-5, 4.1e-5 * ratio, ratio, not_known, not_known,
                        0.5},
                       {"all", "1", 8.4, 8.4 * ratio, ratio, ratio - 0.04, ratio + 0.05, 0.94}},
          .elpd_difference = difference,
          .elpd_error = 31.0,
          .n_runs = 3};
}

inline Finding named() {
  Finding finding{.verdict = "named",
                  .explained_share = 0.993,
                  .sentences = {"all that was found wrong goes with frame_compliance"},
                  .alarm = {.is_raised = true,
                            .level = 0.01,
                            .p_omnibus = 0.0005,
                            .p_targeted = 0.0005,
                            .chi_squared = 2210.0,
                            .expected = 178.0,
                            .expected_sd = 18.9,
                            .best_cause = "frame_compliance"}};
  finding.misfit = {
      {"upper_punch_force", "loading", -21.3, 2e-9, "negative", "measured falls against the model",
       "slope"},
      {"upper_punch_force", "unloading", 9.1, 3e-5, "positive", "measured is above the model",
       "level"},
      {"lower_punch_force", "loading", -17.8, 4e-8, "negative", "measured falls against the model",
       "slope"},
      {"lower_punch_force", "unloading", 1.1, 0.61, "positive", "no trend: it goes up and down",
       "level"},
      {"compact_height", "after", 2.6, 0.04, "positive", "measured is above the model", "level"}};
  finding.levels = {{"run1.csv", "upper_punch_force", -19.0, 1e-8},
                    {"run2.csv", "upper_punch_force", -20.2, 1e-8}};
  finding.causes = {
      {.name = "frame_compliance",
       .probability = 0.97,
       .log_evidence = 1012.4,
       .plausibility = "plausible: 0.9 times the most that a good laboratory meets",
       .parameters =
           {{.name = "size", .value = frame, .low = 17.1e-9, .high = 19.2e-9, .unit = "m/N"}},
       .is_named = true},
      {.name = "force_lag",
       .probability = 0.018,
       .log_evidence = 1004.1,
       .plausibility = "large: 2.1 times the most that a good laboratory meets",
       .parameters = {{.name = "size",
                       .value = 3.2,
                       .low = 2.1,
                       .high = 12.0,
                       .unit = "s",
                       .is_open_high = true}}},
      {.name = "die_size",
       .probability = 0.004,
       .log_evidence = 1001.0,
       .plausibility = "plausible: 0.5 times the most that a good laboratory meets",
       .parameters = {{.name = "size", .value = 4e-5, .low = 1e-5, .high = 7e-5, .unit = "m"}}}};
  finding.gain = gain("frame_compliance", 0.12, 341.0);
  finding.placebo = gain("force_lag", 0.71, 62.0);
  finding.detectable = {{"frame_compliance", 0.36e-9, "m/N"},
                        {"gap_offset", 6.2e-5, "m"},
                        {"force_gain", 0.015, "1"},
                        {"wall_friction", 0.018, "1"},
                        {"thermal_drift", 5.8e-9, "m/s"},
                        {"punch_tilt", std::numeric_limits<double>::infinity(), "m"}};
  finding.tolerances = tolerances();
  finding.calibrated = {{.name = "young_modulus",
                         .value = 1.95e9,
                         .sd = 1.2e7,
                         .sheet = 2e9,
                         .sheet_sd = 0.15,
                         .unit = "Pa",
                         .is_logarithmic = true},
                        {.name = "cohesion",
                         .value = 3.1e6,
                         .sd = 9e5,
                         .sheet = 3e6,
                         .sheet_sd = 9e5,
                         .unit = "J/m^3"}};
  finding.decisions = {"run1.csv:7: left out: no number in 'upper_punch_force'",
                       "run2.csv: 3 gaps stay empty (rows 120, 121, 300)"};
  for (auto const* channel : {"upper_punch_force", "lower_punch_force"}) {
    double const share = channel[0] == 'u' ? 1.0 : 0.86;
    finding.curves.push_back(curve("run1.csv", channel, share, 8.2e-3, false));
    finding.curves.push_back(curve("run2.csv", channel, share, 8.0e-3, false));
    finding.curves.push_back(curve("run3.csv", channel, share, 7.7e-3, true));
  }
  finding.seeds = {{"misfit references", "1"}};
  finding.provenance = {.case_file = "case.prm",
                        .data_folder = "press-12",
                        .version = "0.1",
                        .simulation = "runs/base"};
  return finding;
}

/// One of two, and what separates them.
inline Finding undecided() {
  Finding finding = named();
  finding.verdict = "undecided";
  for (auto& cause : finding.causes)
    cause.is_named = false;
  finding.causes[0].probability = 0.62;
  finding.causes[1].probability = 0.36;
  finding.group = {"frame_compliance", "force_lag"};
  finding.sentences = {"frame_compliance does the same to these data as force_lag"};
  finding.gain.reset();
  finding.placebo.reset();
  finding.measurements = {
      {.name = "hold at 25 kN for 60 s, fall of the upper force",
       .cost = 2.0,
       .before = 1.4,
       .after = 9.8,
       .is_enough = true,
       .readings = {{"upper_punch_force", "N", "dwell", 8e-3}},
       .outcomes = {{"frame_compliance", {12.0}, {9.0}}, {"force_lag", {310.0}, {28.0}}}},
      {.name = "gap gauge at the punch faces",
       .cost = 15.0,
       .before = 1.4,
       .after = 2.9,
       .is_enough = false,
       .readings = {{"gap_at_peak", "m", "after", 8e-3},
                    {"lower_punch_force", "N", "unloading", 8.2e-3}},
       .outcomes = {{"frame_compliance", {4.5e-4, 12e3}, {8e-6, 30.0}},
                    {"force_lag", {2e-5, 11e3}, {8e-6, 30.0}}}}};
  return finding;
}

inline Finding unknown() {
  Finding finding = named();
  finding.verdict = "unknown";
  finding.sentences = {"no known cause explains the misfit: the best, breakage, takes 41 % of it"};
  finding.causes.clear();
  finding.gain.reset();
  finding.placebo.reset();
  finding.unknown = Unknown{.channel = "upper_punch_force",
                            .phase = "loading",
                            .run = "run2.csv",
                            .run_share = 0.58,
                            .value_low = 6100.0,
                            .value_high = 9400.0,
                            .size = -412.0,
                            .unit = "N",
                            .inputs = {{"force", 0.81, 0.0005}, {"time", 0.12, 0.4}},
                            .nearest = "breakage",
                            .nearest_cosine = 0.41,
                            .forms = {{"bump", "force", 7700.0, 1900.0, -390.0, 0.83},
                                      {"power", "force", 2.0, not_known, 3e-7, 0.11}}};
  return finding;
}

inline Finding consistent() {
  Finding finding = named();
  finding.verdict = "consistent";
  finding.alarm.is_raised = false;
  finding.sentences = {"nothing wrong found beyond the stated errors"};
  finding.causes.clear();
  finding.gain.reset();
  finding.placebo.reset();
  for (auto& cell : finding.misfit)
    cell.size *= 0.05, cell.p = 1.0;
  for (auto& one : finding.curves)
    one.calibrated = one.extended, one.extended.clear();
  return finding;
}

} // namespace sample
