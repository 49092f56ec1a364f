#include "tests/diagnosis/judge/bars.hpp"

#include "tests/diagnosis/judge/gain_bars.hpp"
#include "tests/diagnosis/judge/rates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace judging {
namespace {

bool is_clean(JudgedCase const& c) {
  return c.truth.kind == "clean";
}
bool has_effect(JudgedCase const& c) {
  return !is_clean(c);
}
bool is_single(JudgedCase const& c) {
  return c.truth.kind == "single";
}
/// Of two effects, both of which show: an effect whose largest size is fainter is no pair's.
bool is_double(JudgedCase const& c) {
  return c.truth.kind == "double" && c.truth.faintest.value_or(25.0) >= 20.0;
}
/// The generator is asked for a lambda and comes within some per cent of it.
bool near_eight(JudgedCase const& c) {
  return c.truth.lambda.value_or(0.0) >= 7.5 && *c.truth.lambda < 15.0;
}
bool from_sixteen(JudgedCase const& c) {
  return c.truth.lambda.value_or(0.0) >= 15.0;
}
bool is_separable(JudgedCase const& c) {
  return c.truth.separation.value_or(5.0) >= 5.0;
}
/// One name is asked for only where it was foretold that data allow it; the truth always.
bool is_foretold(JudgedCase const& c) {
  return c.truth.separation.has_value();
}
bool is_confounded(JudgedCase const& c) {
  return is_single(c) && c.truth.separation.value_or(5.0) < 2.0 && c.is_detected();
}
bool names_placebo(JudgedCase const& c) {
  for (auto const& name : c.answer.claim)
    if (name.starts_with("placebo"))
      return true;
  return false;
}

void alarms_and_power(Rates& hold) {
  auto const detected = [](auto const& c) { return c.is_detected(); };
  hold.at_most("B1", "false alarms on clean data", 0.01, is_clean, detected);
  hold.at_least(
      "B3", "detected, lambda 8", 0.85, [](auto const& c) { return is_single(c) && near_eight(c); },
      detected);
  hold.at_least(
      "B3", "detected, lambda 16 and more", 0.98,
      [](auto const& c) { return is_single(c) && from_sixteen(c); }, detected);
}

void naming(Rates& hold) {
  auto const full = [](auto const& c) {
    return is_single(c) && c.truth.has_all_gauges && is_separable(c);
  };
  auto const large = [&](auto const& c) { return full(c) && from_sixteen(c); };
  auto const small = [&](auto const& c) { return full(c) && near_eight(c) && c.is_detected(); };
  auto const large_one = [&](auto const& c) { return large(c) && is_foretold(c); };
  auto const small_one = [&](auto const& c) { return small(c) && is_foretold(c); };
  auto const alone = [](auto const& c) { return c.is_right_alone(); };
  auto const inside = [](auto const& c) { return c.has_truth(); };
  auto const wrong = [](auto const& c) { return c.is_wrong(); };
  hold.at_least("B4", "unique, right and alone, lambda 16", 0.85, large_one, alone);
  hold.at_least("B4", "truth in the answer, lambda 16", 0.95, large, inside);
  hold.at_most("B4", "wrong, lambda 16", 0.02, large, wrong);
  hold.at_least("B5", "of detected unique and right, lambda 8", 0.65, small_one, alone);
  hold.at_least("B5", "of detected truth in the answer, lambda 8", 0.95, small, inside);
  hold.at_most("B5", "of detected wrong, lambda 8", 0.03, small, wrong);
  hold.at_most(
      "B6", "spurious second cause, lambda 16", 0.08,
      [](auto const& c) { return is_single(c) && from_sixteen(c); },
      [](auto const& c) { return c.has_truth() && c.has_spurious(); });
}

/// No mechanism below one half, whatever the mean says (section 3.3, ways to game).
void floors(Rates& hold, std::span<JudgedCase const> cases) {
  std::map<std::string, int> counts;
  for (auto const& c : cases)
    if (is_single(c) && from_sixteen(c) && is_separable(c) && c.truth.has_all_gauges)
      ++counts[*c.truth.causes.begin()];
  for (auto const& [name, n] : counts)
    if (n >= 8)
      hold.at_least(
          "B4", ("floor of " + name).c_str(), 0.5,
          [&](auto const& c) {
            return is_single(c) && from_sixteen(c) && is_separable(c) && c.truth.has_all_gauges &&
                   c.truth.causes.contains(name);
          },
          [](auto const& c) { return c.has_truth(); });
}

void groups_and_pairs(Rates& hold) {
  hold.at_least("B7", "confounded: truth in the answer", 0.95, is_confounded,
                [](auto const& c) { return c.has_truth(); });
  hold.at_most("B7", "confounded: unique name", 0.10, is_confounded,
               [](auto const& c) { return c.is_unique(); });
  hold.at_most("B7", "confounded: unique and wrong", 0.01, is_confounded,
               [](auto const& c) { return c.is_unique() && !c.has_truth(); });
  hold.at_least("B9", "both and nothing else", 0.80, is_double,
                [](auto const& c) { return c.is_named() && c.answer.claim == c.truth.causes; });
  hold.at_least("B9", "one at least, none wrong", 0.95, is_double, [](auto const& c) {
    return !c.answer.claim.empty() && !c.is_wrong() && !c.has_spurious();
  });
  hold.at_most("B9", "a third cause", 0.05, is_double,
               [](auto const& c) { return c.has_truth() && c.has_spurious(); });
}

void unlisted_and_placebo(Rates& hold) {
  auto const unlisted = [](auto const& c) {
    return c.truth.kind == "unknown" && c.truth.lambda.value_or(10.0) >= 10.0;
  };
  hold.at_least("B10", "unlisted: unknown or incomplete", 0.95, unlisted, [](auto const& c) {
    return c.answer.verdict == "unknown" || c.answer.is_incomplete;
  });
  hold.at_most("B10", "unlisted: a name without reserve", 0.03, unlisted,
               [](auto const& c) { return c.is_named() && !c.answer.is_incomplete; });
  hold.at_most("B16", "placebo named on clean data", 0.01, is_clean, names_placebo);
  hold.at_most("B16", "placebo named beside an effect", 0.02, has_effect, names_placebo);
}

/// Printed probabilities against how often they are right.
void confidence(Rates& hold, std::span<JudgedCase const> cases) {
  auto const sure = [](auto const& c) { return c.is_named() && c.answer.probability >= 0.9; };
  auto const right = [](auto const& c) {
    return !c.has_spurious() && (c.truth.kind != "clean" && !c.is_wrong());
  };
  double sum = 0.0;
  int n = 0;
  for (auto const& c : cases)
    if (sure(c))
      sum += c.answer.probability, ++n;
  double const mean = n > 0 ? sum / n : 0.9;
  hold.at_least("B11", "claims of 0.9 and more are right", 0.92, sure, right);
  hold.at_least("B11", "right as often as said, less 0.04", mean - 0.04, sure, right);
  hold.at_most("B11", "right as often as said, and 0.04", std::min(1.0, mean + 0.04), sure, right);
}

void sizes(Rates& hold) {
  auto const sized = [](auto const& c) {
    return is_single(c) && c.is_right_alone() && c.answer.size && c.truth.size != 0.0;
  };
  auto const ratio = [](auto const& c) { return c.answer.size->value / c.truth.size; };
  // A median within 10 % has half of the ratios on either side of its bound.
  hold.at_most("B12", "sizes above 1.1 of the true ones", 0.5, sized,
               [&](auto const& c) { return ratio(c) > 1.1; });
  hold.at_most("B12", "sizes below 0.9 of the true ones", 0.5, sized,
               [&](auto const& c) { return ratio(c) < 0.9; });
  hold.at_least("B12", "95 % interval holds the true size", 0.85, sized, [](auto const& c) {
    return c.answer.size->low <= c.truth.size && c.truth.size <= c.answer.size->high;
  });
}

} // namespace

std::vector<BarResult> hold_bars(std::span<JudgedCase const> cases, double level) {
  Rates hold(cases, level);
  alarms_and_power(hold);
  naming(hold);
  floors(hold, cases);
  groups_and_pairs(hold);
  unlisted_and_placebo(hold);
  confidence(hold, cases);
  sizes(hold);
  hold_clean_levels(hold);
  hold_gains(hold);
  return hold.results;
}

bool print(std::span<BarResult const> results) {
  bool all = true;
  fmt::print("{:4} {:44} {:>7} {:>6} {:>6} {:>7}\n", "bar", "quantity", "target", "cases", "count",
             "limit");
  for (auto const& r : results) {
    fmt::print("{:4} {:44} {:>2}{:5.3f} {:6} {:6} {:>2}{:5} {}\n", r.bar, r.quantity,
               r.is_upper ? "<=" : ">=", r.target, r.cases, r.count,
               r.is_upper ? "<=" : ">=", r.limit,
               r.cases == 0 ? "no cases"
               : r.holds    ? "holds"
                            : "FAILS");
    all = all && r.holds;
  }
  return all;
}

} // namespace judging
