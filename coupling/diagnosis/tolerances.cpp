#include "coupling/diagnosis/tolerances.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

namespace coupling::diagnosis {

std::vector<StatedTolerance> state(Tolerances const& t) {
  std::string const study = "diagnosis note 2a (measured on hidden effects)";
  return {
      {"model_share", t.model_share, "sd of the simulator's own error over the prediction", study},
      {"phase_length", t.phase_length, "length over which that error is alike, of a phase", study},
      {"run_correlation", t.run_correlation, "correlation of that error between runs", study},
      {"form_share", t.form_share, "sd of a law's shape over the change that it makes", study},
      {"bias_share", t.bias_share, "share of the corrected numerical bias that stays uncertain",
       "ASME V&V 20 (2009), u_num; " + study},
      {"kink_share", t.kink_share, "sd at contact onset and loss over the largest prediction",
       study + ": 100 N at 25 kN"},
      {"kink_decay", t.kink_decay, "share of the largest prediction at which that is 1/e",
       study + ": 300 N at 25 kN"},
      {"null_multiple", t.null_multiple, "r.m.s. sizes on clean data below which none is claimed",
       "Efron (2004), empirical null; " + study},
      {"largest_jitter", t.largest_jitter, "largest variance added to a singular covariance",
       "rounding of a Cholesky factor"},
  };
}

void validate(Tolerances const& tolerances) {
  for (auto const& one : state(tolerances))
    VALIDATE(one.value >= 0.0, fmt::format("{} = {:g}: is negative ({}). Which share is meant?",
                                           one.name, one.value, one.meaning));
  VALIDATE(tolerances.phase_length > 0.0 && tolerances.kink_decay > 0.0,
           fmt::format("phase_length = {:g}, kink_decay = {:g}: must be positive (they are "
                       "lengths). Is the tolerance itself to be off?",
                       tolerances.phase_length, tolerances.kink_decay));
  VALIDATE(tolerances.run_correlation <= 1.0,
           fmt::format("run_correlation = {:g}: is beyond 1 (it is a correlation). Is it in per "
                       "cent?",
                       tolerances.run_correlation));
}

} // namespace coupling::diagnosis
