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
  std::vector<Asked> asked;
  double force_share; ///< of the run's largest force
  double sd;          ///< [m]
};

/// A caliper's 20 um, a gauge's 5 um; travels of a millimetre by the drive's own clock to 20 um. A
/// frame shows in the travel of bare punches and a zero in the gap at their touch: seeing one alone
/// leaves the other to what was measured before.
std::vector<Proposal> const& proposals() {
  static std::vector<Proposal> const all{
      {"travel and force while the press opens, from the largest force to none",
       1.0,
       {Asked::opening_travel},
       1.0,
       20e-6},
      {"height of the compact, by caliper", 2.0, {Asked::compact_height}, 1.0, 20e-6},
      {"height of a compact that is pressed to half the force, less the gap that the machine shows",
       5.0,
       {Asked::height_less_gap},
       0.5,
       20e-6},
      {"punch on punch without powder: gap that the machine shows at the touch, and travel from "
       "there to the full force",
       10.0,
       {Asked::blank_zero, Asked::blank_travel},
       1.0,
       20e-6},
      {"gap between the punches at the largest force, by gauge",
       15.0,
       {Asked::gap_at_peak},
       1.0,
       5e-6}};
  return all;
}

std::string channel_of(Asked asked) {
  switch (asked) {
  case Asked::compact_height:
    return "compact_height";
  case Asked::porosity:
    return "porosity";
  case Asked::height_less_gap:
    return "compact_height_less_gap";
  case Asked::gap_at_peak:
    return "gap_at_peak";
  case Asked::blank_travel:
    return "travel_from_touch";
  case Asked::blank_zero:
    return "gap_at_touch";
  case Asked::opening_travel:
    return "travel_of_opening";
  }
  return "";
}

std::vector<diagnosis::ReadingPlace> places_of(Proposal const& proposal,
                                               std::vector<HeightRow> const& rows) {
  std::vector<diagnosis::ReadingPlace> places;
  for (std::size_t k = 0; k < rows.size(); ++k)
    places.push_back({.channel = channel_of(proposal.asked[k]),
                      .unit = "m",
                      .phase = diagnosis::Phase::after,
                      .gap = rows[k].gap});
  return places;
}

/// Each number a channel of its own.
diagnosis::Observations observations_of(Proposal const& proposal, Eigen::VectorXd const& values,
                                        diagnosis::ErrorSources& errors) {
  std::vector<diagnosis::ChannelBlock> blocks;
  for (Index k = 0; k < values.size(); ++k) {
    auto const channel = channel_of(proposal.asked[static_cast<std::size_t>(k)]);
    blocks.push_back({.run = proposal.name,
                      .channel = channel,
                      .phase = diagnosis::Phase::after,
                      .coordinate = Eigen::VectorXd::Zero(1),
                      .values = values.segment(k, 1)});
    errors.channels.push_back({.channel = channel, .sd = proposal.sd, .model_share = 0.0});
  }
  return diagnosis::Observations(std::move(blocks));
}

CandidateMeasurement candidate(Proposal const& proposal, PressedHeight const& of,
                               diagnosis::Parameters const& at,
                               diagnosis::Tolerances const& tolerances) {
  std::vector<HeightRow> rows(proposal.asked.size(), of.rows().front());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].asked = proposal.asked[k], rows[k].force *= proposal.force_share;
  auto const model = of.with_rows(rows);
  CandidateMeasurement result{
      .name = proposal.name, .cost = proposal.cost, .places = places_of(proposal, rows)};
  result.baseline = model.predict(at);
  // Slopes as finite differences over a tenth of a prior size, where laws are nearly straight.
  constexpr double part = 0.1;
  auto const slope = [&](auto&& move) {
    auto moved = at;
    move(moved);
    return Eigen::VectorXd((model.predict(moved) - result.baseline) / part);
  };
  auto const& calibrated = model.calibrated();
  result.calibrated.resize(result.baseline.size(), static_cast<Index>(calibrated.size()));
  for (Index k = 0; k < result.calibrated.cols(); ++k)
    result.calibrated.col(k) = slope([&](diagnosis::Parameters& moved) {
      moved.calibrated[k] += part * calibrated[static_cast<std::size_t>(k)].sd;
    });
  auto const& mechanisms = model.mechanisms();
  result.effects.resize(result.baseline.size(), static_cast<Index>(mechanisms.size()));
  for (Index j = 0; j < result.effects.cols(); ++j)
    result.effects.col(j) = slope([&](diagnosis::Parameters& moved) {
      moved.sizes[j] += part * mechanisms[static_cast<std::size_t>(j)].scale;
    });
  diagnosis::ErrorSources errors{.channels = {}, .tolerances = tolerances};
  auto const asked = observations_of(proposal, result.baseline, errors);
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
