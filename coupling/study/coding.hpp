#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace coupling::study {

/// A factor of a design and what its coded -1 and 1 mean:
///   coded = (2 natural - (low + high)) / (high - low).
struct FactorRange {
  std::string name; ///< "E"
  double low;       ///< [unit of the factor], coded -1
  double high;      ///< [unit of the factor], coded 1

  double to_coded(double natural) const;
  double to_natural(double coded) const;
};

/// Columns are factors, rows are runs.
/// @throws dem::InvalidInput if a range is empty or not finite, a name is missing or there twice,
/// or the numbers of columns and factors differ
Eigen::MatrixXd to_coded(std::vector<FactorRange> const& factors, Eigen::MatrixXd const& natural);
Eigen::MatrixXd to_natural(std::vector<FactorRange> const& factors, Eigen::MatrixXd const& coded);

std::vector<std::string> names_of(std::vector<FactorRange> const& factors);

/// @throws dem::InvalidInput as above
void validate_factors(std::vector<FactorRange> const& factors);

} // namespace coupling::study
