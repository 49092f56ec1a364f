#pragma once

#include "tests/diagnosis/grains/foretold.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace hidden {

/// What the command line asks for.
struct GrainWish {
  std::uint64_t seed = 1;
  bool is_clean = true;
  std::optional<Effect> cause = {}; ///< else the seed's: consecutive seeds take the causes in turn
  double lambda = 16.0;
  std::optional<double> size = {}; ///< instead of lambda, with a cause; nothing is foretold then
  int n_packings = 1;              ///< of which the data are the mean
};

/// A laboratory's data of one pressing of a powder that is simulated grain by grain.
struct GrainCase {
  std::uint64_t seed;
  GrainPress press;                         ///< with what is hidden in the grains
  std::string change = {};                  ///< that in words, for the cache
  std::vector<std::uint64_t> packings = {}; ///< of which the data are the mean
  double stiffness = 1.0;                   ///< of grains, cohesion and tools over the sheet's
  Scatter scatter;
  Effects effects; ///< all that is hidden, for machine and sheet
  std::optional<Effect> cause = {};
  double size = 0.0, lambda = 0.0;
  double stated_mass_share = 1.0; ///< stated over true mass
  double stated_bore = 0.0;       ///< [m]
};

/// Packings of data: 20000 + seed n + 0, 1, ... for the mean of n; E and cohesion both within 15 %
/// of the sheet, scales and zeros as they scatter; the effect at the size for the wanted lambda, or
/// its largest. A clean case and a single one of one seed are the same bed.
/// @throws std::invalid_argument if the bed cannot show the cause at half that lambda
GrainCase draw_grain_case(GrainWish const& wish, Foretold const* foretold, Code code);

/// data/ and sealed/truth.json of a case, as `hide` writes them.
/// @throws std::runtime_error if the folder is not empty
void write_grain_case(GrainCase const& of, Simulations const& simulations,
                      std::filesystem::path const& folder);

} // namespace hidden
