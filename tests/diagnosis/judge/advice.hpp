#pragma once

#include "tests/diagnosis/judge/bars.hpp"

namespace judging {

/// A case that was answered by a group with its cause in it, and with a measurement that will tell.
struct Advised {
  std::string name, seed, observables, cause, size; ///< as the truth has them
  std::string measurement;                          ///< its name in `hide --also`
};

/// Single effects of a set, with the first recommended measurement, if it "is enough" and one that
/// the generator can make (not another gauge).
/// @throws std::runtime_error as read_cases
std::vector<Advised> advised_cases(std::filesystem::path const& folder);

/// B8 of cases that were diagnosed again with that measurement: named, right and alone.
BarResult hold_advice(std::span<JudgedCase const> again, double level = usual_level);

} // namespace judging
