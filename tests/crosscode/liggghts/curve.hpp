#pragma once

#include "coupling/record/press_record.hpp"

#include <filesystem>
#include <vector>

namespace crosscode {

/// One instant of a press cycle.
struct CurvePoint {
  double time;         ///< [s]
  double gap;          ///< [m], between the punch faces
  double upper_force;  ///< [N], positive in compression
  double lower_force;  ///< [N], positive in compression
};

using Curve = std::vector<CurvePoint>;

/// LIGGGHTS' curves.txt (see deck.hpp). @throws std::runtime_error if it is empty
Curve read_peer_curve(std::filesystem::path const& file);

/// The same from the record of our own run.
Curve curve_of(coupling::PressRecord const& record);

/// Mean of several curves with the same instants.
Curve mean_of(std::vector<Curve> const& curves);

double peak_force(Curve const& curve);

/// Largest difference of the upper force at the instants of `a`, `b` interpolated linearly in time [N].
/// Instants outside the time of `b` do not count.
double largest_difference(Curve const& a, Curve const& b);

}  // namespace crosscode
