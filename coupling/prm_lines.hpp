#pragma once

#include "coupling/case_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// The sections and entries that a kind of .prm file has.
class PrmVocabulary {
public:
  virtual ~PrmVocabulary() = default;

  /// "a case", for messages.
  virtual std::string_view noun() const = 0;

  /// @throws dem::InvalidInput for a section that is none, with the nearest one
  virtual void check_section(std::string const& where, std::string_view path) const = 0;

  /// @throws dem::InvalidInput for an entry that is none, or a value that does not fit it
  virtual void check_entry(std::string const& where, std::string_view path,
                           std::string_view text) const = 0;
};

/// Reads the lines of a .prm file (`subsection`, `set`, `end`, comments, lines continued by a
/// backslash).
/// @throws dem::InvalidInput  with file and line, for anything else, what the vocabulary refuses,
/// and entries set twice
std::vector<Assignment> scan_prm_lines(std::string_view text, std::string const& name,
                                       PrmVocabulary const& vocabulary);

} // namespace coupling
