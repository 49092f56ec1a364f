#include "coupling/study/coding.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

void validate_columns(std::vector<FactorRange> const& factors, Eigen::MatrixXd const& table) {
  validate_factors(factors);
  VALIDATE(table.cols() == static_cast<Eigen::Index>(factors.size()),
           fmt::format("coding: has {} columns for {} factors. Is a factor missing?", table.cols(),
                       factors.size()));
}

} // namespace

double FactorRange::to_coded(double natural) const {
  return (2.0 * natural - (low + high)) / (high - low);
}

double FactorRange::to_natural(double coded) const {
  return 0.5 * (low + high) + 0.5 * (high - low) * coded;
}

void validate_factors(std::vector<FactorRange> const& factors) {
  for (std::size_t f = 0; f < factors.size(); ++f) {
    auto const& [name, low, high] = factors[f];
    VALIDATE(!name.empty(), fmt::format("coding: factor {} has no name. What is varied?", f + 1));
    VALIDATE(
        std::isfinite(low) && std::isfinite(high) && low < high,
        fmt::format("coding: {} = {} to {} (low must be below high). Are they the wrong way round?",
                    name, low, high));
    auto const earlier = factors.begin() + static_cast<std::ptrdiff_t>(f);
    VALIDATE(std::find_if(factors.begin(), earlier,
                          [&](FactorRange const& one) { return one.name == factors[f].name; }) ==
                 earlier,
             fmt::format("coding: {} is there twice. Is another factor meant?", name));
  }
}

Eigen::MatrixXd to_coded(std::vector<FactorRange> const& factors, Eigen::MatrixXd const& natural) {
  validate_columns(factors, natural);
  Eigen::MatrixXd coded = natural;
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (double& value : coded.col(static_cast<Eigen::Index>(f)))
      value = factors[f].to_coded(value);
  return coded;
}

Eigen::MatrixXd to_natural(std::vector<FactorRange> const& factors, Eigen::MatrixXd const& coded) {
  validate_columns(factors, coded);
  Eigen::MatrixXd natural = coded;
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (double& value : natural.col(static_cast<Eigen::Index>(f)))
      value = factors[f].to_natural(value);
  return natural;
}

std::vector<std::string> names_of(std::vector<FactorRange> const& factors) {
  std::vector<std::string> names;
  names.reserve(factors.size());
  for (auto const& factor : factors)
    names.push_back(factor.name);
  return names;
}

} // namespace coupling::study
