#pragma once

#include "tests/diagnosis/judge/rates.hpp"

namespace judging {

/// B2: on clean data the p-values of both tests of the alarm lie no lower than chance has them.
/// They may lie higher; B3 holds against that.
void hold_clean_levels(Rates& hold);

/// B13 to B15: what the right name brings on held-out runs (single effects of lambda 16, named
/// alone), in standard uncertainties over all channels; and that clean data bring nothing.
void hold_gains(Rates& hold);

} // namespace judging
