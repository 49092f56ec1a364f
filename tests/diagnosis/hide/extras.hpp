#pragma once

#include "tests/diagnosis/hide/cases.hpp"

#include <string_view>

namespace hidden {

/// A number that is measured on one pressing, with its instrument.
struct MeasuredNumber {
  std::string_view name, unit;
  double value, sd;
};

/// What was asked for beside the set, if it is a number: a balance of 5 mg, a bore gauge and a gap
/// gauge of 5 um, a caliper of 20 um, a dead weight of 10 kN read to 10 N. The name is empty if it
/// is none.
MeasuredNumber measured_number(Case const& of, std::uint64_t run, Cycle const& cycle);

} // namespace hidden
