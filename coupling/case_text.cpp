#include "coupling/case_text.hpp"

#include "coupling/case_schema.hpp"
#include "coupling/case_value.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace coupling {

namespace {

constexpr std::size_t largest_file = 1u << 20; // bytes; the full list of entries has 20 kB

/// Number of bytes of the UTF-8 character at the front, 0 if there is none.
/// Source: RFC 3629, section 4; overlong forms, surrogates and values above U+10FFFF are no
/// characters.
std::size_t utf8_length(std::string_view text) {
  auto const byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  auto const is_tail = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
  unsigned const first = byte(0), second = byte(1);
  if (first < 0x80)
    return 1;
  if (first >= 0xc2 && first <= 0xdf)
    return is_tail(1) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    bool const is_valid = !(first == 0xe0 && second < 0xa0) && !(first == 0xed && second > 0x9f);
    return is_valid && is_tail(1) && is_tail(2) ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    bool const is_valid = !(first == 0xf0 && second < 0x90) && !(first == 0xf4 && second > 0x8f);
    return is_valid && is_tail(1) && is_tail(2) && is_tail(3) ? 4 : 0;
  }
  return 0;
}

bool is_control(char c) {
  auto const byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
}

} // namespace

void refuse_entry(std::string_view where, std::string_view path, std::string_view text,
                  std::string_view problem) {
  throw dem::InvalidInput(fmt::format("{}: {} = {}: {}", where, quote(path), quote(text), problem));
}

void check_is_text(std::string_view text, std::string const& name) {
  VALIDATE(text.size() <= largest_file,
           fmt::format("{}: has {} bytes (a case has at most {}). Is this the right file?", name,
                       text.size(), largest_file));
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t const length = utf8_length(text.substr(at));
    VALIDATE(length > 0 && !is_control(text[at]),
             fmt::format("{}:{}: holds a byte 0x{:02x} that no text has (a case is UTF-8 text). Is "
                         "this the right file?",
                         name, line, static_cast<unsigned char>(text[at])));
    if (text[at] == '\n')
      ++line;
    at += length;
  }
}

void check_assignment(std::string_view where, std::string_view path, std::string_view text) {
  Entry const* const entry = find_entry(path);
  if (entry == nullptr)
    refuse_entry(where, path, text,
                 is_section(path) ? "is a section, not an entry. Name an entry below it?"
                                  : "is no entry of a case." + suggest_entry(path));
  if (text.find_first_of("#\n\r\t") != std::string_view::npos || text.ends_with('\\'))
    refuse_entry(where, path, text,
                 "holds '#', a tab, a line end, or a backslash at its end (a .prm file could not "
                 "hold it). Leave it out?");
  if (text.starts_with(' ') || text.ends_with(' '))
    refuse_entry(where, path, text,
                 "begins or ends with a space (a .prm file would lose it). Leave it out?");
  try {
    check_value(*entry, text);
  } catch (dem::InvalidInput const& problem) {
    refuse_entry(where, path, text, problem.what());
  }
}

} // namespace coupling
