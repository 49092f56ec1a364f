#include "coupling/measured/lab_text.hpp"

#include "coupling/trimmed.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace coupling::measured {
namespace {

/// Bytes that continue the UTF-8 character that starts with `lead`; 4 if none does.
std::size_t n_continuing(unsigned char lead) {
  if (lead < 0x80u)
    return 0;
  if (lead >= 0xc2u && lead < 0xe0u)
    return 1;
  if (lead >= 0xe0u && lead < 0xf0u)
    return 2;
  return lead >= 0xf0u && lead < 0xf5u ? 3 : 4;
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::size_t const n = n_continuing(static_cast<unsigned char>(bytes[i]));
    if (n == 4 || i + n >= bytes.size() + (n == 0 ? 1 : 0))
      return false;
    for (std::size_t k = 0; k < n; ++k)
      if ((static_cast<unsigned char>(bytes[++i]) & 0xc0u) != 0x80u)
        return false;
  }
  return true;
}

std::string utf8_from_latin1(std::string_view bytes) {
  std::string text;
  for (char const c : bytes) {
    auto const byte = static_cast<unsigned char>(c);
    if (byte < 0x80u) {
      text += c;
    } else {
      text += static_cast<char>(0xc0u | (byte >> 6u));
      text += static_cast<char>(0x80u | (byte & 0x3fu));
    }
  }
  return text;
}

void refuse_other_bytes(std::string_view bytes, std::string const& name) {
  VALIDATE(!bytes.empty(), fmt::format("{}: is empty (a header and rows are needed). Was its "
                                       "writing interrupted?",
                                       name));
  bool const is_utf16 = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
  VALIDATE(!is_utf16,
           fmt::format("{}: is UTF-16 (UTF-8 and Latin-1 are read). Save it as UTF-8?", name));
  VALIDATE(bytes.find('\0') == std::string_view::npos,
           fmt::format("{}: holds bytes that are no text (a table of text is read, no "
                       "spreadsheet and no binary record). Export it as CSV?",
                       name));
}

} // namespace

LabText parse_lab_text(std::string_view bytes, std::string const& name) {
  refuse_other_bytes(bytes, name);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark))
    bytes.remove_prefix(byte_order_mark.size());
  LabText read;
  std::string text(bytes);
  if (!is_utf8(text)) {
    text = utf8_from_latin1(text);
    read.remarks.emplace_back("is not UTF-8: read as Latin-1");
  }
  char const end_of_line = text.find('\n') == std::string::npos ? '\r' : '\n';
  std::string_view rest = text;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    auto const end = rest.find(end_of_line);
    std::string line = trimmed(rest.substr(0, end));
    // A tab at the end is a field; only blank lines and the carriage return matter here.
    if (!line.empty()) {
      std::string_view const whole = rest.substr(0, end);
      line = whole.substr(0, whole.find_last_not_of('\r') + 1);
      read.lines.push_back({number, std::move(line)});
    }
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  VALIDATE(!read.lines.empty(),
           fmt::format("{}: is empty (a header and rows are needed). Was its writing interrupted?",
                       name));
  return read;
}

std::vector<std::string> split_fields(std::string_view line, char delimiter) {
  std::vector<std::string> fields;
  std::string field;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    char const c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"')
      field += line[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (c == delimiter && !is_quoted)
      fields.push_back(trimmed(std::exchange(field, {})));
    else
      field += c;
  }
  fields.push_back(trimmed(field));
  return fields;
}

std::string folded(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> letters = {
      {{"á", "a"},
       {"ä", "a"},
       {"Ä", "a"},
       {"é", "e"},
       {"í", "i"},
       {"ó", "o"},
       {"ö", "o"},
       {"Ö", "o"},
       {"ú", "u"},
       {"ü", "u"},
       {"Ü", "u"},
       {"ñ", "n"},
       {"ß", "ss"},
       {"Ó", "o"}}};
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char const c = name[i];
    bool is_letter = false;
    for (auto const& [accented, base] : letters)
      if (name.substr(i).starts_with(accented)) {
        plain += base;
        i += accented.size() - 1;
        is_letter = true;
        break;
      }
    if (is_letter)
      continue;
    bool const is_blank = c == '_' || c == '-' || c == '.' || c == ' ' || c == '\t';
    if (!is_blank)
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!plain.empty() && plain.back() != ' ')
      plain += ' ';
  }
  return trimmed(plain);
}

} // namespace coupling::measured
