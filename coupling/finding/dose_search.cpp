#include "coupling/finding/dose_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coupling::finding {
namespace {

struct Tried {
  double dose, effect;
};

/// Where the line through two tries is 1; no nearer and no farther than `farthest` allows.
double crossing(Tried const& first, Tried const& last, double farthest) {
  double const slope = (last.effect - first.effect) / (last.dose - first.dose);
  double const at = last.dose + (1.0 - last.effect) / slope;
  return slope > 0.0 ? std::min(at, farthest) : farthest;
}

} // namespace

FoundDose search_dose(Dose const& dose, DoseSearch const& search,
                      std::function<std::optional<double>(double)> const& effect_of) {
  constexpr double largest_step = 4.0;
  auto const distance = [](double effect) { return std::abs(effect - 1.0); };
  Tried last{0.0, 0.0}; // below 1
  std::optional<Tried> above;
  double at = std::min(dose.guess, dose.largest);
  FoundDose best{.dose = at, .effect = 0.0, .n_simulations = 0, .is_reached = false};
  for (int n = 1; n <= search.most_simulations; ++n) {
    auto const effect = effect_of(at);
    if (!effect)
      break;
    Tried const now{at, *effect};
    if (n == 1 || distance(now.effect) < distance(best.effect))
      best = {now.dose, now.effect, n, distance(now.effect) <= search.tolerance};
    best.n_simulations = n;
    if (best.is_reached || (now.effect < 1.0 && at == dose.largest))
      break;
    if (now.effect >= 1.0)
      above = now;
    if (above)
      at = crossing(now.effect < 1.0 ? now : last, *above, above->dose);
    else
      at = crossing(last, now, std::min(largest_step * now.dose, dose.largest));
    if (now.effect < 1.0)
      last = now;
  }
  return best;
}

std::string in_words(FoundDose const& found) {
  if (found.n_simulations == 0)
    return "a first guess, whose simulation failed";
  return fmt::format("by {} simulation{}, the nearest of which shows {:.2f} of the effect{}",
                     found.n_simulations, found.n_simulations == 1 ? "" : "s", found.effect,
                     found.is_reached ? "" : ": not reached");
}

} // namespace coupling::finding
