#include "coupling/record/csv.hpp"

#include "coupling/trimmed.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace coupling {
namespace {

std::vector<std::string> split_line(std::string_view line, std::string const& name,
                                    std::size_t number) {
  std::vector<std::string> fields;
  std::string field;
  bool is_quoted = false, was_quoted = false;
  auto const finish_field = [&] {
    fields.push_back(was_quoted ? field : trimmed(field));
    field.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    char const c = line[i];
    if (is_quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      field += line[++i];
    else if (c == '"' && (is_quoted || trimmed(field).empty())) {
      if (!is_quoted)
        field.clear();
      is_quoted = !is_quoted;
      was_quoted = true;
    } else if (c == ',' && !is_quoted)
      finish_field();
    else if (!was_quoted || is_quoted)
      field += c;
  }
  VALIDATE(!is_quoted,
           fmt::format(
               "{}:{}: a quote is not closed (a quoted field ends on its line). Is a \" missing?",
               name, number));
  finish_field();
  return fields;
}

} // namespace

std::vector<CsvLine> split_csv(std::string_view text, std::string const& name) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark))
    text.remove_prefix(byte_order_mark.size());
  std::vector<CsvLine> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    auto const end = text.find('\n');
    std::string_view const line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.starts_with('#') || trimmed(line).empty())
      continue;
    lines.push_back({number, split_line(line, name, number)});
  }
  return lines;
}

std::string csv_field(std::string_view text) {
  std::string field;
  for (char const c : text)
    field += c == '\n' || c == '\r' ? ' ' : c;
  if (field.find_first_of(",\"#") == std::string::npos && field == trimmed(field))
    return field;
  std::string quoted = "\"";
  for (char const c : field)
    quoted.append(c == '"' ? 2 : 1, c);
  quoted += '"';
  return quoted;
}

double csv_number(std::string const& text, std::string const& name, std::size_t line,
                  std::string const& column) {
  double value = 0.0;
  char const* const first = text.data() + (text.starts_with('+') ? 1 : 0);
  auto const [end, error] = std::from_chars(first, text.data() + text.size(), value);
  VALIDATE(error == std::errc() && end == text.data() + text.size(),
           fmt::format(
               "{}:{}: {} = '{}': is no number{}. Is a field missing, or the decimal mark a comma?",
               name, line, column, text,
               error == std::errc::result_out_of_range ? " that a computer can hold" : ""));
  return value;
}

} // namespace coupling
