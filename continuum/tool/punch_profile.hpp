#pragma once

#include "continuum/tool/tool_shape.hpp"

namespace continuum {

/// The face of a punch over the radius.
class PunchProfile {
public:
  /// @throws InvalidInput if a length cannot be built
  explicit PunchProfile(PunchShape const& shape);

  double rim_width() const { return rim_width_; } ///< of bevel or land [m]; 0 if there is none
  /// How far the face stands back from z = 0, into the body, at the radius r [m].
  double depth(double r) const;

private:
  PunchShape shape_;
  double rim_width_ = 0.0;
};

} // namespace continuum
