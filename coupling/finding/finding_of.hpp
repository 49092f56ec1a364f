#pragma once

#include "coupling/diagnosis/diagnose.hpp"
#include "coupling/diagnosis/gain.hpp"
#include "coupling/diagnosis/next_measurement.hpp"
#include "coupling/diagnosis/unexplained.hpp"
#include "coupling/finding/finding.hpp"

/// From what the statistics found, in Eigen's matrices and indices, to plain values with names.
namespace coupling::finding {

/// A gain with what it is the gain of.
struct ScoredGain {
  diagnosis::Gain gain;
  std::vector<std::string> causes; ///< that the extended model has
  int n_runs;                      ///< held out
};

/// Where rows were measured, for pictures. Empty where it is not known.
struct RowPlaces {
  Eigen::VectorXd time, gap; ///< [s], [m]; [n_rows] each
};

/// Everything beside the diagnosis itself; the references outlive the call only.
struct FindingSources {
  diagnosis::Model const& model;               ///< names and units
  diagnosis::Observations const& observations; ///< rows
  diagnosis::ErrorSources const& errors;       ///< as diagnose() had them
  diagnosis::DiagnosisSettings const& settings;
  std::optional<ScoredGain> gain = {}, placebo = {};
  std::vector<diagnosis::MeasurementAdvice> advice = {}; ///< the best first
  std::optional<diagnosis::Unexplained> unexplained = {};
  std::vector<std::string> decisions = {}; ///< of the reader of the measured data
  RowPlaces places = {};
  std::vector<RunCurve> held_out_curves = {}; ///< drawn behind those of the fitted runs
  Provenance provenance = {};
};

/// Names for indices, units for numbers, an order for causes:
/// - causes: the named, then by probability P(not none) p_j, those below 0.001 left out; sizes
///   with 95 % by profile likelihood in the most probable hypothesis that has the cause, or fitted
///   alone for a member of a group that the search has left out;
/// - a calibrated parameter far from its sheet is a cause, its size relative to the sheet, its 95 %
///   +- 1.96 sd of the calibration;
/// - a group of one takes the next probable causes in: the contract's group has two at least.
/// @throws dem::InvalidInput for places of another number of rows, or as the parts do
Finding finding_of(diagnosis::Diagnosis const& found, FindingSources const& sources);

/// The rows of a held-out run as curves, for FindingSources::held_out_curves.
/// @param phases  of each row
std::vector<RunCurve> curves_of(diagnosis::HeldOutRun const& run,
                                std::vector<std::string> const& phases, RowPlaces const& places);

/// SI unit of a channel or scalar of measured data, "1" for another name.
std::string unit_of_channel(std::string const& channel);

} // namespace coupling::finding
