#pragma once

#include "coupling/finding/finding.hpp"

/// Names of the diagnosis as people at a press say them.
namespace coupling::finding {

/// A number in the unit that people use for it:  shown = SI x factor.
struct ShownAs {
  double factor;
  std::string unit; ///< empty for a bare number
};

/// "the press frame gives way" for frame_compliance; the name without underscores for one that is
/// not in the table.
std::string words_of(std::string_view cause);

/// One sentence: what the cause is, on a press. Empty for an unknown name.
std::string meaning_of(std::string_view cause);

/// One sentence: how to look for it. Empty for an unknown name.
std::string check_of(std::string_view cause);

/// The names of causes in a sentence replaced by nouns: "compliance of the press frame does the
/// same to these data as lag of the load cell".
std::string with_words(std::string_view sentence);

/// With a capital in front.
std::string capitalised(std::string text);

/// "force on the upper punch" for upper_punch_force.
std::string channel_in_words(std::string_view channel);

/// "pressing" for loading, "holding" for dwell.
std::string phase_in_words(std::string_view phase);

/// Frame compliance in µm/kN, drift in µm/min, friction as a bare number, shares in per cent, else
/// as SI.
ShownAs shown_as(std::string_view cause, std::string_view unit);

/// `18.2 µm/kN`, `-1.5 %`; "not known" for what is no number. Three digits.
std::string size_in_words(std::string_view cause, double value, std::string_view unit);

/// `size = 18.2 µm/kN, 95 %: 16.9 µm/kN to 19.6 µm/kN`, "no lower limit" where the data end none.
std::string interval_in_words(std::string_view cause, CauseParameter const& parameter);

/// `frame_compliance = 18.2 µm/kN, 95 %: ...`, for a comment.
std::string in_words(FoundCause const& cause);

/// `calibrated: young_modulus = 1.95 GPa, sd 12 MPa (sheet: 2 GPa)`.
std::string in_words(CalibratedValue const& value);

/// The verdict as the first sentence of a report, for a press operator.
std::string verdict_in_words(Finding const& finding);

/// A text on one line without control characters and backslashes, for a comment of a case file.
std::string one_line(std::string_view text);

} // namespace coupling::finding
