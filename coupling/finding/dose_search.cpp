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

/// Where the line between two tries is 1.
double crossing(Tried const& low, Tried const& high) {
  return low.dose + (high.dose - low.dose) * (1.0 - low.effect) / (high.effect - low.effect);
}

} // namespace

FoundDose search_dose(Dose const& dose, DoseSearch const& search,
                      std::function<double(double)> const& effect_of) {
  constexpr double farthest = 4.0;
  auto const distance = [](double effect) { return std::abs(effect - 1.0); };
  Tried below{0.0, 0.0};
  std::optional<Tried> above;
  double at = std::min(dose.guess, dose.largest);
  FoundDose best{.dose = at, .effect = 0.0, .n_simulations = 0, .is_reached = false};
  for (int n = 1; n <= search.most_simulations; ++n) {
    Tried const now{at, effect_of(at)};
    if (n == 1 || distance(now.effect) < distance(best.effect))
      best = {now.dose, now.effect, n, distance(now.effect) <= search.tolerance};
    best.n_simulations = n;
    if (best.is_reached || (now.effect < 1.0 && at == dose.largest))
      break;
    if (now.effect >= 1.0)
      above = now;
    else
      below = now;
    if (above)
      at = crossing(below, *above);
    else
      at = std::min({at / std::max(now.effect, 1.0 / farthest), dose.largest});
  }
  return best;
}

std::string in_words(FoundDose const& found) {
  return fmt::format("by {} simulation{}, the nearest of which shows {:.2f} of the effect{}",
                     found.n_simulations, found.n_simulations == 1 ? "" : "s", found.effect,
                     found.is_reached ? "" : ": not reached");
}

} // namespace coupling::finding
