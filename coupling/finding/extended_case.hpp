#pragma once

#include "coupling/finding/cause_entries.hpp"
#include "coupling/finding/finding.hpp"

namespace coupling::finding {

struct ExtendedCase {
  std::string text;                      ///< .prm, complete, with a comment above each change
  std::vector<ChangedEntry> changes;     ///< in the order in which they were made
  std::vector<std::string> not_modelled; ///< a sentence for each cause without entries
};

/// The user's case with calibrated values and causes as entries of the ordinary simulator: a
/// resolved case, each changed entry under a comment with cause, size and 95 % interval. What the
/// case would refuse (a coefficient below 0, laws that do not go together) is left out and said in
/// `not_modelled`, with the refusal. A cause that is a calibrated parameter changes nothing beside
/// the calibrated value.
/// @throws dem::InvalidInput if the user's case itself is refused
ExtendedCase extended_case(Case const& setup, std::vector<FoundCause> const& causes,
                           std::vector<CalibratedValue> const& calibrated = {},
                           BedFacts const& facts = {});

/// For a finding: its named causes and calibrated values; those of `undecided` and `unknown` are no
/// causes to be modelled, and the text says so.
ExtendedCase extended_case(Case const& setup, Finding const& finding, BedFacts const& facts = {});

} // namespace coupling::finding
