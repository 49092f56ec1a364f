#pragma once

#include "coupling/reduced/bed_law.hpp"
#include "coupling/reduced/simulated_cycle.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coupling::reduced {

struct BedFitOptions {
  std::optional<double> onset;    ///< phi_c that is not fitted [1]
  std::optional<double> exponent; ///< n that is not fitted [1]
  std::optional<BedLaw> shape;    ///< its tables are taken as they are, only numbers are fitted:
                                  ///< what a cause does to the numbers of a known bed
};

/// A force of the law against the records', both in shares of the largest upper force.
struct Departure {
  double rms = 0.0, largest = 0.0; ///< [1]
};

/// A law against a cycle; records in which neither force bears do not count.
struct BedDepartures {
  Departure loading_upper, loading_lower;
  Departure unloading_upper, unloading_lower; ///< zero without unloading
};
BedDepartures departures(BedLaw const& law, SimulatedCycle const& cycle, Bed const& bed);

/// A bed law that stands for a simulated cycle, and how well it does, with its tables.
struct BedFit : BedDepartures {
  BedLaw law;
  std::size_t n_loading = 0, n_unloading = 0;    ///< records that were used
  double loading_form = 0.0, opening_form = 0.0; ///< r.m.s. of s that the formulas (with `shape`:
                                                 ///< its curves) miss, share of the largest [1]
  std::vector<std::string> statements;           ///< what could not be found, in words
};

/// The law of a simulated cycle. Numbers by least squares, each record weighed with the solid
/// fraction that it stands for:
///   K, S (linear), phi_c, n    s of first loading
///   c (linear), r, a, b        s / s_m = c g^a + (1 - c) g^b of unloading; p = 1
///   r, p                       with `shape`
///   k, mu                      sum of p / sum of s and sum of W / sum of p pi D h in loading
///   d, t_end (linear)          W / (mu p pi D h) = t_end + (1 - t_end) exp(-(h - h_m) / d)
/// The tables hold these formulas plus what they miss, as means over groups of neighbouring
/// records. Without unloading, or if it ends above a third of the largest stress, the tables of
/// unloading stay empty (or those of `shape`) and `statements` says so.
/// @throws dem::InvalidInput for records that make no cycle, dem::PhysicsGuard if a search fails
BedFit fit_bed_law(SimulatedCycle const& cycle, Bed const& bed, BedFitOptions const& options = {});

} // namespace coupling::reduced
