#pragma once

#include "coupling/study/response_surface.hpp"

namespace coupling::study {

struct SurfaceExtremes {
  double lowest, highest;                ///< [unit of the response]
  Eigen::VectorXd lowest_at, highest_at; ///< coded
};

/// The least and the largest value of a surface over a box, exactly: on each of the 3^k faces (the
/// inside, sides, edges, corners) where its gradient along the face vanishes.
/// @param low, high  [1], coded; low <= high. Equal where a factor is held.
/// @throws dem::InvalidInput for more than ten factors
SurfaceExtremes extremes_of(ResponseSurface const& surface, Eigen::VectorXd const& low,
                            Eigen::VectorXd const& high);

} // namespace coupling::study
