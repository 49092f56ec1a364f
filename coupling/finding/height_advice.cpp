#include "coupling/finding/height_advice.hpp"

#include "coupling/diagnosis/error_model.hpp"

#include <string>

namespace coupling::finding {
namespace {

using diagnosis::CandidateMeasurement;
using Eigen::Index;
using reduced::Asked;
using reduced::HeightRow;
using reduced::PressedHeight;

struct Proposal {
  std::string name;
  double cost; ///< min
  Asked asked;
  double force_share; ///< of the run's largest force
  double sd;          ///< [m]
};

/// A caliper's 20 um, a gauge's 5 um; travels of a millimetre by the drive's own clock to 20 um.
std::vector<Proposal> const& proposals() {
  static std::vector<Proposal> const all{
      {"travel and force while the press opens, from the largest force to none", 1.0,
       Asked::opening_travel, 1.0, 20e-6},
      {"height of the compact, by caliper", 2.0, Asked::compact_height, 1.0, 20e-6},
      {"height of a compact that is pressed to half the force, less the gap that the machine shows",
       5.0, Asked::height_less_gap, 0.5, 20e-6},
      {"gap that the machine shows where the bare punches touch", 5.0, Asked::blank_zero, 1.0,
       20e-6},
      {"travel from touch to the full force, punch on punch without powder", 10.0,
       Asked::blank_travel, 1.0, 20e-6},
      {"gap between the punches at the largest force, by gauge", 15.0, Asked::gap_at_peak, 1.0,
       5e-6}};
  return all;
}

CandidateMeasurement candidate(Proposal const& proposal, PressedHeight const& of,
                               diagnosis::Parameters const& at,
                               diagnosis::Tolerances const& tolerances) {
  HeightRow row = of.rows().front();
  row.asked = proposal.asked;
  row.force *= proposal.force_share;
  auto const model = of.with_rows({row});
  CandidateMeasurement result{.name = proposal.name, .unit = "m", .cost = proposal.cost};
  result.baseline = model.predict(at);
  // Slopes as finite differences over a tenth of a prior size, where laws are nearly straight.
  constexpr double part = 0.1;
  auto const slope = [&](auto&& move) {
    auto moved = at;
    move(moved);
    return Eigen::VectorXd((model.predict(moved) - result.baseline) / part);
  };
  auto const& calibrated = model.calibrated();
  result.calibrated.resize(1, static_cast<Index>(calibrated.size()));
  for (Index k = 0; k < result.calibrated.cols(); ++k)
    result.calibrated.col(k) = slope([&](diagnosis::Parameters& moved) {
      moved.calibrated[k] += part * calibrated[static_cast<std::size_t>(k)].sd;
    });
  auto const& mechanisms = model.mechanisms();
  result.effects.resize(1, static_cast<Index>(mechanisms.size()));
  for (Index j = 0; j < result.effects.cols(); ++j)
    result.effects.col(j) = slope([&](diagnosis::Parameters& moved) {
      moved.sizes[j] += part * mechanisms[static_cast<std::size_t>(j)].scale;
    });
  diagnosis::Observations const asked({{.run = proposal.name,
                                        .channel = proposal.name,
                                        .phase = diagnosis::Phase::after,
                                        .coordinate = Eigen::VectorXd::Zero(1),
                                        .values = result.baseline}});
  diagnosis::ErrorSources const errors{
      .channels = {{.channel = proposal.name, .sd = proposal.sd, .model_share = 0.0}},
      .tolerances = tolerances};
  result.covariance = error_model(asked, model, errors, at, {}).covariance;
  return result;
}

} // namespace

std::vector<CandidateMeasurement> height_candidates(PressedHeight const& model,
                                                    diagnosis::Parameters const& baseline,
                                                    diagnosis::Tolerances const& tolerances) {
  std::vector<CandidateMeasurement> all;
  for (auto const& proposal : proposals())
    all.push_back(candidate(proposal, model, baseline, tolerances));
  return all;
}

} // namespace coupling::finding
