#pragma once

#include "continuum/tool/surface_trace.hpp"
#include "dem/surface/tool_deformation.hpp"

#include <memory>
#include <vector>

namespace coupling {

/// The point of a trace that is nearest to a given one.
class FaceLocator {
public:
  /// @param trace  must live as long as the locator
  explicit FaceLocator(continuum::SurfaceTrace const& trace);

  struct Nearest {
    dem::SurfacePlace place;
    double distance; ///< [m]
  };
  /// Gauss-Newton on |x(xi, eta) - p| over [0, 1]^2, on every face that could hold the nearest
  /// point; the one whose centre is nearest is asked first and nearly always suffices.
  Nearest nearest(dem::Vec3 const& point) const;

private:
  Nearest nearest_on(std::uint32_t face, dem::Vec3 const& point) const;

  struct Ball {
    dem::Vec3 centre;
    double radius; ///< [m], around all of the face
  };
  continuum::SurfaceTrace const* trace_;
  std::vector<Ball> balls_; // of each face
};

} // namespace coupling
