#include "coupling/diagnosis/unknowns.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double student_df = 4.0;

double from_unit(CalibratedParameter const& one, double u) {
  return one.is_logarithmic ? one.mean * std::exp(one.sd * u) : one.mean + one.sd * u;
}

double to_unit(CalibratedParameter const& one, double value) {
  if (one.is_logarithmic)
    return value > 0.0 ? std::log(value / one.mean) / one.sd : -no_bound;
  return (value - one.mean) / one.sd;
}

} // namespace

Unknowns::Unknowns(Model const& model, std::vector<int> active, SizePriors size_priors)
    : model_(&model), active_(std::move(active)),
      n_calibrated_(static_cast<Index>(model.calibrated().size())) {
  for (auto const& one : model.calibrated())
    append(to_unit(one, one.low), to_unit(one, one.high), Prior::normal);
  for (int const j : active_) {
    VALIDATE(
        j >= 0 && j < static_cast<int>(model.mechanisms().size()) &&
            std::ranges::count(active_, j) == 1,
        fmt::format("hypothesis: names mechanism {} of {} (each at most once). Which causes are "
                    "meant?",
                    j + 1, model.mechanisms().size()));
    auto const& one = model.mechanisms()[static_cast<std::size_t>(j)];
    append((one.is_one_sided ? std::max(0.0, one.low) : one.low) / one.scale, one.high / one.scale,
           size_priors == SizePriors::flat ? Prior::flat
           : one.tail == SizeTail::student ? Prior::student
                                           : Prior::normal);
    for (auto const& shape : one.shapes)
      append((shape.low - shape.mean) / shape.sd, (shape.high - shape.mean) / shape.sd,
             Prior::normal);
  }
}

void Unknowns::append(double low, double high, Prior prior) {
  low_.conservativeResize(low_.size() + 1);
  high_.conservativeResize(high_.size() + 1);
  low_[low_.size() - 1] = low;
  high_[high_.size() - 1] = high;
  priors_.push_back(prior);
}

Index Unknowns::place_of_size(int mechanism) const {
  Index place = n_calibrated_;
  for (int const j : active_) {
    if (j == mechanism)
      return place;
    place +=
        1 + static_cast<Index>(model_->mechanisms()[static_cast<std::size_t>(j)].shapes.size());
  }
  throw dem::InvalidInput(
      fmt::format("hypothesis: mechanism {} is not active. Is another meant?", mechanism + 1));
}

VectorXd Unknowns::out_of(Unknowns const& wider, VectorXd const& u) const {
  VectorXd own(size());
  own.head(n_calibrated_) = u.head(n_calibrated_);
  for (int const j : active_) {
    auto const n =
        1 + static_cast<Index>(model_->mechanisms()[static_cast<std::size_t>(j)].shapes.size());
    own.segment(place_of_size(j), n) = u.segment(wider.place_of_size(j), n);
  }
  return own;
}

Parameters Unknowns::parameters(VectorXd const& u) const {
  Parameters at = nominal_parameters(*model_);
  for (Index p = 0; p < n_calibrated_; ++p)
    at.calibrated[p] = from_unit(model_->calibrated()[static_cast<std::size_t>(p)], u[p]);
  Index place = n_calibrated_;
  for (int const j : active_) {
    auto const& one = model_->mechanisms()[static_cast<std::size_t>(j)];
    at.sizes[j] = one.scale * u[place++];
    for (std::size_t k = 0; k < one.shapes.size(); ++k)
      at.shapes[static_cast<std::size_t>(j)][static_cast<Index>(k)] +=
          one.shapes[k].sd * u[place++];
  }
  return at;
}

VectorXd Unknowns::prior_residual(VectorXd const& u) const {
  VectorXd rho = u;
  for (Index k = 0; k < u.size(); ++k) {
    if (priors_[static_cast<std::size_t>(k)] == Prior::flat)
      rho[k] = 0.0;
    if (priors_[static_cast<std::size_t>(k)] == Prior::student)
      rho[k] =
          std::copysign(std::sqrt((student_df + 1.0) * std::log1p(u[k] * u[k] / student_df)), u[k]);
  }
  return rho;
}

VectorXd Unknowns::prior_slope(VectorXd const& u) const {
  VectorXd const rho = prior_residual(u);
  VectorXd slope = VectorXd::Ones(u.size());
  for (Index k = 0; k < u.size(); ++k) {
    if (priors_[static_cast<std::size_t>(k)] == Prior::flat)
      slope[k] = 0.0;
    if (priors_[static_cast<std::size_t>(k)] == Prior::student)
      slope[k] = std::abs(u[k]) < 1e-6
                     ? std::sqrt((student_df + 1.0) / student_df)
                     : (student_df + 1.0) * u[k] / ((student_df + u[k] * u[k]) * rho[k]);
  }
  return slope;
}

VectorXd Unknowns::prior_curvature(VectorXd const& u) const {
  VectorXd curvature = VectorXd::Ones(u.size());
  for (Index k = 0; k < u.size(); ++k) {
    double const below = student_df + u[k] * u[k];
    if (priors_[static_cast<std::size_t>(k)] == Prior::flat)
      curvature[k] = 0.0;
    if (priors_[static_cast<std::size_t>(k)] == Prior::student)
      curvature[k] = (student_df + 1.0) * (student_df - u[k] * u[k]) / (below * below);
  }
  return curvature;
}

double Unknowns::log_prior_height() const {
  // Gamma(5/2) / (sqrt(4 pi) Gamma(2)) = 3/8
  return static_cast<double>(std::ranges::count(priors_, Prior::student)) *
         std::log(0.375 * std::sqrt(2.0 * std::numbers::pi));
}

} // namespace coupling::diagnosis
