#pragma once

#include "tests/diagnosis/judge/binomial.hpp"
#include "tests/diagnosis/judge/judged_case.hpp"

#include <span>
#include <string>
#include <vector>

namespace judging {

/// A bar of the diagnosis note's section 3.3, held against the cases that it speaks of.
struct BarResult {
  std::string bar;      ///< B1, ...
  std::string quantity; ///< in words
  double target;        ///< rate
  int cases, count;     ///< with none the bar says nothing
  int limit;            ///< of the count
  bool is_upper;        ///< the rate must not exceed the target
  bool holds;
};

/// @param level  of each binomial test
std::vector<BarResult> hold_bars(std::span<JudgedCase const> cases, double level = usual_level);

/// The results as a table. @return whether all hold
bool print(std::span<BarResult const> results);

} // namespace judging
