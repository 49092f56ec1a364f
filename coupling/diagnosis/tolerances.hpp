#pragma once

#include <string>
#include <vector>

namespace coupling::diagnosis {

/// What is assumed about errors and stated with every verdict: it decides what can be detected.
/// Source of all: the project's study of hidden effects (diagnosis note, section 2a), unless the
/// laboratory states its own.
struct Tolerances {
  double model_share = 0.003;   ///< tau: sd of the simulator's own error over |f|
  double phase_length = 0.4;    ///< of the Matern-3/2 kernel over the phase coordinate
  double run_correlation = 0.8; ///< of that error between two runs
  double form_share = 0.07;     ///< a law is never exact: sd over the change that it makes
  double bias_share = 0.3;      ///< of the numerical bias stays uncertain after its correction
  double kink_share = 0.004;    ///< sd at contact onset and loss, over the largest |f|
  double kink_decay = 0.012;    ///< |f| over its largest at which that has fallen to 1/e
  double null_multiple = 3.0;   ///< sizes below this times their r.m.s. on clean data are no claim
  double largest_jitter = 1e-9; ///< share of each variance, added where Sigma is singular
};

/// One assumption in words.
struct StatedTolerance {
  std::string name;
  double value;
  std::string meaning, source;
};

/// All of them, in the order of the struct.
std::vector<StatedTolerance> state(Tolerances const& tolerances);

/// @throws dem::InvalidInput for a negative share, a length that is not positive or a correlation
/// outside 0 to 1
void validate(Tolerances const& tolerances);

} // namespace coupling::diagnosis
