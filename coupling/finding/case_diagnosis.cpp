#include "coupling/finding/case_diagnosis.hpp"

#include "coupling/finding/claims.hpp"
#include "coupling/finding/row_inputs.hpp"
#include "coupling/reduced/measurement_catalogue.hpp"

#include <algorithm>
#include <stdexcept>

namespace coupling::finding {
namespace {

using diagnosis::Hypothesis;
using diagnosis::VerdictKind;

reduced::PressModel model_of(CaseQuestion const& question, reduced::MeasuredRows const& rows) {
  auto scatter = repeat_scatter(question.simulated, rows.channels);
  scatter.mass = question.data.sample.mass.sd / question.data.sample.mass.value;
  return {in_laboratory(question.simulated, question.data.sample), question.simulated.sheet,
          scatter, rows.plan};
}

} // namespace

CaseDiagnosis::CaseDiagnosis(CaseQuestion const& question)
    : question_(question), rows_(reduced::measured_rows(question.data, measured::Role::fit)),
      model_(model_of(question, rows_)), observations_(rows_.blocks),
      sources_(error_sources(model_, rows_.channels, question.simulated.fit,
                             uncertainty_of(question.simulated))),
      found_(diagnose(observations_, model_, sources_, question.settings)),
      held_out_(question.data, sources_, question.simulated.fit,
                uncertainty_of(question.simulated)),
      named_(claimed_hypothesis(found_)) {
  if (!can_gain())
    return;
  auto const before = calibrated_press(), after = extended_press(*named_);
  gain_ = scored(before, after);
  held_out_curves_ = held_out_.curves(before, after);
  if (auto const* const wrong = best_wrong_hypothesis(found_))
    placebo_ = scored(before, extended_press(*wrong));
}

FittedPress CaseDiagnosis::calibrated_press() const {
  return {model_, found_.baseline_in_common.at, {}};
}

FittedPress CaseDiagnosis::extended_press(Hypothesis const& by) const {
  return {model_, by.fit.at, by.fit.active};
}

ScoredGain CaseDiagnosis::scored(FittedPress const& before, FittedPress const& after) const {
  auto const runs = held_out_.compared(before, after);
  ScoredGain gain{measure_gain(runs), {}, static_cast<int>(runs.size())};
  for (int const j : after.active)
    gain.causes.push_back(model_.mechanisms()[static_cast<std::size_t>(j)].name);
  return gain;
}

/// A simulated bed with the machine and the sample that a fit found; what the simulation has
/// between its grains is its own.
reduced::Press CaseDiagnosis::in_machine(reduced::SimulatedPress const& simulated,
                                         diagnosis::Parameters const& at) const {
  auto bed = simulated;
  bed.nominal.machine = question_.simulated.nominal.machine;
  auto press = in_laboratory(bed, question_.data.sample);
  auto const& causes = reduced::known_causes();
  for (std::size_t j = 0; j < causes.size(); ++j)
    if (double const size = at.sizes[static_cast<Eigen::Index>(j)];
        causes[j].side == reduced::Side::machine && size != 0.0)
      causes[j].apply(press, size, at.shapes[j]);
  return press;
}

double CaseDiagnosis::effect_shown(std::string_view cause, reduced::SimulatedPress const& without,
                                   reduced::SimulatedPress const& with) const {
  auto const& causes = reduced::known_causes();
  auto const at = std::ranges::find(causes, cause, [](reduced::Cause const& one) {
    return std::string_view(one.mechanism.name);
  });
  auto const j = static_cast<int>(at - causes.begin());
  if (named_ == nullptr || std::ranges::find(named_->fit.active, j) == named_->fit.active.end())
    throw std::out_of_range("effect_shown: the verdict does not name that cause");
  auto off = named_->fit.at;
  off.sizes[j] = 0.0;
  auto const whitened = [&](Eigen::VectorXd const& rows) -> Eigen::VectorXd {
    return found_.comparison.whitener.whiten(rows);
  };
  auto const rows_of = [&](reduced::SimulatedPress const& simulated) {
    return predict_plan(in_machine(simulated, off), rows_.plan);
  };
  Eigen::VectorXd const found = whitened(model_.predict(named_->fit.at) - model_.predict(off));
  return found.dot(whitened(rows_of(with) - rows_of(without))) / found.squaredNorm();
}

FittedPress CaseDiagnosis::recalibrated(reduced::SimulatedPress const& simulated,
                                        diagnosis::Parameters const& at) const {
  std::vector<int> active;
  auto const& causes = reduced::known_causes();
  for (std::size_t j = 0; j < causes.size(); ++j)
    if (causes[j].side == reduced::Side::machine && at.sizes[static_cast<Eigen::Index>(j)] != 0.0)
      active.push_back(static_cast<int>(j));
  reduced::PressModel const model(in_machine(simulated, at), simulated.sheet, model_.scatter(),
                                  rows_.plan);
  auto const errors = error_model(observations_, model, sources_, nominal_parameters(model), {});
  diagnosis::Comparison const comparison{
      &model, observations_.values() - errors.bias,
      diagnosis::Whitener(errors.covariance, sources_.tolerances.largest_jitter)};
  return {model, fit_baseline(comparison).at, active};
}

void CaseDiagnosis::score_simulations(reduced::SimulatedPress const& calibrated,
                                      reduced::SimulatedPress const& extended) {
  auto const before = recalibrated(calibrated, found_.baseline_in_common.at);
  auto const after = recalibrated(extended, named_->fit.at);
  gain_ = scored(before, after);
  gain_->causes.clear();
  for (int const j : named_->fit.active)
    gain_->causes.push_back(model_.mechanisms()[static_cast<std::size_t>(j)].name);
  held_out_curves_ = held_out_.curves(before, after);
}

Finding CaseDiagnosis::finding() const {
  FindingSources parts{.model = model_,
                       .observations = observations_,
                       .errors = sources_,
                       .settings = question_.settings,
                       .gain = gain_,
                       .placebo = placebo_};
  parts.provenance = question_.provenance;
  for (auto const& decision : question_.data.decisions)
    parts.decisions.push_back(in_words(decision));
  parts.decisions.push_back(in_words(question_.simulated.fit));
  parts.decisions.push_back(packings_in_words(question_.simulated));
  for (auto const* const words : {&rows_.left_out, &question_.simulated.fit.statements})
    parts.decisions.insert(parts.decisions.end(), words->begin(), words->end());
  parts.places = places_of(rows_.plan);
  parts.held_out_curves = held_out_curves_;
  auto const& baseline = found_.baseline_in_common;
  if (auto const possible = possible_causes(found_); possible.size() > 1)
    parts.advice = next_measurements(
        baseline, found_.library, possible,
        measurement_catalogue(model_, question_.simulated,
                              {question_.data, rows_, found_.comparison.whitener, found_.sigma_at},
                              baseline.at));
  if (found_.verdict.kind == VerdictKind::unknown || found_.verdict.is_incomplete)
    parts.unexplained = describe_unexplained(
        observations_, found_.comparison, found_.library, found_.tests, baseline.predicted,
        row_inputs(rows_.plan, observations_, baseline.predicted), question_.settings.misfit);
  return finding_of(found_, parts);
}

} // namespace coupling::finding
