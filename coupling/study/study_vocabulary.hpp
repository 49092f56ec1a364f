#pragma once

#include "coupling/case_schema.hpp"
#include "coupling/prm_lines.hpp"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coupling::study {

/// Section of a study file whose entries are those of a case, for every run.
inline constexpr std::string_view common_section = "Case entries";

/// Every entry that a study file may hold; `Factor #` and `Response #` stand for any number.
std::span<Entry const> study_schema();

/// `Factor 3/Name` is the row `Factor #/Name`. @returns nullptr for an unknown path
Entry const* find_study_entry(std::string_view path);

/// What a study file may say: the schema above, and entries of a case below `Case entries`.
class StudyVocabulary : public PrmVocabulary {
public:
  std::string_view noun() const override { return "a study"; }
  void check_section(std::string const& where, std::string_view path) const override;
  void check_entry(std::string const& where, std::string_view path,
                   std::string_view text) const override;
};

/// The text of a study file by entry, and which numbers its factors and responses have.
class StudyText {
public:
  /// @throws dem::InvalidInput  `file:line: entry = value: problem (why). Way out?`
  explicit StudyText(std::string const& text, std::string name);

  bool has(std::string const& path) const { return entries_.contains(path); }

  /// What was written, else the default.
  std::string text(std::string const& path) const;
  long count(std::string const& path) const;
  bool truth(std::string const& path) const { return text(path) == "true"; }

  /// `study.prm:12`, or the file alone for a default.
  std::string where(std::string const& path) const;

  /// Numbers of the sections `Factor 1`, `Factor 2`, ..., rising.
  std::vector<int> numbers(std::string const& kind) const;

  /// Entries of a case for every run.
  std::vector<PlacedValue> common() const;

  /// @throws dem::InvalidInput  `where: path = text: problem`
  [[noreturn]] void refuse(std::string const& path, std::string_view problem) const;

  /// Throws the same where the entry was not written, or is empty. @returns the text
  std::string needed(std::string const& path, std::string_view why) const;

  std::string const& name() const { return name_; }

private:
  std::string name_;
  std::map<std::string, Assignment> entries_;
};

} // namespace coupling::study
