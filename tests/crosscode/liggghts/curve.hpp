#pragma once

#include "coupling/record/press_record.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace crosscode {

/// One instant of a press cycle.
struct CurvePoint {
  double time;        ///< [s]
  double gap;         ///< [m], between the punch faces
  double upper_force; ///< [N], positive in compression
  double lower_force; ///< [N], positive in compression
};

using Curve = std::vector<CurvePoint>;

/// LIGGGHTS' curves.txt (see deck.hpp). @throws std::runtime_error if it is empty
Curve read_peer_curve(std::filesystem::path const& file);

/// The same from the record of our own run.
Curve curve_of(coupling::PressRecord const& record);

/// The curve at given instants, linear between its points. @throws std::runtime_error if it does
/// not reach that far
Curve at_instants(Curve const& curve, std::span<double const> instants);

/// Mean of several curves with the same instants.
Curve mean_of(std::vector<Curve> const& curves);

double peak_force(Curve const& curve);

/// Largest difference of the upper force between curves with the same instants [N].
double largest_difference(Curve const& a, Curve const& b);

} // namespace crosscode
