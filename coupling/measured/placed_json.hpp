#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coupling::measured {

/// A value of a JSON file with its place, for messages.
struct PlacedJson {
  enum class Kind { null, truth, number, text, list, object };

  Kind kind = Kind::null;
  std::string file;      ///< as messages name it
  int line = 1;          ///< where it starts
  std::string path = {}; ///< `runs[0]/press/end_gap`; empty for the whole file
  std::string text = {}; ///< of a text; of a number as it was written
  std::vector<std::pair<std::string, PlacedJson>> members = {}; ///< of an object, as written
  std::vector<PlacedJson> items = {};                           ///< of a list

  bool is(Kind other) const { return kind == other; }

  /// @return  nullptr if the object has no such member
  PlacedJson const* find(std::string_view name) const;

  /// Throws dem::InvalidInput `file:line: path = value: problem`.
  [[noreturn]] void refuse(std::string_view problem) const;
};

/// Reads a JSON text, keeping lines, and numbers to the digit.
/// @throws dem::InvalidInput  `file:line: ...` for what is no JSON, a key that occurs twice in its
///         object, nesting deeper than any file of ours
PlacedJson parse_placed_json(std::string_view text, std::string const& file);

} // namespace coupling::measured
