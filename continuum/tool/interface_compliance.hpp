#pragma once

#include "continuum/tool/elastic_tool.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <string>

namespace continuum {

/// A tool condensed once onto the nodes of one surface, exactly:  u_s = C f_s,  C = P K^-1 P^T.
/// C is symmetric and positive definite on the components that the supports leave free; rows and
/// columns of held ones are zero. The displacement inside follows from ElasticTool::solve with the
/// same forces.
class InterfaceCompliance {
public:
  /// By the Schur complement S of K on the surface: C = S^-1.
  static InterfaceCompliance condense(ElasticTool const& tool, std::string const& surface);

  /// What identifies the operator: mesh, materials, supports and surface.
  static std::uint64_t key(ElasticTool const& tool, std::string const& surface);

  /// Reads the operator from `folder` if it is there, else condenses and writes it; the file's name
  /// carries the key.
  static InterfaceCompliance cached(ElasticTool const& tool, std::string const& surface,
                                    std::filesystem::path const& folder);

  /// HDF5, to a temporary name first: a file of the final name is complete.
  /// @throws InvalidInput if it cannot be written
  void save(std::filesystem::path const& file) const;
  /// The operator to the bit.
  /// @throws InvalidInput if the file is missing, damaged, of another kind or of another key
  static InterfaceCompliance load(std::filesystem::path const& file, std::uint64_t key);

  /// @param forces  [N], 3 x nodes of the surface's trace
  /// @return        displacement [m] of the same nodes
  Eigen::Matrix3Xd displacement(Eigen::Matrix3Xd const& forces) const;

  Eigen::MatrixXd const& matrix() const { return matrix_; } ///< [m/N], component 3 a + c
  std::uint64_t key() const { return key_; }

private:
  InterfaceCompliance(Eigen::MatrixXd matrix, std::uint64_t key);
  Eigen::MatrixXd matrix_;
  std::uint64_t key_;
};

} // namespace continuum
