#include "coupling/diagnosis/error_terms.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void validate(ChannelError const& one) {
  VALIDATE(one.sd >= 0.0 && one.sd_relative >= 0.0 && one.sd + one.sd_relative > 0.0,
           fmt::format("{}: has sd {:g} and relative sd {:g} (data without uncertainty cannot be "
                       "weighed). What does the calibration sheet say?",
                       one.channel, one.sd, one.sd_relative));
  VALIDATE(
      one.correlation >= 0.0 && one.correlation < 1.0,
      fmt::format("{}: neighbouring rows have the correlation {:g} (it lies in 0 to 1). Was it "
                  "taken from the hold?",
                  one.channel, one.correlation));
}

} // namespace

std::vector<ChannelError> errors_of_blocks(Observations const& observations,
                                           std::vector<ChannelError> const& channels) {
  std::vector<ChannelError> of_blocks;
  for (auto const& one : channels)
    validate(one);
  for (auto const& block : observations.blocks()) {
    auto const count = std::ranges::count(channels, block.channel, &ChannelError::channel);
    VALIDATE(count == 1, fmt::format("{}: the channel has {} statements of its error (one is "
                                     "needed). What is its sensor's sd?",
                                     label_of(block), count));
    of_blocks.push_back(*std::ranges::find(channels, block.channel, &ChannelError::channel));
  }
  return of_blocks;
}

MatrixXd sensor_covariance(Observations const& observations,
                           std::vector<ChannelError> const& of_blocks, VectorXd const& predicted) {
  MatrixXd sum = MatrixXd::Zero(observations.size(), observations.size());
  for (std::size_t b = 0; b < of_blocks.size(); ++b) {
    auto const [first, n] = observations.rows()[b];
    auto const& error = of_blocks[b];
    auto const& block = observations.blocks()[b];
    VectorXd sd =
        (error.sd * error.sd + (error.sd_relative * predicted.segment(first, n).array()).square())
            .sqrt() /
        std::sqrt(block.n_repeats);
    if (block.n_readings.size() > 0)
      sd.array() /= block.n_readings.array().sqrt();
    for (Index i = 0; i < n; ++i)
      for (Index k = 0; k < n; ++k)
        sum(first + i, first + k) =
            sd[i] * sd[k] * std::pow(error.correlation, static_cast<double>(std::abs(i - k)));
  }
  return sum;
}

MatrixXd repeatability_covariance(Observations const& observations, MatrixXd const& changes) {
  MatrixXd sum = MatrixXd::Zero(observations.size(), observations.size());
  auto const& blocks = observations.blocks();
  for (std::size_t a = 0; a < blocks.size(); ++a)
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (blocks[a].run != blocks[b].run)
        continue;
      auto const [i, n] = observations.rows()[a];
      auto const [k, m] = observations.rows()[b];
      sum.block(i, k, n, m) = changes.middleRows(i, n) * changes.middleRows(k, m).transpose() /
                              std::sqrt(1.0 * blocks[a].n_repeats * blocks[b].n_repeats);
    }
  return sum;
}

MatrixXd numerical_covariance(NumericalError const& numerical, double bias_share, Index n_rows) {
  auto const& [bias, covariance] = numerical;
  VALIDATE(
      (bias.size() == 0 || bias.size() == n_rows) &&
          (covariance.size() == 0 || (covariance.rows() == n_rows && covariance.cols() == n_rows)),
      fmt::format("numerical error: has {} biases and a {} x {} covariance for {} rows. Was the "
                  "refinement series sampled where the data are?",
                  bias.size(), covariance.rows(), covariance.cols(), n_rows));
  MatrixXd sum = covariance.size() > 0 ? covariance : MatrixXd::Zero(n_rows, n_rows);
  if (bias.size() > 0)
    sum += bias_share * bias_share * bias * bias.transpose();
  return sum;
}

double matern_3_2(double distance, double length) {
  double const x = std::sqrt(3.0) * distance / length;
  return (1.0 + x) * std::exp(-x);
}

MatrixXd smooth_covariance(Observations const& observations, VectorXd const& sd,
                           Tolerances const& tolerances) {
  MatrixXd sum = MatrixXd::Zero(observations.size(), observations.size());
  auto const& blocks = observations.blocks();
  for (std::size_t a = 0; a < blocks.size(); ++a)
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (blocks[a].channel != blocks[b].channel || blocks[a].phase != blocks[b].phase)
        continue;
      double const c = blocks[a].run == blocks[b].run ? 1.0 : tolerances.run_correlation;
      auto const [i, n] = observations.rows()[a];
      auto const [k, m] = observations.rows()[b];
      for (Index r = 0; r < n; ++r)
        for (Index q = 0; q < m; ++q)
          sum(i + r, k + q) =
              c * sd[i + r] * sd[k + q] *
              matern_3_2(std::abs(blocks[a].coordinate[r] - blocks[b].coordinate[q]),
                         tolerances.phase_length);
    }
  return sum;
}

VectorXd tolerance_sd(Observations const& observations, std::vector<ChannelError> const& of_blocks,
                      VectorXd const& predicted, Tolerances const& tolerances) {
  VectorXd sd = predicted.cwiseAbs();
  for (std::size_t b = 0; b < of_blocks.size(); ++b)
    sd.segment(observations.rows()[b].first, observations.rows()[b].n) *=
        of_blocks[b].model_share.value_or(tolerances.model_share);
  return sd;
}

VectorXd kink_sd(Observations const& observations, std::vector<ChannelError> const& of_blocks,
                 VectorXd const& predicted, Tolerances const& tolerances) {
  VectorXd sd = VectorXd::Zero(observations.size());
  auto const& blocks = observations.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!of_blocks[b].has_kink)
      continue;
    double largest = 0.0;
    for (std::size_t a = 0; a < blocks.size(); ++a)
      if (blocks[a].run == blocks[b].run && blocks[a].channel == blocks[b].channel)
        largest = std::max(largest,
                           predicted.segment(observations.rows()[a].first, observations.rows()[a].n)
                               .cwiseAbs()
                               .maxCoeff());
    if (largest <= 0.0)
      continue;
    auto const [first, n] = observations.rows()[b];
    sd.segment(first, n) =
        tolerances.kink_share * largest *
        (-predicted.segment(first, n).array().abs() / (tolerances.kink_decay * largest)).exp();
  }
  return sd;
}

} // namespace coupling::diagnosis
