#include "coupling/diagnosis/next_measurement.hpp"

#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace coupling::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void validate(CandidateMeasurement const& one, Fit const& baseline, Index n_mechanisms) {
  auto const n = one.baseline.size(), n_calibrated = baseline.unknowns.size();
  VALIDATE(one.cost > 0.0, fmt::format("{}: costs {:g} (a cost is positive). What does it take?",
                                       one.name, one.cost));
  VALIDATE(n > 0 && static_cast<Index>(one.places.size()) == n && one.calibrated.rows() == n &&
               one.calibrated.cols() == n_calibrated && one.effects.rows() == n &&
               one.effects.cols() == n_mechanisms && one.covariance.rows() == n &&
               one.covariance.cols() == n &&
               (one.shared.size() == 0 ||
                (one.shared.rows() == baseline.residual.size() && one.shared.cols() == n)),
           fmt::format("{}: has {} rows, but places, changes or covariances of other sizes ({} "
                       "calibrated parameters, {} mechanisms). Was it made for this model?",
                       one.name, n, n_calibrated, n_mechanisms));
}

/// The library with the candidate's rows below the measured ones, each given what is measured:
/// with W = shared, changes less W' of those measured, covariance less W' W.
SignatureLibrary widened(SignatureLibrary const& library, Fit const& baseline,
                         CandidateMeasurement const& extra) {
  auto const n = library.tangent.n_rows(), k = extra.baseline.size();
  MatrixXd const W = extra.shared.size() > 0 ? extra.shared : MatrixXd::Zero(n, k);
  Whitener const whitener(extra.covariance - W.transpose() * W, Tolerances{}.largest_jitter);
  auto const below = [&](MatrixXd const& measured, MatrixXd const& own) {
    MatrixXd rows(n + k, measured.cols());
    rows << measured, whitener.whiten(own - W.transpose() * measured);
    return rows;
  };
  SignatureLibrary wide{
      TangentSpace(below(baseline.slopes, extra.calibrated)), library.signatures, {}};
  for (std::size_t j = 0; j < wide.signatures.size(); ++j) {
    auto const& measured = library.signatures[j].whitened;
    MatrixXd const rows =
        below(measured, extra.effects.col(static_cast<Index>(j)).replicate(1, measured.cols()));
    wide.signatures[j].whitened = rows;
    wide.signatures[j].projected = wide.tangent.project(rows);
  }
  return wide;
}

double least_separation(SignatureLibrary const& library,
                        std::vector<PossibleCause> const& possible) {
  double least = no_bound;
  for (auto const& one : possible)
    for (auto const& rival : possible) {
      if (one.mechanism == rival.mechanism)
        continue;
      auto const& own = library.signatures[static_cast<std::size_t>(one.mechanism)];
      least = std::min(
          least, separation(one.fit.at.sizes[one.mechanism] / own.scale * own.projected.col(0),
                            library.signatures[static_cast<std::size_t>(rival.mechanism)]));
    }
  return least;
}

PredictedOutcome outcome_of(CandidateMeasurement const& extra, Fit const& baseline,
                            SignatureLibrary const& library, PossibleCause const& cause) {
  double const u = cause.fit.at.sizes[cause.mechanism] /
                   library.signatures[static_cast<std::size_t>(cause.mechanism)].scale;
  VectorXd const moved = cause.fit.unknowns.head(baseline.unknowns.size()) - baseline.unknowns;
  return {cause.mechanism,
          extra.baseline + extra.calibrated * moved + u * extra.effects.col(cause.mechanism),
          extra.covariance.diagonal().cwiseSqrt()};
}

/// Largest difference between two outcomes in a row, in standard deviations of it.
double contrast(std::vector<PredictedOutcome> const& outcomes, Index row) {
  auto const [low, high] = std::ranges::minmax(
      outcomes, {}, [&](PredictedOutcome const& one) { return one.value[row]; });
  return (high.value[row] - low.value[row]) / low.sd[row];
}

/// Of each channel the row in which the outcomes differ most, channels in the order of their first
/// rows.
std::vector<Index> telling_rows(CandidateMeasurement const& extra,
                                std::vector<PredictedOutcome> const& outcomes) {
  std::vector<Index> rows;
  auto const channel_of = [&](Index row) {
    return extra.places[static_cast<std::size_t>(row)].channel;
  };
  for (Index row = 0; row < extra.baseline.size(); ++row) {
    auto const known = std::ranges::find(rows, channel_of(row), channel_of);
    if (known == rows.end())
      rows.push_back(row);
    else if (contrast(outcomes, row) > contrast(outcomes, *known))
      *known = row;
  }
  return rows;
}

/// Outcomes of all rows cut to the telling ones.
void foretell(CandidateMeasurement const& extra, std::vector<PredictedOutcome> const& outcomes,
              MeasurementAdvice& advice) {
  auto const rows = telling_rows(extra, outcomes);
  for (Index const row : rows)
    advice.readings.push_back(extra.places[static_cast<std::size_t>(row)]);
  for (auto const& one : outcomes)
    advice.outcomes.push_back({one.mechanism, one.value(rows), one.sd(rows)});
}

} // namespace

std::vector<MeasurementAdvice>
next_measurements(Fit const& baseline, SignatureLibrary const& library,
                  std::vector<PossibleCause> const& possible,
                  std::vector<CandidateMeasurement> const& candidates) {
  VALIDATE(
      possible.size() >= 2,
      fmt::format("next measurement: {} causes are possible (two are needed to be told apart). "
                  "Is the verdict undecided?",
                  possible.size()));
  std::vector<MeasurementAdvice> advice;
  for (auto const& one : candidates) {
    validate(one, baseline, static_cast<Index>(library.signatures.size()));
    double const after = least_separation(widened(library, baseline, one), possible);
    advice.push_back({.name = one.name,
                      .cost = one.cost,
                      .before = least_separation(library, possible),
                      .after = after,
                      .is_enough = after >= separable,
                      .readings = {},
                      .outcomes = {}});
    std::vector<PredictedOutcome> outcomes;
    for (auto const& cause : possible)
      outcomes.push_back(outcome_of(one, baseline, library, cause));
    foretell(one, outcomes, advice.back());
  }
  std::ranges::stable_sort(advice, std::greater{}, [](MeasurementAdvice const& one) {
    return std::pair(one.is_enough, one.after / one.cost);
  });
  return advice;
}

} // namespace coupling::diagnosis
