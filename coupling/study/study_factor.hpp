#pragma once

#include "coupling/quantity.hpp"
#include "coupling/study/study_vocabulary.hpp"

#include <string>
#include <vector>

namespace coupling::study {

/// One entry of a case that a factor sets:  entry = pattern with {} = multiplier x value.
struct FactorEntry {
  std::string path;
  double multiplier = 1.0;    ///< [1]
  std::string pattern = "{}"; ///< `{}: 100 %` for size classes
};

/// A quantity that a study varies. Values are in SI; texts are in the unit that the study's author
/// wrote.
struct StudyFactor {
  std::string name;  ///< E
  std::string where; ///< `study.prm:20`
  std::vector<FactorEntry> entries;
  Physical physical;          ///< of its entries
  std::string unit;           ///< as written: MPa; empty for a bare number
  double low;                 ///< [SI], coded -1
  double high;                ///< [SI], coded 1
  std::vector<double> levels; ///< [SI], rising; of a full factorial, else empty

  double coded(double natural) const { return (2.0 * natural - low - high) / (high - low); }
  double natural(double coded) const { return 0.5 * (low + high) + 0.5 * (high - low) * coded; }

  /// SI unit of its values; `1` for a ratio.
  std::string si_unit() const;

  /// The number of a value in the author's unit: 1375 of 1375e6 Pa.
  double number(double natural) const;

  /// `1375 MPa`: six digits, so that a name, a case and a table say the same.
  std::string text(double natural) const;

  /// The value that text() says.  [SI]
  double rounded(double natural) const;

  /// `E1375`, a part of a run's name.
  std::string name_of(double natural) const;

  /// What the factor sets at a value [SI], placed where the factor is written.
  std::vector<PlacedValue> values(double natural) const;
};

/// `Factor N` of a study file. With a table as its design, low and high may be left out: then both
/// are NaN until the rows are known.
/// @throws dem::InvalidInput for an entry that no case has, limits that do not fit it, or a
/// constant
StudyFactor read_factor(StudyText const& text, int number, std::string const& kind);

/// The value of a factor in the text of its first entry, for rows of a table.  [SI]
/// @throws dem::InvalidInput  `where: path = text: problem` if the pattern does not fit
double value_in(StudyFactor const& factor, FactorEntry const& entry, PlacedValue const& value);

/// The unit behind a number: `MPa` of `1375 MPa`.
std::string unit_of(std::string_view quantity);

/// Texts between separators, trimmed; none for an empty text.
std::vector<std::string> split_list(std::string_view text, char separator);

} // namespace coupling::study
