#pragma once

#include "coupling/compare/source.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Several runs, curves or observations beside each other. The first is the reference.
namespace coupling {

enum class Agreement { within, beyond, unknown };

/// One number of all sources.
struct QuantityRow {
  std::string name;                ///< "max_force"
  std::string words;               ///< "largest punch force"
  std::string unit;                ///< SI
  double tolerance;                ///< [1] of the reference, or [unit]
  bool is_relative;                ///< how tolerance and differences are meant
  std::vector<double> values;      ///< one a source; NaN where it does not know
  std::vector<double> differences; ///< to the reference; NaN for the reference and where not known
  std::vector<double> allowed; ///< the tolerance, or what the uncertainties grant if that is more
  std::vector<Agreement> agreement; ///< unknown for the reference
};

/// One branch of a source's force curve against the reference's.
struct CurveRow {
  std::size_t source;
  std::string branch; ///< "loading" or "unloading"
  double largest;     ///< [1], of the reference's peak
  double at_gap;      ///< [m]
  double rms;         ///< [1], of the reference's peak
  Agreement agreement;
};

/// How far two sources may differ. The defaults are the project's bars for the same packing in two
/// programs; where a value states a standard uncertainty, twice the two combined is allowed if that
/// is more.
struct Tolerances {
  double force = 0.01;         ///< relative: largest punch force
  double height = 0.01;        ///< relative: compact height
  double gap = 0.001;          ///< relative: smallest gap
  double work = 0.02;          ///< relative: work of loading, work of unloading
  double overlap = 0.02;       ///< relative: largest mean overlap
  double porosity = 0.01;      ///< absolute [1]
  double springback = 0.01;    ///< absolute [1]
  double shape_quality = 0.0;  ///< absolute [1]: the same class
  double curve_largest = 0.02; ///< of the peak
  double curve_rms = 0.01;     ///< of the peak
};

struct Comparison {
  std::vector<Source> sources;
  std::vector<QuantityRow> quantities; ///< those that at least two sources know
  std::vector<CurveRow> curves;
  std::vector<std::string> missing; ///< what could not be compared and why, a sentence each

  std::size_t n_compared() const;
  std::size_t n_beyond() const;
  bool agrees() const { return n_beyond() == 0; }
};

/// @throws dem::InvalidInput if there are fewer than two sources, or nothing that two of them know
Comparison compare(std::vector<Source> sources, Tolerances const& tolerances = {});

/// "2 of 9 comparisons are beyond their tolerance: ...", in words, without markup.
std::string in_words(Comparison const& comparison);

/// Writes the page and, beside it, comparison.json.
/// @throws dem::InvalidInput, WriteFailed
void write_comparison(std::filesystem::path const& page, Comparison const& comparison);

} // namespace coupling
