#pragma once

#include "coupling/finding/finding.hpp"

namespace coupling::finding {

/// diagnosis.json: the keys of the outward contract (verdict, incomplete, misfit, causes, group,
/// next_measurement, gain, detectable, tolerances) and beside them sentences, alarm, levels,
/// not_claimed, placebo, unknown, calibrated, extension, not_modelled,
/// decisions, seeds, provenance. Numbers that do not
/// exist are null; the ends of a parameter's interval are always numbers, with open_low and
/// open_high where the data do not end it. The same finding gives the same bytes.
std::string diagnosis_json(Finding const& finding);

} // namespace coupling::finding
