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
  int n_simulations;
  bool is_reached; ///< within the tolerance
};

/// Searches for the dose whose effect is 1: the guess first, then where the straight line through
/// the last two tries says (the first from no effect at 0), or through a bracket once there is one;
/// a dose is at most four times the last. Ends within the tolerance, at the largest dose that is
/// too little, or after the most simulations, with the dose nearest to 1.
/// @param effect_of  of a dose, by a simulation; may be noisy. What it throws ends the search
FoundDose search_dose(Dose const& dose, DoseSearch const& search,
                      std::function<double(double)> const& effect_of);

/// "by 2 simulations, the last of which shows 0.97 of the effect".
std::string in_words(FoundDose const& found);

} // namespace coupling::finding
