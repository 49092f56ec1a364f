#pragma once

#include "dem/contact/contact.hpp"
#include "dem/spheres.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace dem {

/// A cylinder about the press axis, cut into n_r x n_z rings of equal steps, and the kernel's
/// width.
struct FieldGrid {
  double radius;       ///< [m], of the die
  double bottom;       ///< [m]
  double top;          ///< [m]
  int n_r;             ///< >= 1
  int n_z;             ///< >= 1
  double kernel_width; ///< c [m], where Lucy's kernel ends; at most a quarter of radius and of top
                       ///< - bottom

  std::size_t n_cells() const {
    return static_cast<std::size_t>(n_r) * static_cast<std::size_t>(n_z);
  }
  std::size_t cell(int i_r, int i_z) const { return static_cast<std::size_t>(i_z * n_r + i_r); }
  double cell_volume(int i_r) const; ///< [m^3]
};

/// Fields averaged over the rings, cell(i_r, i_z) by cell. Stress is compression positive, r
/// radial, t about the axis, z axial.
struct Fields {
  std::vector<double> density;        ///< [kg/m^3], of grains and pores
  std::vector<double> solid_fraction; ///< [1], overlap lenses subtracted
  std::vector<double> velocity_r,
      velocity_z; ///< [m/s], momentum over density; 0 where there is none
  std::vector<double> stress_rr, stress_tt, stress_zz,
      stress_rz;             ///< [Pa], of contacts, without the kinetic part
  double mass_outside = 0.0; ///< [kg], of grains whose centre is outside the grid: in no field
};

/// Coarse-grained fields. A grain's mass, momentum and volume are spread about its centre, a
/// contact's stress about the line from its grain's centre to the other's (to the contact point at
/// a tool), with Lucy's kernel
///   W(d) = 105 / (16 pi c^3) (1 + 3 d/c) (1 - d/c)^3,  d < c.
/// Walls: what the kernel throws outside is mirrored back, in z about the punch faces and in r^2
/// about the bore, so mass and stress integrate to their totals to rounding and a uniform bed stays
/// uniform up to the wall. The kernel is a cloud of 160 points (5 Gauss shells of 32 directions), a
/// branch 2 Gauss points each c of its length. Source: Goldhirsch, Granul. Matter 12 (2010) 239,
/// eqs 12 and 27; Lucy, Astron. J. 82 (1977) 1013.
/// @throws InvalidInput if the grid has no room or the kernel is too wide
Fields coarse_grain(Spheres const& grains, ContactStream const& contacts, FieldGrid const& grid);

} // namespace dem
