#include "coupling/study/packing_model.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace coupling::study {
namespace {

/// Fine grains push coarse ones apart.
double loosening(double coarse, double fine) {
  return std::sqrt(1.0 - std::pow(1.0 - fine / coarse, 1.02));
}

/// Fine grains pack loosely beside a coarse one.
double wall_effect(double fine, double coarse) {
  return 1.0 - std::pow(1.0 - fine / coarse, 1.50);
}

/// Virtual packing density if class i is dominant; classes by falling size.
double virtual_density(std::vector<GrainClass> const& classes, std::size_t i) {
  auto const& [size, share, beta] = classes[i];
  double gap = 1.0;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    auto const& other = classes[j];
    if (j < i)
      gap -= (1.0 - beta + wall_effect(size, other.size) * beta * (1.0 - 1.0 / other.packing)) *
             other.share;
    else if (j > i)
      gap -= (1.0 - loosening(size, other.size) * beta / other.packing) * other.share;
  }
  return beta / gap;
}

void validate_classes(std::vector<GrainClass> const& classes, double compaction_index) {
  VALIDATE(!classes.empty(), "packing model: has no grains. Which sizes are mixed?");
  double sum = 0.0;
  for (auto const& [size, share, packing] : classes) {
    VALIDATE(std::isfinite(size) && size > 0.0 && std::isfinite(share) && share >= 0.0 &&
                 packing > 0.0 && packing < 1.0,
             fmt::format("packing model: size = {:g}, share = {:g}, packing = {:g} (sizes above 0, "
                         "shares from 0, packing between 0 and 1). Is a value missing?",
                         size, share, packing));
    sum += share;
  }
  VALIDATE(sum > 0.0,
           "packing model: all shares are 0 (there is nothing to pack). Which are mixed?");
  VALIDATE(
      std::isfinite(compaction_index) && compaction_index > 0.0,
      fmt::format("packing model: compaction index = {:g} (above 0; 9 for vibrated and pressed). "
                  "Which is meant?",
                  compaction_index));
}

} // namespace

double packed_fraction(std::vector<GrainClass> classes, double compaction_index) {
  validate_classes(classes, compaction_index);
  std::erase_if(classes, [](GrainClass const& one) { return one.share == 0.0; });
  std::ranges::stable_sort(classes, std::greater{}, &GrainClass::size);
  double sum = 0.0;
  for (auto const& one : classes)
    sum += one.share;
  for (auto& one : classes)
    one.share /= sum;
  std::vector<double> gamma;
  for (std::size_t i = 0; i < classes.size(); ++i)
    gamma.push_back(virtual_density(classes, i));
  auto const index_at = [&](double phi) {
    double K = 0.0;
    for (std::size_t i = 0; i < classes.size(); ++i)
      K += classes[i].share / classes[i].packing / (1.0 / phi - 1.0 / gamma[i]);
    return K;
  };
  // K rises from 0 to infinity as Phi goes from 0 to the smallest gamma: bisection to the last bit.
  double low = 0.0, high = std::ranges::min(gamma);
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high))
    (index_at(middle) < compaction_index ? low : high) = middle;
  return low;
}

double virtual_packing(double packed_alone, double compaction_index) {
  return packed_alone * (1.0 + compaction_index) / compaction_index;
}

} // namespace coupling::study
