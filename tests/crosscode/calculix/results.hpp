#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace crosscode {

/// What the peer prints (.dat).
struct CalculixResults {
  std::map<unsigned, Eigen::Vector3d> displacement; ///< [m], of the deck's node numbers
  /// Of the deck's element numbers: place [m] and stress [Pa] of each integration point.
  std::map<unsigned, std::vector<std::pair<Eigen::Vector3d, Eigen::Matrix3d>>> stress;
};

/// @throws std::runtime_error if the file is missing, or has no displacements, stresses or places
CalculixResults read_results(std::filesystem::path const& file);

} // namespace crosscode
