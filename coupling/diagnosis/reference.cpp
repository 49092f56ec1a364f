#include "coupling/diagnosis/reference.hpp"

#include "coupling/study/distributions.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coupling::diagnosis {
namespace {

constexpr double enough_beyond = 10.0;

} // namespace

Reference::Reference(std::vector<double> draws) : draws_(std::move(draws)) {
  VALIDATE(draws_.size() >= 2, fmt::format("reference: has {} draws (at least 2, usually 999). Is "
                                           "the number meant?",
                                           draws_.size()));
  std::ranges::sort(draws_);
  auto const n = static_cast<double>(draws_.size());
  mean_ = std::accumulate(draws_.begin(), draws_.end(), 0.0) / n;
  double squares = 0.0;
  for (double const one : draws_)
    squares += (one - mean_) * (one - mean_);
  sd_ = std::sqrt(squares / (n - 1.0));
}

double Reference::p(double value) const {
  auto const beyond = draws_.end() - std::ranges::lower_bound(draws_, value);
  return (1.0 + static_cast<double>(beyond)) / (1.0 + static_cast<double>(draws_.size()));
}

double Reference::tail_p(double value) const {
  double const counted = p(value);
  if (counted * (1.0 + static_cast<double>(draws_.size())) > enough_beyond || sd_ == 0.0 ||
      mean_ <= 0.0)
    return counted;
  double const unit = sd_ * sd_ / (2.0 * mean_);
  return std::min(counted, study::chi_squared_p(value / unit, 2.0 * mean_ * mean_ / (sd_ * sd_)));
}

} // namespace coupling::diagnosis
