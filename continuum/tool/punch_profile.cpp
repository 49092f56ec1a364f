#include "continuum/tool/punch_profile.hpp"

#include "continuum/tool/shape_checks.hpp"

namespace continuum {

namespace {
void validate_bevel(PunchShape const& shape, BevelledFace const& face) {
  VALIDATE(face.width > 0.0 && face.width < shape.radius,
           "punch: bevel width = " + quote(face.width) +
               " m is not between 0 and the radius = " + quote(shape.radius) +
               " m (a flat land must be left in the middle). Is the unit right?");
  VALIDATE(face.depth != 0.0 && std::abs(face.depth) < shape.length,
           "punch: bevel depth = " + quote(face.depth) +
               " m (neither zero nor as large as the length = " + quote(shape.length) +
               " m). Take a flat face instead of a bevel without depth?");
}

void validate_cup(PunchShape const& shape, ConcaveFace const& face) {
  VALIDATE(face.land >= 0.0 && face.land < shape.radius,
           "punch: land = " + quote(face.land) + " m is not between 0 and the radius = " +
               quote(shape.radius) + " m (no cup is left inside). Is the unit right?");
  double const opening = shape.radius - face.land;
  VALIDATE(face.depth > 0.0 && face.depth < opening,
           "punch: cup depth = " + quote(face.depth) +
               " m is not between 0 and the opening radius = " + quote(opening) +
               " m (a deeper cup than a hemisphere would overhang). Is it misspelt?");
  VALIDATE(face.depth < shape.length,
           "punch: cup depth = " + quote(face.depth) + " m reaches the back at " +
               quote(shape.length) + " m (no metal is left under the cup). Make the punch longer?");
}
} // namespace

PunchProfile::PunchProfile(PunchShape const& shape) : shape_(shape) {
  validate_length("punch: radius", shape.radius);
  validate_length("punch: length", shape.length);
  if (auto const* bevel = std::get_if<BevelledFace>(&shape.face)) {
    validate_bevel(shape, *bevel);
    rim_width_ = bevel->width;
  } else if (auto const* cup = std::get_if<ConcaveFace>(&shape.face)) {
    validate_cup(shape, *cup);
    rim_width_ = cup->land;
  }
}

double PunchProfile::depth(double r) const {
  double const inner = shape_.radius - rim_width_;
  if (auto const* bevel = std::get_if<BevelledFace>(&shape_.face))
    return r <= inner ? 0.0 : bevel->depth * (r - inner) / bevel->width;
  if (auto const* cup = std::get_if<ConcaveFace>(&shape_.face)) {
    double const sphere = cup->sphere_radius(shape_.radius);
    // Under the land, sqrt(S^2 - r^2) - (S - depth): as a quotient it loses no digits where the
    // cup ends.
    double const root = std::sqrt(std::max(0.0, sphere * sphere - r * r));
    return r >= inner ? 0.0 : (inner - r) * (inner + r) / (root + sphere - cup->depth);
  }
  return 0.0;
}

} // namespace continuum
