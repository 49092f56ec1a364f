#pragma once

#include "tests/crosscode/liggghts/deck_parts.hpp"

#include "dem/packing/packing.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace crosscode {

/// A few grains without gravity, every step of which LIGGGHTS writes with 17 digits.
struct StepsDeck {
  dem::Packing grains;   ///< of seed_components()
  double cohesion = 5e6; ///< [J/m^3], grain to grain
  FrictionLimit friction_limit = FrictionLimit::net;
  std::optional<double> plate_speed =
      {}; ///< [m/s], of a plate that starts in z = 0 and moves along z
  std::optional<double> bore_diameter = {}; ///< [m], of an exact cylinder about the z axis
  double dt = 4e-7;                         ///< [s]
  long n_steps = 3000;
};

/// What a code says of a grain after a step.
struct GrainState {
  dem::Vec3 position, velocity, spin; ///< [m], [m/s], [rad/s]
  dem::Vec3 force, torque;            ///< [N], [N m]
};

using Frame = std::vector<GrainState>; ///< grains in the order of the deck

/// Writes in.steps and what it reads into `folder`; the peer leaves steps.txt.
void write_steps_deck(StepsDeck const& deck, std::filesystem::path const& folder);

/// Frames of steps.txt, the initial one first. @throws std::runtime_error if one is incomplete
std::vector<Frame> read_steps(std::filesystem::path const& file, std::size_t n_grains);

/// Largest deviation of each vector over all frames, relative to that vector's largest value:
/// position, velocity, spin, force, torque.
std::array<double, 5> largest_deviations(std::vector<Frame> const& a, std::vector<Frame> const& b);

} // namespace crosscode
