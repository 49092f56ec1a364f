#pragma once

#include "coupling/finding/finding_parts.hpp"

#include <map>
#include <string>
#include <vector>

namespace coupling::finding {

/// How far the entries of a cause go, and who says so.
struct Dosed {
  double dose;
  std::string remark; ///< for the comment above the entry
};

/// What a run says of its bed and cannot be read off the case. NaN where it is not known.
struct BedFacts {
  /// Mean overlap over effective radius R* of the contacts at the largest force [1].
  double relative_overlap = not_known;
  /// F / (dF/dt) at the largest force, in the case's own time [s].
  double growth_time = not_known;
  /// Largest force on the upper punch over the area of the bore [Pa].
  double largest_stress = not_known;
  /// By the names of causes: what simulations have shown (dose_search.hpp).
  std::map<std::string, Dosed, std::less<>> doses = {};
};

/// One entry with its new value as a person would write it.
struct EntryChange {
  std::string path, text;
};

/// Entries that model a cause, or why there are none.
struct CauseEntries {
  std::vector<EntryChange> changes = {};
  std::string obstacle = {}; ///< a sentence; empty where there are changes
  std::string remark = {};   ///< how sure the values are; empty: they follow from the size
};

/// An entry in SI, as the case file writes it. @param path  of the schema
EntryChange entry_change(std::string const& path, double value);

} // namespace coupling::finding
