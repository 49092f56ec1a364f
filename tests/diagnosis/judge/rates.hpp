#pragma once

#include "tests/diagnosis/judge/bars.hpp"

#include <functional>

namespace judging {

using Test = std::function<bool(JudgedCase const&)>;

/// Cases of which a bar speaks, and how often something holds among them.
class Rates {
public:
  Rates(std::span<JudgedCase const> cases, double level) : cases_(cases), level_(level) {}

  void at_most(char const* bar, char const* what, double target, Test const& of, Test const& is) {
    add(bar, what, target, of, is, true);
  }
  void at_least(char const* bar, char const* what, double target, Test const& of, Test const& is) {
    add(bar, what, target, of, is, false);
  }
  std::vector<BarResult> results;

private:
  void add(char const* bar, char const* what, double target, Test const& of, Test const& is,
           bool is_upper) {
    int n = 0, count = 0;
    for (auto const& one : cases_)
      if (of(one)) {
        ++n;
        count += is(one) ? 1 : 0;
      }
    int const limit = is_upper ? most_allowed(n, target, level_) : least_allowed(n, target, level_);
    results.push_back({.bar = bar,
                       .quantity = what,
                       .target = target,
                       .cases = n,
                       .count = count,
                       .limit = limit,
                       .is_upper = is_upper,
                       .holds = n == 0 || (is_upper ? count <= limit : count >= limit)});
  }
  std::span<JudgedCase const> cases_;
  double level_;
};

} // namespace judging
