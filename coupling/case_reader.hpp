#pragma once

#include "coupling/case.hpp"
#include "coupling/case_text.hpp"

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace coupling {

/// Reads values out of a CaseText, names the place when one is refused, and remembers what was
/// read: what a person wrote and nothing reads is a misunderstanding, and the texts that were read
/// are the case as understood.
class CaseReader {
public:
  /// @param folder  of the case file; relative paths start there
  CaseReader(CaseText const& text, std::filesystem::path folder)
      : text_(text), folder_(std::move(folder)) {}

  double number(std::string const& path);
  std::uint64_t count(std::string const& path);
  bool truth(std::string const& path);
  std::string choice(std::string const& path);
  std::string words(std::string const& path);
  std::vector<SizeClass> size_classes(std::string const& path);
  std::vector<std::string> tools(std::string const& path);
  std::filesystem::path file(std::string const& path); ///< absolute; empty where none is named

  /// Replaces what the resolved case says, where a default such as `preset` stands for something
  /// else.
  void resolve(std::string const& path, std::string text) { resolved_[path] = std::move(text); }

  bool is_given(std::string const& path) const { return entry(path).is_given; }

  /// Throws dem::InvalidInput `file:line: path = value: problem`.
  [[noreturn]] void refuse(std::string const& path, std::string_view problem) const;

  /// Refuses entries below `section` that a person wrote and nothing has read, unless they say zero
  /// or nothing.
  /// @param reason  why nothing reads them, for the brackets of the message
  void refuse_unread(std::string const& section, std::string const& reason) const;

  /// The entries that were read, with their values in SI.
  std::map<std::string, std::string> const& resolved() const { return resolved_; }

private:
  EntryText const& entry(std::string const& path) const;

  CaseText const& text_;
  std::filesystem::path folder_;
  std::map<std::string, std::string> resolved_;
};

} // namespace coupling
