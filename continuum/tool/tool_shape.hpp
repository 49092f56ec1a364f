#pragma once

#include <optional>
#include <variant>

namespace continuum {

/// A cylindrical die about the z axis, bottom at z = 0; with `ring_radius` a second region (a
/// shrink-fit ring, bonded) reaches from `outer_radius` to it.
struct DieShape {
  double bore_radius;                     ///< [m], > 0
  double outer_radius;                    ///< [m], > bore_radius
  double height;                          ///< [m], > 0
  std::optional<double> ring_radius = {}; ///< [m], > outer_radius
};

/// Cells of a die. Sizes grow geometrically from the bore to the outside.
struct DieCells {
  int around = 32;      ///< a multiple of 4
  int through_wall = 4; ///< between bore and outer radius
  int through_ring = 2; ///< between outer and ring radius, if there is a ring
  int along = 12;       ///< over the height
  double growth = 3.0;  ///< thickness of the last cell of the wall over that of the first
};

enum class PunchPlace { lower, upper };

struct FlatFace {};

/// A flat land in the middle, at z = 0, and a cone from it to the rim.
struct BevelledFace {
  double width; ///< of the bevel, along the radius [m], in (0, radius)
  double depth; ///< [m]: the rim stands back from the powder by it, > 0, or into the powder, < 0,
                ///< which gives the compact a chamfer; the magnitude is below the punch's length
};

/// A spherical cup inside a flat land at the rim, which is at z = 0. Depth is measured from the
/// land to the deepest point, as tabletting does.
struct ConcaveFace {
  double depth;      ///< [m], in (0, opening radius), and below the punch's length
  double land = 0.0; ///< width of the land [m], in [0, radius); the opening radius is what is left

  /// Radius of the sphere [m]:  (c^2 + depth^2) / (2 depth),  c = punch_radius - land.
  double sphere_radius(double punch_radius) const {
    double const opening = punch_radius - land;
    return (opening * opening + depth * depth) / (2.0 * depth);
  }
};

/// A punch about the z axis, face at z = 0 as far as it is flat; the body of a lower punch is
/// below, of an upper one above.
struct PunchShape {
  double radius; ///< [m], > 0
  double length; ///< from z = 0 to the back [m], > 0
  PunchPlace place = PunchPlace::lower;
  std::variant<FlatFace, BevelledFace, ConcaveFace> face = FlatFace{};
};

/// Cells of a punch: a rounded square of around/4 by around/4 cells inside rings.
struct PunchCells {
  int around = 32;     ///< on the rim; a multiple of 8
  int rings = 3;       ///< between the square and the rim, or the inner edge of bevel or land
  int along = 8;       ///< over the length
  double growth = 3.0; ///< height of the cell at the back over that at the face
  int rim = 2;         ///< rings of the bevel or the land, if there is one
};

/// Counts for cells about `size` [m] wide at the bore, or on the face, and the default growth away
/// from them. A circle gets at least 16 cells, each direction at least 2, bevel and land one.
/// @throws InvalidInput if size is not positive
DieCells cells_of_size(DieShape const& shape, double size);
PunchCells cells_of_size(PunchShape const& shape, double size);

} // namespace continuum
