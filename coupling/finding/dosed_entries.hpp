#pragma once

#include "coupling/case.hpp"
#include "coupling/finding/entry_change.hpp"

#include <functional>
#include <optional>

/// Causes of which only a simulation tells how much of an entry makes an effect of their size.
namespace coupling::finding {

/// How far the entries of such a cause go: 0 is the case, and the effect grows about in proportion.
struct Dose {
  double guess, largest; ///< [1], > 0
};

struct DosedCause {
  Dose dose{};
  std::function<std::vector<EntryChange>(double dose)> entries = {};
  std::string obstacle = {}; ///< a sentence, where nothing can be entered
};

/// Entries along a dose x, for a size a:
///   plastic_contacts   share x of Hertz' force that yielding takes at the overlap d of full load:
///                      x = 1 - 3/2 s + s^3/2,  s^2 = d_y / d,  p_y = 2 E* / pi sqrt(d_y / R*)
///                      guess a                        Contact/Normal law, Yield pressure
///   multi_contact      b + x,  guess 0.3 a            Contact/Multi-contact coefficient
///   breakage           sigma_0 = 0.75 s_max x^(-1/m),  guess 1, s_max the bed's largest stress
///                                                     Breakage/Strength, diameters
///   missing_fines      share + x,  guess 10 a, of 3/4 of the finest diameter
///                                                     Powder/Added fines/Share, Diameter
///   fill_state         s + x,  guess 100 a            Powder/Fill state
/// Guesses are from pressings of the quick case (README). Sources: Thornton and Ning, Powder
/// Technol. 99 (1998) 154, eqs 13 to 22, for p_y; BreakageLaw for sigma_0.
/// @returns nothing for a cause that has no dose
std::optional<DosedCause> dosed_cause(FoundCause const& cause, Case const& setup,
                                      BedFacts const& facts);

} // namespace coupling::finding
