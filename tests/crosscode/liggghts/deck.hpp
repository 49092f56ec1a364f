#pragma once

#include "dem/packing/packing.hpp"

#include <filesystem>
#include <vector>

namespace crosscode {

/// One move of the upper punch, or a hold (speed 0).
struct PunchMove {
  double speed; ///< [m/s], positive up
  long n_steps; ///< of `dt`
  double dt;    ///< [s]
};

/// The seed's press cycle as LIGGGHTS is to run it: Hertz-Mindlin with history, SJKR2 between
/// grains, an exact cylinder, punches as single triangles much wider than the bore (the peer's
/// primitive planes cannot move and report their force; one triangle has no edge and no second
/// facet that a grain could meet).
struct PressDeck {
  double bore_diameter;         ///< [m]
  double start_gap;             ///< [m]
  double young_modulus = 250e6; ///< [Pa], of both powders
  double wall_modulus = 200e6;  ///< [Pa]
  double cohesion = 5e6;        ///< [J/m^3], grain to grain
  double skin = 0.1e-3;         ///< [m]
  long record_every = 1;        ///< [steps]
  std::vector<PunchMove> moves = {};
};

/// Writes in.press, grains.data and the punches' STL files into `folder`. The peer leaves there
///  - curves.txt   see read_peer_curve
///  - state_N.txt  the grains at the end of move N = 0, 1, ...
void write_press_deck(PressDeck const& deck, dem::Packing const& packing,
                      std::filesystem::path const& folder);

/// The grains of state_N.txt in the order of `initial`, from which diameters and components are
/// taken.
/// @throws std::runtime_error if grains are missing
dem::Packing read_state(std::filesystem::path const& file, dem::Packing const& initial);

} // namespace crosscode
