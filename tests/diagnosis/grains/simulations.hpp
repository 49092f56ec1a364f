#pragma once

#include "tests/diagnosis/grains/curve.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace hidden {

/// Which simulator the laboratory's powder is in: the project's own program (tier 2), or LIGGGHTS
/// 3.8, an independent code (tier 3).
enum class Code { own, liggghts };

/// A bed and what happens in it, as either code is told.
struct GrainPress {
  std::uint64_t packing = 1;          ///< seed of the grains' places
  double young_modulus = 250e6;       ///< of the grains [Pa]
  double cohesion_density = 5e6;      ///< between grains [J/m^3]
  double friction = 0.2;              ///< between grains [1]
  double wall_friction = 0.2;         ///< at the tools [1]
  double end_gap = 8e-3;              ///< at which the punch turns [m]
  std::vector<std::string> more = {}; ///< other entries, 'Section/Entry=value'; own program only
};

/// Where simulations come from and are kept: a folder NAME for each, with entries.txt, by which a
/// later call knows it again.
struct Simulations {
  Code code;
  std::string program;  ///< path of either program
  std::string own_case; ///< the case file of which entries are changed; own program only
  std::filesystem::path cache;

  /// The curve of `press`, from the cache if it is there.
  /// @param change  what differs from the case, for the folder's name: packing-SEED[-CHANGE]
  /// @throws std::runtime_error if the program fails, with its last line
  Curve curve(GrainPress const& press, std::string const& change = {}) const;
};

/// All entries of the case that `press` changes, in order.
std::vector<std::string> entries_of(GrainPress const& press);

} // namespace hidden
