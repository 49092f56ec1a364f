#include "coupling/finding/height_diagnosis.hpp"

#include "coupling/finding/claims.hpp"
#include "coupling/finding/finding_of.hpp"
#include "coupling/finding/height_advice.hpp"
#include "coupling/finding/height_words.hpp"
#include "coupling/reduced/simulated_press.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling::finding {
namespace {

reduced::PressedHeight model_of(Case const& setup, measured::MeasuredData const& data,
                                reduced::HeightRows const& rows) {
  auto const& sample = data.sample;
  double const of_case = 1.0 / reduced::specific_volume(setup.powder);
  auto const density = sample.solid_density.value_or(
      measured::Uncertain{of_case, reduced::solid_density_share * of_case});
  double const bore = sample.die_diameter.value;
  reduced::Press nominal;
  nominal.solid_density = density.value;
  nominal.pressed.bed = {.solid_area =
                             sample.mass.value / density.value / (0.25 * dem::pi * bore * bore),
                         .bore = bore};
  nominal.machine = {.frame = setup.frame, .load_cell = setup.load_cell};
  auto const run = std::ranges::find(data.runs, measured::Role::fit, &measured::Run::role);
  return {{.nominal = std::move(nominal),
           .solid_density = density,
           .gap_sd = data.channel("punch_gap")->sd,
           .mass_sd = sample.mass.sd / sample.mass.value,
           .stroke = run->press.fill_height - run->press.end_gap,
           .gap_is_of_faces = data.gap_source == measured::GapSource::measured},
          rows.rows};
}

std::vector<std::string> decisions_of(measured::MeasuredData const& data,
                                      reduced::HeightRows const& rows) {
  std::vector<std::string> decisions{
      "no run has a curve: gap, force and compact are held against each other, and no simulation "
      "is asked (one force at one gap is spent on the modulus of the grains)"};
  if (!data.sample.solid_density)
    decisions.push_back(
        fmt::format("the data state no solid_density: the case's is taken, with {:.0f} % "
                    "as its uncertainty",
                    100.0 * reduced::solid_density_share));
  for (auto const& decision : data.decisions)
    decisions.push_back(in_words(decision));
  decisions.insert(decisions.end(), rows.left_out.begin(), rows.left_out.end());
  return decisions;
}

} // namespace

Finding diagnose_heights(Case const& setup, measured::MeasuredData const& data,
                         Provenance const& provenance,
                         diagnosis::DiagnosisSettings const& settings) {
  auto const rows = reduced::height_rows(data);
  auto const model = model_of(setup, data, rows);
  diagnosis::Observations const observations(rows.blocks);
  diagnosis::ErrorSources const sources{.channels = rows.channels};
  auto const found = diagnosis::diagnose(observations, model, sources, settings);
  FindingSources parts{
      .model = model, .observations = observations, .errors = sources, .settings = settings};
  parts.provenance = provenance;
  parts.decisions = decisions_of(data, rows);
  auto const& baseline = found.baseline_in_common;
  if (auto const possible = possible_causes(found); possible.size() > 1)
    parts.advice = next_measurements(baseline, found.library, possible,
                                     height_candidates(model, baseline.at, sources.tolerances));
  auto finding = finding_of(found, parts);
  auto words = height_sentences(model, rows, found.tests.is_alarm);
  finding.sentences.insert(finding.sentences.begin(), words.begin(), words.end());
  return finding;
}

} // namespace coupling::finding
