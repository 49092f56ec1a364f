#pragma once

#include "coupling/reduced/bed_law.hpp"
#include "coupling/reduced/simulated_cycle.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::reduced {

/// The numbers of a bed law that causes on the grains' side change, by the names of their changes.
inline constexpr std::array<std::string_view, 8> bed_numbers{"ln K", "ln S", "phi_c", "n",
                                                             "r",    "ln p", "mu",    "k"};
using BedNumbers = std::array<double, bed_numbers.size()>;

/// The law with its numbers changed: K exp(change), ..., phi_c + change, ...; nothing falls below
/// 0.
BedLaw changed(BedLaw law, BedNumbers const& changes);

/// What a simulation's cycle needs changed in the law of another one (its tables stay). K, S, phi_c
/// and n trade against each other, and two packings never rearrange alike: of all changes that
/// explain the stress the likeliest, for normal priors of spread 0.1, 0.3, 0.005, 0.05 and
/// rearrangements of 0.3 % of the peak over a sixth of the way. r, p by least squares, mu and k as
/// fit_bed_law has them.
BedNumbers change_of_numbers(BedLaw const& base, SimulatedCycle const& cycle, Bed const& bed);

/// Size and stress of `yielding` and changes of r, ln p that turn an elastic bed's law into a
/// plastic one's; K, S, phi_c, n stay.
struct PlasticChange {
  Yielding yielding;
  double recovery, ln_opening; ///< changes [1]
};
PlasticChange plastic_change(BedLaw const& base, SimulatedCycle const& cycle, Bed const& bed);

/// The same press cycle with one factor low, in the middle and high, from one packing seed.
struct PairedCycles {
  SimulatedCycle low, middle, high;
};

/// What a unit of a factor does to the numbers: mean over packing seeds of
///   (change at high - change at low) / (high - low),
/// and its standard error from the scatter between them.
struct GrainEffect {
  std::string factor;       ///< grain_friction, ...
  std::string measure;      ///< what a unit is of: `friction between grains [1]`, `ln E`
  double low, middle, high; ///< in that measure
  std::size_t n_seeds;
  BedNumbers slope, error;
  double before, after; ///< r.m.s. of upper and lower force at low and high against the middle's
                        ///< law and against it with the effect; share of the peak [1]
};

/// @param factor  name, measure and values; the rest is filled in
/// @throws dem::InvalidInput for fewer than two seeds, or values that do not rise
GrainEffect measure_effect(GrainEffect factor, std::span<PairedCycles const> seeds, Bed const& bed);

} // namespace coupling::reduced
