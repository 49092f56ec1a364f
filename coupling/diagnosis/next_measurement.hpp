#pragma once

#include "coupling/diagnosis/identifiability.hpp"
#include "coupling/diagnosis/tolerances.hpp"

#include <string>

namespace coupling::diagnosis {

/// Where a row of a measurement is read.
struct ReadingPlace {
  std::string channel, unit;
  Phase phase = Phase::after;
  double gap = 0.0; ///< [m], between the punches; that of the turn for what is read afterwards
};

/// A measurement that could be made, as further rows: another gauge, a dwell, another speed or
/// height, a balance.
struct CandidateMeasurement {
  std::string name;
  double cost;                        ///< > 0, any unit that is the same for all
  std::vector<ReadingPlace> places{}; ///< of its rows, [n]
  Eigen::VectorXd baseline{}; ///< prediction of the fitted baseline, [n] [units of the rows]
  Eigen::MatrixXd
      calibrated{}; ///< change by one prior sd of each calibrated parameter, n x n_calibrated
  Eigen::MatrixXd effects{};    ///< change by one prior scale of each mechanism, n x n_mechanisms
  Eigen::MatrixXd covariance{}; ///< of its rows, all errors, n x n
  /// L^-1 times the covariance of the measured rows with its own, n_measured x n: the simulator
  /// errs alike in both, and what was measured tells how. Empty: they share no error.
  Eigen::MatrixXd shared{};
};

/// A cause that is still possible, refitted alone.
struct PossibleCause {
  int mechanism;
  Fit fit;
};

struct PredictedOutcome {
  int mechanism;
  Eigen::VectorXd value, sd; ///< [n_readings] [units of the readings]
};

struct MeasurementAdvice {
  std::string name;
  double cost;
  double before, after; ///< least Delta over the pairs of possible causes
  bool is_enough;       ///< after >= separable
  /// Of each channel the row in which two possible causes differ most, in standard deviations of
  /// that row: where to look first. (Delta counts all rows and what calibration absorbs.)
  std::vector<ReadingPlace> readings;
  std::vector<PredictedOutcome> outcomes; ///< of these readings, one a possible cause
};

/// The candidates, best first: those that separate all possible causes by the least Delta over
/// cost, then the others likewise. None may be enough: "not with these instruments".
/// The linear-Gaussian form of Box and Hill, Technometrics 9 (1967) 57; diagnosis note 2d.
/// @throws dem::InvalidInput for fewer than two causes, a cost that is not positive, places or
/// matrices of other sizes
std::vector<MeasurementAdvice>
next_measurements(Fit const& baseline, SignatureLibrary const& library,
                  std::vector<PossibleCause> const& possible,
                  std::vector<CandidateMeasurement> const& candidates);

} // namespace coupling::diagnosis
