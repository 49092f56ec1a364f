#include "coupling/finding/dosed_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coupling::finding {
namespace {

DosedCause obstacle(std::string sentence) {
  return {.obstacle = std::move(sentence)};
}

/// s in 1 - 3/2 s + s^3/2 = share, for a share from 0 to 1: falling from 1 at s = 0 to 0 at s = 1.
double root_of_share(double share) {
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) {
    double const s = 0.5 * (low + high);
    (1.0 - 1.5 * s + 0.5 * s * s * s > share ? low : high) = s;
  }
  return 0.5 * (low + high);
}

DosedCause plastic_contacts(double size, Case const& setup, BedFacts const& facts) {
  if (!(facts.relative_overlap > 0.0))
    return obstacle("the overlap of the contacts at full load is not known, from which the Yield "
                    "pressure follows. Run the case first?");
  constexpr double most = 0.95;
  auto const& grain = setup.powder.components.front().material;
  double const modulus =
      0.5 * grain.young_modulus / (1.0 - grain.poisson_ratio * grain.poisson_ratio);
  double const hardest = 2.0 * modulus / std::numbers::pi * std::sqrt(facts.relative_overlap);
  return {.dose = {.guess = std::min(size, most), .largest = most},
          .entries = [law = setup.contacts.law, hardest](double dose) {
            return std::vector<EntryChange>{
                {"Contact/Preset", "custom"},
                {"Contact/Normal law", "thornton_ning"},
                {"Contact/Cohesion law", law.cohesion},
                {"Contact/Tangential law", law.tangential},
                entry_change("Contact/Yield pressure", hardest * root_of_share(dose))};
          }};
}

/// In the quick case b = 0.3 gives the stress that the emulator has at a size of 1.
DosedCause multi_contact(double size, Case const& setup, BedFacts const&) {
  return {.dose = {.guess = 0.3 * size, .largest = 3.0},
          .entries = [own = setup.contacts.law.multi_contact](double dose) {
            return std::vector{entry_change("Contact/Multi-contact coefficient", own + dose)};
          }};
}

struct Diameters {
  double finest, coarsest; ///< [m], without added fines
};
Diameters diameters_of(Powder const& powder) {
  Diameters found{.finest = 1.0, .coarsest = 0.0};
  for (auto const& component : powder.components)
    for (auto const& size : component.sizes)
      if (powder.fines.share == 0.0 || size.diameter > powder.fines.diameter) {
        found.finest = std::min(found.finest, size.diameter);
        found.coarsest = std::max(found.coarsest, size.diameter);
      }
  return found;
}

/// Every class breaks, and pieces of the finest do not: they would take a time step of their own.
DosedCause breakage(double, Case const& setup, BedFacts const& facts) {
  if (!(facts.largest_stress > 0.0))
    return obstacle("the largest stress on the bed is not known, by which the Strength is guessed. "
                    "Run the case first?");
  auto const [finest, coarsest] = diameters_of(setup.powder);
  auto law = setup.breakage;
  double const modulus = law.weibull_modulus, scale = 0.75 * facts.largest_stress;
  double const own = law.is_on() ? std::pow(law.strength / scale, -modulus) : 0.0;
  if (!law.is_on()) {
    law.reference_diameter = coarsest;
    law.smallest_diameter = 0.9 * finest;
  }
  return {.dose = {.guess = 1.0, .largest = 1e6}, .entries = [=](double dose) {
            return std::vector{
                entry_change("Breakage/Strength", scale * std::pow(own + dose, -1.0 / modulus)),
                entry_change("Breakage/Reference diameter", law.reference_diameter),
                entry_change("Breakage/Smallest diameter", law.smallest_diameter)};
          }};
}

/// A dose of an entry between bounds that goes the way of the size.
DosedCause between(double own, double size, double per_size, double high, std::string const& none,
                   std::function<std::vector<EntryChange>(double)> entries) {
  double const largest = size > 0.0 ? high - own : own;
  if (!(largest > 0.0))
    return obstacle(none);
  double const way = size > 0.0 ? 1.0 : -1.0;
  return {.dose = {.guess = std::min(per_size * std::abs(size), largest), .largest = largest},
          .entries = [=](double dose) { return entries(own + way * dose); }};
}

DosedCause missing_fines(double size, Case const& setup, BedFacts const&) {
  constexpr double most = 0.5; // of the entry
  auto const& own = setup.powder.fines;
  double const diameter = own.share > 0.0 ? own.diameter : 0.75 * diameters_of(setup.powder).finest;
  return between(own.share, size, 10.0, most,
                 size > 0.0 ? "the case has as many Added fines as it can. Give it a finer class?"
                            : "the powder has fewer fines than the case, whose size classes are "
                              "its fines. Make them coarser?",
                 [diameter](double share) {
                   return std::vector{entry_change("Powder/Added fines/Share", share),
                                      entry_change("Powder/Added fines/Diameter", diameter)};
                 });
}

DosedCause fill_state(double size, Case const& setup, BedFacts const&) {
  return between(
      setup.powder.fill_state, size, 100.0, 1.0,
      size > 0.0 ? "the case fills its die as densely as it can: Fill state = 1. Is "
                   "something else the cause?"
                 : "the powder lies looser than grains that settle with their full "
                   "friction, for which the case has no entry. Raise the friction?",
      [](double state) { return std::vector{entry_change("Powder/Fill state", state)}; });
}

} // namespace

std::optional<DosedCause> dosed_cause(FoundCause const& cause, Case const& setup,
                                      BedFacts const& facts) {
  static std::map<std::string, DosedCause (*)(double, Case const&, BedFacts const&),
                  std::less<>> const all = {{"plastic_contacts", plastic_contacts},
                                            {"multi_contact", multi_contact},
                                            {"breakage", breakage},
                                            {"missing_fines", missing_fines},
                                            {"fill_state", fill_state}};
  auto const found = all.find(cause.name);
  if (found == all.end())
    return std::nullopt;
  return found->second(cause.size(), setup, facts);
}

} // namespace coupling::finding
