#include "tests/diagnosis/judge/gain_bars.hpp"

#include <algorithm>

namespace judging {
namespace {

/// Of noise, repeats and tolerance an error of one standard uncertainty is made.
constexpr double close_to_floor = 1.5, far_from_floor = 3.0;

bool is_clean_with(JudgedCase const& c, std::optional<double> const& p) {
  return c.truth.kind == "clean" && p.has_value();
}

bool is_named_rightly(JudgedCase const& c) {
  return c.truth.kind == "single" && c.truth.lambda.value_or(0.0) >= 15.0 && c.is_right_alone() &&
         c.answer.gain.has_value();
}

} // namespace

void hold_clean_levels(Rates& hold) {
  auto const all = [](auto const& c) { return is_clean_with(c, c.answer.p_omnibus); };
  auto const best = [](auto const& c) { return is_clean_with(c, c.answer.p_targeted); };
  hold.at_most("B2", "clean, p of all rows below 0.1", 0.1, all,
               [](auto const& c) { return *c.answer.p_omnibus < 0.1; });
  hold.at_most("B2", "clean, p of the best cause below 0.1", 0.1, best,
               [](auto const& c) { return *c.answer.p_targeted < 0.1; });
  hold.at_most("B2", "clean, p of the best cause below 0.5", 0.5, best,
               [](auto const& c) { return *c.answer.p_targeted < 0.5; });
}

void hold_gains(Rates& hold) {
  auto const started = [](double from) {
    return [from](auto const& c) { return is_named_rightly(c) && c.answer.gain->before > from; };
  };
  hold.at_least(
      "B13", "gain beyond 4 s.e., where 1.5 were left", 0.95, started(close_to_floor),
      [](auto const& c) { return c.answer.gain->elpd > 4.0 * c.answer.gain->elpd_error; });
  hold.at_least("B13", "error after at most 1.5 of the floor", 0.95, is_named_rightly,
                [](auto const& c) { return c.answer.gain->after <= close_to_floor; });
  hold.at_least("B13", "rows inside their 95 % band, 88 % or more", 0.95, is_named_rightly,
                [](auto const& c) { return c.answer.gain->coverage >= 0.88; });
  hold.at_least("B14", "error halved, where 3 were left", 0.95, started(far_from_floor),
                [](auto const& c) { return c.answer.gain->after <= 0.5 * c.answer.gain->before; });
  hold.at_most(
      "B14", "above the floor and worse than the placebo", 0.02,
      [](auto const& c) { return is_named_rightly(c) && c.answer.gain->of_placebo.has_value(); },
      [](auto const& c) {
        return c.answer.gain->after > std::max(1.0, *c.answer.gain->of_placebo);
      });
  hold.at_least(
      "B15", "clean: no gain is claimed", 0.95,
      [](auto const& c) { return c.truth.kind == "clean"; },
      [](auto const& c) { return !c.answer.gain.has_value(); });
}

} // namespace judging
