#pragma once

#include "coupling/elastic/face_locator.hpp"
#include "dem/surface/smooth_surface.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coupling {

/// What the transfer of one window's loads kept, each over the sum of its magnitudes [1].
struct TransferErrors {
  double force = 0.0, moment = 0.0, power = 0.0;
};

/// The surface of an elastic tool that grains press: one set of shape functions both ways,
///   u(x_c) = sum_a N_a(xi_c) u_a,   f_a = sum_c N_a(xi_c) F_c,
/// so that force, moment and power are the same on both sides to rounding.
class ElasticSurface final : public dem::ToolDeformation {
public:
  /// @param trace    the surface in the frame of the FE mesh
  /// @param offset   [m], from there to the tool's own frame
  /// @param patches  of what grains touch, those that stand for the trace
  ElasticSurface(continuum::SurfaceTrace trace, dem::Vec3 const& offset,
                 std::vector<std::uint32_t> patches);
  ElasticSurface(ElasticSurface const&) = delete; // the locator looks into this trace
  ElasticSurface& operator=(ElasticSurface const&) = delete;

  continuum::SurfaceTrace const& trace() const { return trace_; }
  std::size_t n_nodes() const { return static_cast<std::size_t>(trace_.positions.cols()); }

  /// The course of the window that begins: u_a(t) = displacement_a + t velocity_a.
  /// @param length  of the window [s]
  void set_course(Eigen::Matrix3Xd const& displacement, Eigen::Matrix3Xd const& velocity,
                  double length);

  /// Nodal impulses [N s] of those on this tool.
  Eigen::Matrix3Xd nodal(std::span<dem::WallImpulse const> impulses, std::size_t tool) const;

  /// The transfer's errors for these impulses against their nodal form, power with the course.
  TransferErrors errors(std::span<dem::WallImpulse const> impulses, std::size_t tool,
                        Eigen::Matrix3Xd const& nodal) const;

  dem::SurfacePlace locate(std::uint32_t patch, dem::Vec3 const& point) const override;
  Motion at(dem::SurfacePlace const& place) const override;
  double extent() const override { return extent_; }
  double speed() const override { return speed_; }

private:
  continuum::SurfaceTrace trace_;
  FaceLocator locator_;
  dem::Vec3 offset_;
  std::vector<std::uint32_t> patches_; // ascending
  Eigen::Matrix3Xd displacement_, velocity_;
  double extent_ = 0.0, speed_ = 0.0;
};

} // namespace coupling
