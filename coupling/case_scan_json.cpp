#include "coupling/case_schema.hpp"
#include "coupling/case_text.hpp"
#include "coupling/quote.hpp"
#include "coupling/watched_byte.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace coupling {

namespace {

/// Words that `presscheck defaults --format json` puts beside a value; they say nothing that is
/// read.
constexpr std::array annotations = {"unit", "range", "description", "default"};

/// Turns the parser's events into assignments. nlohmann's document would keep the last of two equal
/// keys and no lines.
class JsonScanner : public nlohmann::json_sax<nlohmann::json> {
public:
  JsonScanner(std::string_view text, std::string const& name) : name_(name), text_(text) {}

  WatchedText& text() { return text_; }
  std::vector<Assignment> finish() { return std::move(assignments_); }

  bool null() override { return value("null"); }
  bool boolean(bool truth) override { return value(truth ? "true" : "false"); }
  bool number_integer(number_integer_t number) override { return value(fmt::format("{}", number)); }
  bool number_unsigned(number_unsigned_t number) override {
    return value(fmt::format("{}", number));
  }
  bool number_float(number_float_t, string_t const& written) override { return value(written); }
  bool string(string_t& text) override { return value(text); }
  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override {
    if (!sections_.empty() || !key_.empty())
      enter_section();
    else
      sections_.push_back("");
    return true;
  }
  bool end_object() override {
    sections_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override {
    throw dem::InvalidInput(
        fmt::format("{}: '{}' is a list (entries are texts, such as \"0.5 mm: 35 %, 1 mm: 65 %\"). "
                    "Write it as one text?",
                    where(), quote(path())));
  }
  bool end_array() override { return true; }
  bool key(string_t& name) override {
    key_ = name;
    key_line_ = text_.line();
    return true;
  }
  bool parse_error(std::size_t, std::string const& read_so_far,
                   nlohmann::detail::exception const&) override {
    // The parser spells control characters out.
    std::string_view const line_end = "<U+000A>";
    auto const last_line = read_so_far.rfind(line_end);
    std::string const token = last_line == std::string::npos
                                  ? read_so_far
                                  : read_so_far.substr(last_line + line_end.size());
    throw dem::InvalidInput(
        fmt::format("{}:{}: is no JSON at '{}'. Is a comma, quote or bracket missing or left over?",
                    name_, text_.line(), quote(token)));
  }

private:
  std::string where() const { return fmt::format("{}:{}", name_, key_line_); }
  std::string path() const {
    return sections_.empty() || sections_.back().empty()
               ? key_
               : fmt::format("{}/{}", sections_.back(), key_);
  }

  void enter_section() {
    std::string const section = path();
    // An entry that is an object holds its value and annotations.
    if (!is_section(section) && find_entry(section) == nullptr)
      throw dem::InvalidInput(fmt::format("{}: section '{}': is no section of a case.{}", where(),
                                          quote(section), suggest_section(section)));
    sections_.push_back(section);
  }

  bool value(std::string const& text) {
    if (sections_.empty())
      throw dem::InvalidInput(
          fmt::format("{}: holds no JSON object (a case is one object of sections). Is this the "
                      "right file?",
                      name_));
    std::string entry = path();
    if (find_entry(sections_.back()) != nullptr) {
      if (std::ranges::find(annotations, key_) != annotations.end())
        return true;
      if (key_ == "value")
        entry = sections_.back();
    }
    check_assignment(where(), entry, text);
    auto const [first, is_new] = lines_.emplace(entry, key_line_);
    if (!is_new)
      refuse_entry(where(), entry, text,
                   fmt::format("is set twice (first on line {}). Remove one?", first->second));
    assignments_.push_back({entry, text, key_line_});
    return true;
  }

  std::string const& name_;
  WatchedText text_;
  int key_line_ = 1;
  std::string key_;
  std::vector<std::string> sections_;
  std::map<std::string, int> lines_;
  std::vector<Assignment> assignments_;
};

} // namespace

std::vector<Assignment> scan_json(std::string_view text, std::string const& name) {
  check_is_text(text, name);
  JsonScanner scanner(text, name);
  nlohmann::json::sax_parse(scanner.text().begin(), scanner.text().end(), &scanner);
  return scanner.finish();
}

} // namespace coupling
