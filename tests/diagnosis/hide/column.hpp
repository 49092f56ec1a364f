#pragma once

#include "tests/diagnosis/hide/powder.hpp"

#include <array>

namespace hidden {

constexpr int n_slices = 24;

/// One slice of the bed, all slices of the same mass.
struct Slice {
  double largest = 0.0;            ///< largest axial stress so far [Pa]
  double densest = 0.0;            ///< solid fraction there [1]
  double stress = 0.0;             ///< axial, in the middle [Pa]
  double centre = 0.0;             ///< above the lower punch [m]
  double height = 0.0;             ///< [m]
  double shear = 0.0;              ///< of the wall on the powder, upwards [Pa]
  double above = 0.0, below = 0.0; ///< axial force on its faces [N]
};

/// What the tools feel.
struct ColumnForces {
  double upper = 0.0, lower = 0.0;              ///< [N]
  double radial_top = 0.0, radial_bottom = 0.0; ///< [Pa], gauges a quarter of the height long
};

/// A bed between the punches, in slices. Forces hand on from slice to slice,
///   F_below = F_above - shear pi D h,   |shear| <= mu p,
/// with a wall layer that shears elastically before it slides: friction turns round slice by slice,
/// those near the moving punch first.
class Column {
public:
  /// @param mass  of powder [kg]; @param die_yield  of the diameter [m/Pa]
  Column(BedLaw const& law, double mass, double wall_stiffness, double die_yield);

  /// Forces with the upper punch at `height` [m] in a die of `bore` [m]; keeps nothing.
  ColumnForces tried(double height, double bore) const;
  /// The same, and keeps the slices as they are then.
  ColumnForces press(double height, double bore);
  /// Force that pushes the free column out [N]. 1.1: at rest friction is higher.
  double ejection_force(double bore) const;
  /// Height of the compact outside the die [m].
  double free_height(double bore) const;

  std::array<Slice, n_slices> const& slices() const { return slices_; }
  double solid_volume() const { return volume_; }

private:
  std::array<Slice, n_slices> marched(double top_stress, double top, double bore) const;
  std::array<Slice, n_slices> balanced(double height, double bore) const;
  Slice next(Slice const& old, double depth, double force, double top, double bore) const;
  ColumnForces forces_of(std::array<Slice, n_slices> const& slices) const;

  BedLaw law_;
  double volume_, wall_stiffness_, die_yield_;
  std::array<Slice, n_slices> slices_;
  bool is_touched_ = false;
};

} // namespace hidden
