#pragma once

#include "coupling/quantity.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Every entry that a case may hold, in one table: names, defaults, units, ranges, what they mean.
namespace coupling {

inline constexpr int max_components = 6;
inline constexpr int max_stages = 12;

enum class EntryKind {
  text,         ///< one line, for people
  choice,       ///< one of Entry::choices
  truth,        ///< true or false
  count,        ///< whole number
  quantity,     ///< number with a unit
  size_classes, ///< `0.5 mm: 35 %, 1 mm: 65 %`
  tools,        ///< `die, upper_punch`
  file          ///< path, relative to the case file
};

/// Allowed values of a number, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool is_low_allowed = true;
  bool is_high_allowed = true;

  bool contains(double value) const {
    return (is_low_allowed ? value >= low : value > low) &&
           (is_high_allowed ? value <= high : value < high);
  }
};

/// One entry. `path` is `Section/Subsection/Name`, or the bare name at the top level.
struct Entry {
  std::string path;
  EntryKind kind;
  Physical physical;    ///< of a quantity or of the diameter of a size class
  std::string standard; ///< default, as a person would write it; it shows the customary unit
  Range range;
  std::string choices;     ///< `hertz | hooke | jkr`, for a choice
  std::string description; ///< one sentence

  std::string section() const; ///< path without the name
  std::string name() const;
};

/// All entries, in the order in which they are printed.
std::span<Entry const> case_schema();

/// @returns nullptr for an unknown path (paths are case-sensitive)
Entry const* find_entry(std::string_view path);

/// The path without its last part; empty at the top level.
std::string_view section_of(std::string_view path);

/// The last part of a path.
std::string_view name_of(std::string_view path);

/// True for every path that has entries or sections below it.
bool is_section(std::string_view path);

/// ` Did you mean 'Powder/Total mass'?` for an unknown path, or where to find the list.
std::string suggest_entry(std::string_view unknown_path);

/// The same for a section.
std::string suggest_section(std::string_view unknown_path);

/// The allowed values in words: `> 0 m`, `0 to 1`, `hertz | hooke | jkr`.
std::string describe_range(Entry const& entry);

} // namespace coupling
