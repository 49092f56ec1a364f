#pragma once

#include "coupling/reduced/table.hpp"

#include <optional>
#include <vector>

namespace coupling::reduced {

/// Points of a curve with weights whose sum is 1.
struct WeightedCurve {
  std::vector<double> x, y, weight;
};

/// Weights by the part of the abscissa that a point stands for (half of both gaps beside it), so
/// that records that crowd count no more. @param x  increasing or falling, two or more
WeightedCurve weighted(std::vector<double> x, std::vector<double> y);

/// y = K ((x - c)^n + rest(x - c)) - S (x - c) beyond c, K rest below.
struct LoadingForm {
  double stiffness, cohesion; ///< K > 0, S >= 0, in units of y
  double onset, exponent;     ///< c, n
  Table rest;                 ///< empty: 0

  double at(double x) const;
};

/// What of a LoadingForm is known.
struct LoadingHeld {
  std::optional<double> onset, exponent;
  Table rest;
};

/// Least squares, K and S by linear ones at each c and n (variable projection: Golub, Pereyra, SIAM
/// J. Numer. Anal. 10 (1973) 413).
LoadingForm fit_loading_form(WeightedCurve const& curve, LoadingHeld const& held);

/// y = c g^p + (1 - c) g^q with g = 1 - z / r, nothing at and below g = 0.
struct OpeningForm {
  double recovery;    ///< r
  double share;       ///< c, 0 to 1
  double slow, quick; ///< p < q

  double at_way_left(double g) const;
};

/// @param curve  y over z, 0 at the turn
OpeningForm fit_opening_form(WeightedCurve const& curve);

/// y = shape(g)^power with g = 1 - z / r.
struct Stretch {
  double recovery, power; ///< r, p
};

/// @param shape  y over g
Stretch fit_stretch(WeightedCurve const& curve, Table const& shape);

/// y = e + (1 - e) exp(-z / d).
struct TurnForm {
  double end, length; ///< e, d

  double at(double z) const;
};

/// @param curve  weights may be any
TurnForm fit_turn_form(WeightedCurve const& curve);

} // namespace coupling::reduced
