#include "continuum/verification/field_errors.hpp"

#include <cmath>

namespace continuum::verification {

namespace {
class Ratio {
public:
  void add(double weight, double wrong, double all) {
    wrong_ += weight * wrong;
    all_ += weight * all;
  }
  double root() const { return std::sqrt(wrong_ / all_); }

private:
  double wrong_ = 0.0, all_ = 0.0;
};
} // namespace

FieldErrors errors_of(ElasticTool const& tool, Eigen::Matrix3Xd const& displacement,
                      ExactField const& exact) {
  Ratio of_displacement, of_stress;
  SurfaceTrace const all = tool.mesh().boundary();
  double const off = 0.5 * std::sqrt(0.6);
  for (std::uint32_t face = 0; face < all.faces.size(); ++face)
    for (double const xi : {0.5 - off, 0.5, 0.5 + off})
      for (double const eta : {0.5 - off, 0.5, 0.5 + off}) {
        auto const shape = face_shape(xi, eta);
        Eigen::Vector3d u = Eigen::Vector3d::Zero();
        for (int a = 0; a < 9; ++a)
          u += shape[a] * displacement.col(all.nodes[all.faces[face].nodes[a]]);
        Eigen::Vector3d const known = exact.displacement(all.position(face, xi, eta));
        of_displacement.add(1.0, (u - known).squaredNorm(), known.squaredNorm());
      }
  for (StressPoint const& point : tool.stress_in_cells(displacement)) {
    Eigen::Matrix3d const known = exact.stress(point.position);
    of_stress.add(point.volume, (point.stress - known).squaredNorm(), known.squaredNorm());
  }
  return {of_displacement.root(), of_stress.root()};
}

} // namespace continuum::verification
