#pragma once

#include "coupling/finding/finding_parts.hpp"

/// What a diagnosis found, as the three files that it writes hold it.
namespace coupling::finding {

/// Plain values in SI units; nothing here knows how they were found.
struct Finding {
  std::string verdict;         ///< consistent, named, undecided, unknown
  bool is_incomplete = false;  ///< named, but structure remains
  double explained_share = 1.; ///< [1], of the misfit, by the causes
  std::vector<std::string> sentences = {};

  Alarm alarm = {};
  std::vector<MisfitCell> misfit = {};
  std::vector<RunLevel> levels = {};
  std::vector<FoundCause> causes = {};        ///< the named ones first, then by probability
  std::vector<std::string> not_claimed = {};  ///< probable, yet clean data show such sizes
  std::vector<std::string> group = {};        ///< cannot be told apart; empty if there is none
  std::vector<Measurement> measurements = {}; ///< the best first
  std::optional<MeasuredGain> gain = {}, placebo = {};
  std::vector<DetectableSize> detectable = {};
  std::vector<StatedError> tolerances = {};
  std::optional<Unknown> unknown = {};
  std::vector<CalibratedValue> calibrated = {};
  std::vector<ChangedEntry> extension = {};   ///< what extended.prm has otherwise than the case
  std::vector<std::string> not_modelled = {}; ///< causes without entries, a sentence each
  std::vector<std::string> decisions = {}; ///< of the reader of the measured data, a sentence each
  std::vector<RunCurve> curves = {};
  std::vector<Seed> seeds = {};
  Provenance provenance = {};
};

/// The causes that the verdict claims: those of `named`; none otherwise.
std::vector<FoundCause> named_causes(Finding const& finding);

/// The first cause of that name, or nullptr.
FoundCause const* find_cause(Finding const& finding, std::string_view name);

} // namespace coupling::finding
