#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <span>

namespace dem {

/// An inner cylinder about the press axis: away from the die, and between mean surfaces instead of
/// highest grains.
struct CoreRegion {
  double radius; ///< [m]
  double bottom; ///< [m]
  double top;    ///< [m]

  double volume() const { return pi * radius * radius * (top - bottom); }
};

/// Area common to two circles whose centres are `distance` apart [m^2].
/// Source: Weisstein, "Circle-Circle Intersection", MathWorld, eq. 14.
double circle_overlap_area(double radius_a, double radius_b, double distance);

/// Volume of a sphere inside a core region [m^3]:  integral over z of the area that the sphere's
/// section and the core's circle share; Gauss-Legendre on the smooth pieces, relative error below
/// 1e-4.
double volume_in_core(Vec3 const& centre, double radius, CoreRegion const& core);

/// The core of a compact. Over square columns of `column_width` whose middle is in the core, top
/// and bottom are the highest and the lowest point of any grain in the column; the region's are
/// their means. Columns without grains do not count.
/// @param radius        [m], of the core
/// @param floor         [m], z of the lower punch's face; grains below it do not count
/// @param column_width  [m]; 0: the median diameter of the grains
CoreRegion find_core(Spheres const& grains, double radius, double floor, double column_width = 0.0);

/// Porosity of a core:  1 - (sum of grain volumes in it - sum of overlap lenses in it) / volume.
/// A lens at the region's surface is shared as a sphere of its volume at the contact point would
/// be. 1 where the region is empty.
double core_porosity(Spheres const& grains, ContactStream const& contacts, CoreRegion const& core);

} // namespace dem
