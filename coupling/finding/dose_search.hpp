#pragma once

#include "coupling/finding/dosed_entries.hpp"

#include <functional>

namespace coupling::finding {

struct DoseSearch {
  double tolerance = 0.05;  ///< of the effect, which is 1
  int most_simulations = 4; ///< >= 1
};

struct FoundDose {
  double dose, effect; ///< [1], effect 1: all that was asked for
  int n_simulations;   ///< that came to their end
  bool is_reached;     ///< within the tolerance
};

/// Searches for the dose whose effect is 1: the guess first, then where the straight line through
/// the last two tries says (the first from no effect at 0), or through a bracket once there is one;
/// a dose is at most four times the last. Ends within the tolerance, at the largest dose that is
/// too little, after the most simulations or with one that fails, with the dose nearest to 1, or
/// the guess if none was simulated.
/// @param effect_of  of a dose, by a simulation; may be noisy. Nothing: it cannot be simulated
FoundDose search_dose(Dose const& dose, DoseSearch const& search,
                      std::function<std::optional<double>(double)> const& effect_of);

/// "by 2 simulations, the nearest of which shows 0.97 of the effect".
std::string in_words(FoundDose const& found);

} // namespace coupling::finding
