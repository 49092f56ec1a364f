#pragma once

#include "coupling/diagnosis/misfit_tests.hpp"

namespace coupling::diagnosis {

/// Something that each row was measured at: phase coordinate, force, punch gap, ln of the speed,
/// time, mass.
struct RowInput {
  std::string name, unit;
  Eigen::VectorXd values; ///< [n_rows]
};

/// How much of the misfit goes with one input, whatever the form.
struct InputDependence {
  std::string input;
  double share; ///< of the misfit in the channel beyond a constant, 0 to 1
  double p;     ///< of so large a share when nothing is wrong
};

/// A form from a small library: a proposal, no cause.
struct FormCandidate {
  std::string form;  ///< "step", "bump", "power", "periodic", "linear"
  std::string input; ///< of what
  double place;      ///< of a step or bump [unit of the input]; exponent of a power; else NaN
  double width;      ///< of a bump, period of a periodic form [unit of the input]; else NaN
  double amplitude;  ///< [unit of the channel], of the form between 0 and 1, or a sine
  double share;      ///< of the misfit in the channel, 0 to 1
};

/// What can be said of a misfit that no known cause explains.
struct Unexplained {
  std::string channel; ///< where it lives
  Phase phase;
  std::string run;              ///< the one with the largest share of that channel's misfit
  double run_share;             ///< of squared standardised residuals
  double value_low, value_high; ///< shortest range of the prediction that holds 80 % of them [unit]
  double size;                  ///< largest residual of the channel, in its own unit
  std::vector<InputDependence> inputs; ///< the largest share first
  std::string nearest;                 ///< mechanism whose signature is most alike
  double nearest_cosine;               ///< with its sign, in the space that calibration leaves
  std::vector<FormCandidate> forms;    ///< the best of each form and input, the largest share first
};

/// Describes the residual of the calibrated baseline. All forms are fitted in the whitened space
/// orthogonal to the calibrated parameters, so what calibration absorbs is no form: a share is
///   (|projection of z on P L^-1 B|^2 - n_columns) / (|z|^2 - expected),  held to 0 .. 1.
/// Dependence is a cubic polynomial in the input (of lower degree where the input has fewer
/// values); unlike a Gaussian process it has no scale to be tuned, and it answers which input, not
/// which curve. Nothing here may be used outside the data. Source: diagnosis note 2e; forms after
/// Kaheman et al., arXiv:1909.08574.
/// @param inputs  at least one
/// @param predicted  f of the baseline, for the ranges and the power forms, [n_rows]
/// @throws dem::InvalidInput for an input of another length or with values that are no numbers
Unexplained describe_unexplained(Observations const& observations, Comparison const& comparison,
                                 SignatureLibrary const& library, MisfitTests const& tests,
                                 Eigen::VectorXd const& predicted,
                                 std::vector<RowInput> const& inputs,
                                 MisfitSettings const& settings = {});

} // namespace coupling::diagnosis
