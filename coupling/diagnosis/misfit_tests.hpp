#pragma once

#include "coupling/diagnosis/reference.hpp"
#include "coupling/diagnosis/signatures.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace coupling::diagnosis {

struct MisfitSettings {
  double level = 0.01;    ///< alpha: probability of an alarm when nothing is wrong
  int n_draws = 1999;     ///< of the references, >= 400; with 999 a level of 0.5 % is 0.5 +- 0.2 %
  std::uint64_t seed = 1; ///< of those draws
};

/// One channel in one phase, over all runs.
struct CellMisfit {
  std::string channel;
  Phase phase;
  double size;       ///< the largest contrast, in standard uncertainties; measured - predicted
  double p_holm;     ///< smallest of its tests, after Holm over all tests of the map
  std::string test;  ///< the one with that p: "sum of squares", "runs", "Ljung-Box", "level", ...
  std::string shape; ///< "measured is above the model, more and more", ...
};

/// The mean of one channel in one run.
struct RunOffset {
  std::string run, channel;
  double size;   ///< in standard uncertainties
  double p_holm; ///< of the same family as the cells' tests
};

struct MisfitTests {
  double omnibus, p_omnibus;     ///< T1 = |r|^2 of the rows
  double expected, expected_sd;  ///< of T1 when nothing is wrong
  double targeted, p_targeted;   ///< T2 = the largest score of a mechanism
  int best_mechanism;            ///< the one with that score; -1 without mechanisms
  bool is_alarm;                 ///< p_omnibus < level / 2 or p_targeted < level / 2
  std::vector<CellMisfit> cells; ///< only localise: they raise no alarm
  std::vector<RunOffset> offsets;
};

/// Tests of the calibrated baseline. All references are parametric bootstraps from the error model
/// in the whitened tangent space: draws of rows and of the calibrated parameters from their priors,
/// refitted by the projector P, which is exact for a linear model and leaves out its curvature
/// otherwise. Residuals of a cell are whitened by the covariance of its own rows, so that a
/// misfit shows where it lives and not, through correlations, elsewhere.
/// @param covariance  Sigma as it was whitened
/// @throws dem::InvalidInput for fewer than 400 draws or a level outside 0 to 1
MisfitTests test_misfit(Observations const& observations, Comparison const& comparison,
                        Eigen::MatrixXd const& covariance, SignatureLibrary const& library,
                        MisfitSettings const& settings);

} // namespace coupling::diagnosis
