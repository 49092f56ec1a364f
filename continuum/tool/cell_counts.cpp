#include "continuum/tool/punch_profile.hpp"
#include "continuum/tool/shape_checks.hpp"
#include "continuum/tool/tool_shape.hpp"

#include <numbers>

namespace continuum {

namespace {
using std::numbers::pi;

// Cells of a target size at the start of a graded length: the mean is that times (growth + 1) / 2.
int count_for(double length, double size, double growth) {
  return std::max(2, static_cast<int>(std::ceil(length / (size * 0.5 * (1.0 + growth)))));
}

int around_for(double radius, double size, int multiple) {
  int const wanted = static_cast<int>(std::ceil(2.0 * pi * radius / size / multiple)) * multiple;
  return std::max(16, wanted);
}

void validate_size(double size) {
  VALIDATE(std::isfinite(size) && size > 0.0,
           "element size = " + quote(size) + " m (a size is positive). Is the unit missing?");
}
} // namespace

DieCells cells_of_size(DieShape const& shape, double size) {
  validate_size(size);
  DieCells cells;
  cells.around = around_for(shape.bore_radius, size, 4);
  cells.through_wall = count_for(shape.outer_radius - shape.bore_radius, size, cells.growth);
  if (shape.ring_radius)
    cells.through_ring =
        count_for(*shape.ring_radius - shape.outer_radius, size * cells.growth, 1.0);
  cells.along = count_for(shape.height, size, 1.0);
  return cells;
}

PunchCells cells_of_size(PunchShape const& shape, double size) {
  validate_size(size);
  double const rim = PunchProfile(shape).rim_width();
  PunchCells cells;
  cells.around = around_for(shape.radius, size, 8);
  cells.rings = count_for(0.4 * (shape.radius - rim), size, 1.0);
  cells.along = count_for(shape.length, size, cells.growth);
  cells.rim = std::max(1, static_cast<int>(std::ceil(rim / size)));
  return cells;
}

} // namespace continuum
