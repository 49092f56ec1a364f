#pragma once

#include <optional>

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

/// A flat punch about the z axis, face at z = 0; the body of a lower punch is below, of an upper
/// one above.
struct PunchShape {
  double radius; ///< [m], > 0
  double length; ///< [m], > 0
  PunchPlace place = PunchPlace::lower;
};

/// Cells of a punch: a rounded square of around/4 by around/4 cells inside rings.
struct PunchCells {
  int around = 32;     ///< on the rim; a multiple of 8
  int rings = 3;       ///< between the square and the rim
  int along = 8;       ///< over the length
  double growth = 3.0; ///< height of the cell at the back over that at the face
};

/// Counts for cells about `size` [m] wide at the bore, or on the face, and the default growth away
/// from them. A circle gets at least 16 cells, each direction at least 2.
/// @throws InvalidInput if size is not positive
DieCells cells_of_size(DieShape const& shape, double size);
PunchCells cells_of_size(PunchShape const& shape, double size);

} // namespace continuum
