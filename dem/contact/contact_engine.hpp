#pragma once

#include "dem/contact/contact.hpp"
#include "dem/contact/contact_choice.hpp"
#include "dem/contact/contact_state.hpp"
#include "dem/step/world_fwd.hpp"
#include "dem/surface/tool_deformation.hpp"

#include <cstdint>
#include <memory>
#include <span>
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
  std::uint64_t listed = 0; ///< pairs and walls in the inner list now
  std::uint64_t active = 0; ///< of them touching
  double seconds = 0.0;     ///< wall time spent in builds
  std::size_t bytes = 0;    ///< memory of lists and records
};

/// Finds the contacts of a World and computes their forces: neighbour lists, contact history and
/// the sweep, in the number type that the case asks for. Copyable; a copy goes on to the same bits.
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

  /// The parts of a step, in their order. The first also carries what the sweep needs from each
  /// grain and, if the step before was left open, its loads and second half kick: one pass through
  /// memory instead of three.
  /// @param dt  step [s]

  /// Half kick and drift of every grain. @returns power of gravity over the drift [W]
  double kick_and_drift(World& world, double dt);
  /// Brings the lists up to date with the present positions; grains may be put in a new order.
  void refresh(World& world, double dt);
  /// Forces of the present positions with the half-step velocities into load buffers, tools and
  /// energy tally; springs advance by dt.
  void sweep(World& world, double dt);
  /// Sums the loads of every grain and gives the second half kick of the last sweep's step, unless
  /// that is done.
  void complete(World& world);

  /// Lists and forces of the present state; nothing moves, no spring advances.
  void evaluate(World& world);

  /// Lets every contact with a deformable tool follow what the tool does in the window that begins
  /// now.
  void follow_tools(World const& world);
  /// What grains gave the deformable tools since it was last asked, one entry a contact and list,
  /// in the order of blocks; places are those of the beginning of the window or of the list.
  std::vector<WallImpulse> take_impulses();

  /// Empties the histories of all contacts of these grains, before they are replaced by others.
  void forget(std::span<std::uint32_t const> rows);

  /// Every active contact in full precision, with the springs as they are, in the order of rows.
  void visit(World const& world, ContactStream::Visit const& visit) const;

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

} // namespace dem
