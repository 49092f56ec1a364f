#pragma once

#include "dem/contact/contact.hpp"
#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_state.hpp"
#include "dem/step/world_fwd.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace dem {

/// Energy held by the contacts of the present state [J].
struct StoredEnergy {
  double elastic = 0.0;
  double cohesive = 0.0;
};

/// What the neighbour lists cost and hold.
struct ListStatistics {
  std::uint64_t outer_builds = 0;
  std::uint64_t inner_builds = 0;
  std::uint64_t listed = 0;     ///< pairs and walls in the inner list now
  std::uint64_t active = 0;     ///< of them touching
  double seconds = 0.0;         ///< wall time spent in builds
  std::size_t bytes = 0;        ///< memory of lists and records
};

/// Finds the contacts of a World and computes their forces: neighbour lists, contact history and the sweep, in the
/// number type that the case asks for. Copyable; a copy goes on to the same bits.
class ContactEngine {
public:
  ContactEngine();
  /// @throws InvalidInput for unknown laws
  explicit ContactEngine(ContactChoice const& choice);
  ContactEngine(ContactEngine const&);
  ContactEngine(ContactEngine&&) noexcept;
  ContactEngine& operator=(ContactEngine const&);
  ContactEngine& operator=(ContactEngine&&) noexcept;
  ~ContactEngine();

  ContactChoice const& choice() const { return choice_; }

  /// Rebuilds all lists if none exist; otherwise brings them up to date with the present positions. Grains may be
  /// put in a new order.
  /// @param dt  step [s]: sets how far ahead the lists look
  void refresh(World& world, double dt);

  /// Forces of the present positions with the present velocities into grains, tools and energy tally.
  /// @param dt  [s]; springs advance by it, 0 leaves them
  void compute(World& world, double dt);

  /// Every active contact in full precision, with the springs as they are, sorted by ids.
  std::vector<Contact> list(World const& world) const;

  StoredEnergy energy(World const& world) const;

  /// Smallest stable step of any grain [s], see stable_time_step().
  double stable_step(World const& world) const;

  ListStatistics statistics(World const& world) const;

  /// Everything a restart must keep; `restore` expects the grains in the order of `capture`.
  ContactState capture() const;
  void restore(World& world, ContactState const& state);

  class Store;

private:
  ContactChoice choice_;
  std::unique_ptr<Store> store_;
};

}  // namespace dem
