#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// A case as text: what stands between the readers of file formats and the Case. Whoever replaces
/// the reader of .prm files has to deliver a CaseText and nothing else.
namespace coupling {

/// What a file says about one entry.
struct Assignment {
  std::string path; ///< `Section/Entry`
  std::string text; ///< the value, trimmed
  int line;         ///< from 1
};

/// A value for one entry from elsewhere than the case file.
struct PlacedValue {
  std::string path;  ///< `Section/Entry`
  std::string text;  ///< the value, trimmed
  std::string where; ///< `settings.csv:7`, `--set`
};

/// The text of one entry, and where it was written.
struct EntryText {
  std::string text;
  std::string where; ///< `case.prm:31`, `--set`, or the file alone for a default
  bool is_given;     ///< by the person; false for a default
};

/// Every entry of the schema, by path.
using CaseText = std::map<std::string, EntryText, std::less<>>;

/// Throws dem::InvalidInput `where: path = text: problem`.
[[noreturn]] void refuse_entry(std::string_view where, std::string_view path, std::string_view text,
                               std::string_view problem);

/// @throws dem::InvalidInput unless `text` is UTF-8 without control characters other than tab and
/// line ends, and of a size that a person may have written
void check_is_text(std::string_view text, std::string const& name);

/// @throws dem::InvalidInput for a path that is no entry, with the nearest one, or a value that
/// could not stand on one line of a .prm file, or does not fit its entry
void check_assignment(std::string_view where, std::string_view path, std::string_view text);

/// Reads the lines of a .prm file (`subsection`, `set`, `end`, comments, lines continued by a
/// backslash).
/// @throws dem::InvalidInput  with file and line, for anything else, unknown sections and entries,
/// values that do not fit, and entries set twice
std::vector<Assignment> scan_prm(std::string_view text, std::string const& name);

/// Reads a .json case: objects are sections, `"Entry": "value"` or `"Entry": {"value": "value",
/// ...}` entries.
/// @throws dem::InvalidInput  as scan_prm
std::vector<Assignment> scan_json(std::string_view text, std::string const& name);

} // namespace coupling
