#include "coupling/prm_lines.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace coupling {

namespace {

std::string_view trim(std::string_view text) {
  auto const first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The rest of a line that begins with a keyword, lower or upper case as deal.II reads them.
std::optional<std::string_view> after_keyword(std::string_view line, std::string_view lower,
                                              std::string_view upper) {
  if (!line.starts_with(lower) && !line.starts_with(upper))
    return std::nullopt;
  std::string_view const rest = line.substr(lower.size());
  if (!rest.empty() && rest[0] != ' ' && rest[0] != '\t')
    return std::nullopt;
  return trim(rest);
}

/// Follows the lines of one file.
class PrmScanner {
public:
  PrmScanner(std::string const& name, PrmVocabulary const& vocabulary)
      : name_(name), vocabulary_(vocabulary) {}

  void take_line(std::string_view line, int number) {
    number_ = number;
    line = trim(line.substr(0, line.find('#')));
    if (line.empty())
      return;
    if (auto const section = after_keyword(line, "subsection", "SUBSECTION"))
      return enter(*section);
    if (auto const entry = after_keyword(line, "set", "SET"))
      return assign(*entry);
    if (auto const rest = after_keyword(line, "end", "END"))
      return leave(*rest);
    if (after_keyword(line, "include", "INCLUDE"))
      refuse(line, fmt::format("{} cannot include another file (it is kept as one file beside its "
                               "results). Copy the lines here?",
                               vocabulary_.noun()));
    refuse(line, "is no line of a .prm file (a line is: subsection NAME, set ENTRY = VALUE, end, "
                 "or # a comment). "
                 "Is a word missing?");
  }

  std::vector<Assignment> finish() {
    if (!open_.empty())
      throw dem::InvalidInput(
          fmt::format("{}:{}: subsection {} is never closed (its end is missing). Add 'end'?",
                      name_, open_.back().line, name_of(open_.back().path)));
    return std::move(assignments_);
  }

private:
  struct OpenSection {
    std::string path;
    int line;
  };

  std::string where() const { return fmt::format("{}:{}", name_, number_); }

  [[noreturn]] void refuse(std::string_view line, std::string_view problem) const {
    throw dem::InvalidInput(fmt::format("{}: '{}': {}", where(), quote(line), problem));
  }

  std::string path_of(std::string_view part) const {
    return open_.empty() ? std::string(part) : fmt::format("{}/{}", open_.back().path, part);
  }

  void enter(std::string_view section) {
    std::string const path = path_of(section);
    vocabulary_.check_section(where(), path);
    open_.push_back({path, number_});
  }

  void leave(std::string_view rest) {
    if (!rest.empty())
      refuse(fmt::format("end {}", rest),
             "has more than 'end' on its line. Put it on its own line?");
    if (open_.empty())
      refuse("end", "closes a subsection, but none is open. Remove it?");
    open_.pop_back();
  }

  void assign(std::string_view entry) {
    auto const equals = entry.find('=');
    if (equals == std::string_view::npos)
      refuse(fmt::format("set {}", entry),
             "has no '=' (a line is: set ENTRY = VALUE). Add the value?");
    std::string const path = path_of(trim(entry.substr(0, equals)));
    std::string const text(trim(entry.substr(equals + 1)));
    vocabulary_.check_entry(where(), path, text);
    auto const [first, is_new] = lines_.emplace(path, number_);
    if (!is_new)
      refuse_entry(where(), path, text,
                   fmt::format("is set twice (first on line {}). Remove one?", first->second));
    assignments_.push_back({path, text, number_});
  }

  std::string const& name_;
  PrmVocabulary const& vocabulary_;
  int number_ = 0;
  std::vector<OpenSection> open_;
  std::map<std::string, int> lines_;
  std::vector<Assignment> assignments_;
};

} // namespace

std::vector<Assignment> scan_prm_lines(std::string_view text, std::string const& name,
                                       PrmVocabulary const& vocabulary) {
  check_is_text(text, name);
  PrmScanner scanner(name, vocabulary);
  std::string joined; // of lines that a backslash continues
  int number = 0, first_number = 1;
  while (!text.empty()) {
    auto const end = text.find('\n');
    std::string_view line = trim(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    if (joined.empty())
      first_number = number;
    bool const is_continued = line.ends_with('\\');
    if (is_continued)
      line.remove_suffix(1);
    joined += line;
    if (is_continued && !text.empty())
      continue;
    scanner.take_line(joined, first_number);
    joined.clear();
  }
  return scanner.finish();
}

} // namespace coupling
