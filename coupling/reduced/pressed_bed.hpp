#pragma once

#include "coupling/reduced/bed_law.hpp"

namespace coupling::reduced {

/// How stress goes with the speed of pressing: every e-fold of strain rate adds the share a,
///   s = s_0 (1 + a L),   L = ln(1 + e / e_0)
/// with e the rate of strain while the bed closes. In a dwell of the time t the rate that is left
/// is that of a memory m, e = 1 / (1/e_closing + t/m): a relaxation that goes with ln t. As the bed
/// opens L turns to -ln(1 + e_opening / e_0), over the length that the opening takes to forget.
struct RateLaw {
  double gain = 0.0;       ///< a [1]
  double reference = 1e-4; ///< e_0 [1/s], below which speed does not matter
  double memory = 4e-3;    ///< m [1], strain
  double turning = 1.5e-4; ///< [m], of opening
};

/// Where in the cycle a moment is, for what hangs on time.
struct PressMoment {
  double closing_speed = 0.0; ///< [m/s], >= 0, the last one
  double dwelt = 0.0;         ///< [s], since the closing ended
  double opening_speed = 0.0; ///< [m/s], 0 before the bed opens
  double opened = 0.0;        ///< [m], command above its lowest
};

/// A bed between tools that may stand askew and give way.
struct PressedBed {
  BedLaw law;
  Bed bed;
  double tilt = 0.0;      ///< [m], of the upper punch's face across the bore
  double die_yield = 0.0; ///< [m/Pa], that the bore's diameter grows with the radial pressure
  RateLaw rate = {};
};

/// s / s_0 at a moment, the bed being `height` high.
double rate_factor(RateLaw const& law, PressMoment const& moment, double height);

/// Forces at the height h in the middle when the smallest height so far is h_m <= h.
/// Tilt: the mean over the face, each strip pressed on its own: a disc's mean over x = cos(theta)
/// by Gauss-Chebyshev points of the second kind. Die: the powder fills the bore D + a p, at the
/// turn as at h, by rounds of substitution; the punches' faces stay as wide as D.
BedForces forces(PressedBed const& pressed, double height, double smallest_height,
                 PressMoment const& moment = {});

/// The height that the bed would have with the solid fraction of its turn in a die that had not
/// given way [m].
double narrow_height(PressedBed const& pressed, double smallest_height);

} // namespace coupling::reduced
