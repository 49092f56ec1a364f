#pragma once

#include "tests/diagnosis/grains/simulations.hpp"
#include "tests/diagnosis/hide/effects.hpp"

#include <optional>
#include <span>

namespace hidden {

/// Where an effect is put in.
enum class Place {
  machine, ///< on the curve, by the laboratory's machine (laboratory.hpp)
  sheet,   ///< the laboratory is wrong about its own mass or bore
  grains   ///< in the simulation
};

/// A cause that this bed can show.
struct GrainCause {
  Effect effect;
  Place place;
  double trial;    ///< size of the pilot, far above the grains' own scatter
  double largest;  ///< that is hidden, with a smaller lambda if need be
  bool has_scale;  ///< its size is that of the contract's cause; else a knob of the simulator
  bool is_in_peer; ///< the other code has it, too
};

/// In turn, machine and grains mixed. Not among them: a rate (viscous contacts are unstable at
/// these time steps), a tilt and a denser fill (not seen at 1.2 mm, without friction), a die that
/// gives (its punches give, too: two causes), E and cohesion, which are calibrated.
std::span<GrainCause const> grain_causes();
std::optional<GrainCause> grain_cause(Effect effect);

/// The press with a cause of Place::grains in it.
GrainPress with_cause(GrainPress press, Effect effect, double size);

} // namespace hidden
