#include "continuum/tool/rigid_motion.hpp"

#include "continuum/expect.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <string>

namespace continuum {

namespace {
using Motion = Eigen::Matrix<double, 6, 1>;

// The rigid motion's share in one component: three translations, three rotations about the middle.
Motion row(Eigen::Vector3d const& arm, int component) {
  Motion values = Motion::Zero();
  values[component] = 1.0;
  for (int axis = 0; axis < 3; ++axis)
    values[3 + axis] = Eigen::Vector3d::Unit(axis).cross(arm)[component];
  return values;
}

std::string name_of(Motion const& motion) {
  Eigen::Index largest = 0;
  motion.cwiseAbs().maxCoeff(&largest);
  return std::string(largest < 3 ? "shift along " : "turn about ") + "xyz"[largest % 3];
}
} // namespace

void refuse_mechanism(Eigen::Matrix3Xd const& nodes, std::vector<bool> const& held) {
  Eigen::Vector3d const middle = nodes.rowwise().mean();
  double const size = (nodes.colwise() - middle).colwise().norm().maxCoeff();
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  std::size_t n_held = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i]) {
      Motion const values = row((nodes.col(i / 3) - middle) / size, i % 3);
      normal += values * values.transpose();
      ++n_held;
    }
  VALIDATE(n_held > 0, "the tool has no support (any load would move it away). Clamp a surface?");
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> const modes(normal);
  VALIDATE(modes.eigenvalues()[0] > 1e-10 * modes.eigenvalues()[5],
           "the supports leave the tool free to " + name_of(modes.eigenvectors().col(0)) +
               " (a mechanism has no static solution). Clamp a surface, or add pins in the plane?");
}

} // namespace continuum
