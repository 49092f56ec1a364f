#pragma once

#include "coupling/finding/finding.hpp"

/// The parts of a finding's page that are plain HTML and need no script. Everything from outside is
/// escaped here. A part without content is empty.
namespace coupling::finding {

/// p below which a cell of the map is marked.
inline constexpr double marked_p = 0.01;

std::string verdict_part(Finding const& finding);    ///< the sentence on top, with its class
std::string answer_part(Finding const& finding);     ///< what it is, what to do, further sentences
std::string misfit_part(Finding const& finding);     ///< map of channel x phase, levels by run
std::string scalars_part(Finding const& finding);    ///< what was read once a run
std::string causes_part(Finding const& finding);     ///< ranked, with sizes
std::string next_part(Finding const& finding);       ///< group and next measurement
std::string unknown_part(Finding const& finding);    ///< what can be said without a cause
std::string gain_part(Finding const& finding);       ///< held-out runs, with the placebo
std::string extension_part(Finding const& finding);  ///< changed entries
std::string detectable_part(Finding const& finding); ///< what could not have been seen
std::string assumed_part(Finding const& finding);    ///< calibrated values, tolerances
std::string reading_part(Finding const& finding);    ///< decisions of the reader
std::string origin_part(Finding const& finding);     ///< provenance and seeds

/// What the page's script draws, as JSON text: the curves.
std::string curves_json(Finding const& finding);

/// `<section class="card" id="ID"><h2>TITLE <small>NOTE</small></h2>BODY</section>`
/// @param body  HTML; the rest is escaped
std::string card(std::string_view id, std::string_view title, std::string_view note,
                 std::string_view body);

/// `<p class="quiet">...</p>`, escaped.
std::string quiet(std::string_view text);

} // namespace coupling::finding
