#include "coupling/measured/lab_numbers.hpp"

#include "coupling/trimmed.hpp"

#include <algorithm>
#include <array>

namespace coupling::measured {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool are_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+'))
    text.remove_prefix(1);
  return text;
}

std::string_view mantissa(std::string_view text) {
  return without_sign(text.substr(0, text.find_first_of("eE")));
}

/// 1.234.567 with the separator '.': one to three digits, then groups of three.
bool is_grouped(std::string_view digits, char separator) {
  auto const first = digits.find(separator);
  if (first == std::string_view::npos || first == 0 || first > 3 || digits[0] == '0' ||
      !are_digits(digits.substr(0, first)))
    return false;
  for (digits.remove_prefix(first); !digits.empty(); digits.remove_prefix(4))
    if (digits.size() < 4 || digits[0] != separator || !are_digits(digits.substr(1, 3)))
      return false;
  return true;
}

/// Replaces the blanks and apostrophes that part thousands by one plain apostrophe.
std::string with_apostrophes(std::string_view cell) {
  static constexpr std::array<std::string_view, 5> parts = {"\u00a0", "\u202f", "\u2009", "\u2019",
                                                            " "};
  std::string text(cell);
  for (auto const part : parts)
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
      text.replace(at, part.size(), "'");
  return text;
}

/// Digits without the groups' separator; nothing if the separator stands elsewhere.
std::optional<std::string> ungrouped(std::string_view digits, char separator) {
  if (are_digits(digits))
    return std::string(digits);
  if (!is_grouped(digits, separator))
    return {};
  std::string plain;
  std::ranges::copy_if(digits, std::back_inserter(plain), is_digit);
  return plain;
}

} // namespace

MarkEvidence mark_evidence(std::string_view cell) {
  std::string const text = with_apostrophes(trimmed(cell));
  std::string_view const number = mantissa(text);
  auto const n_points = std::ranges::count(number, '.'), n_commas = std::ranges::count(number, ',');
  if (!std::ranges::all_of(
          number, [](char c) { return is_digit(c) || c == '.' || c == ',' || c == '\''; }) ||
      n_points + n_commas == 0)
    return MarkEvidence::none;
  bool const has_exponent = text.find_first_of("eE") != std::string::npos;
  auto const alone = [&](char mark, std::ptrdiff_t n, MarkEvidence is, MarkEvidence other,
                         MarkEvidence ambiguous) {
    if (n > 1)
      return is_grouped(number, mark) ? other : MarkEvidence::none;
    return is_grouped(number, mark) && !has_exponent ? ambiguous : is;
  };
  if (n_commas == 0)
    return alone('.', n_points, MarkEvidence::point, MarkEvidence::comma,
                 MarkEvidence::ambiguous_point);
  if (n_points == 0)
    return alone(',', n_commas, MarkEvidence::comma, MarkEvidence::point,
                 MarkEvidence::ambiguous_comma);
  bool const ends_with_point = number.rfind('.') > number.rfind(',');
  return ends_with_point ? (n_points == 1 ? MarkEvidence::point : MarkEvidence::none)
                         : (n_commas == 1 ? MarkEvidence::comma : MarkEvidence::none);
}

std::optional<std::string> plain_number(std::string_view cell, char mark) {
  std::string const text = with_apostrophes(trimmed(cell));
  auto const e = text.find_first_of("eE");
  std::string_view const digits = mantissa(text);
  auto const at = digits.find(mark);
  std::string_view const whole = digits.substr(0, at);
  std::string_view const fraction =
      at == std::string_view::npos ? std::string_view{} : digits.substr(at + 1);
  char const other = mark == '.' ? ',' : '.';
  auto plain = whole.empty() ? std::optional<std::string>("0") : ungrouped(whole, other);
  if (!plain)
    plain = ungrouped(whole, '\'');
  if (!plain || (whole.empty() && fraction.empty()) || (!fraction.empty() && !are_digits(fraction)))
    return {};
  std::string number = (text.starts_with('-') ? "-" : "") + *plain;
  if (!fraction.empty())
    number.append(".").append(fraction);
  if (e == std::string::npos)
    return number;
  std::string_view const exponent = without_sign(std::string_view(text).substr(e + 1));
  if (!are_digits(exponent))
    return {};
  return number + text.substr(e);
}

bool is_gap(std::string_view cell) {
  static constexpr std::array<std::string_view, 6> words = {"", "nan", "na", "n/a", "-", "--"};
  std::string text = trimmed(cell);
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return std::ranges::find(words, text) != words.end();
}

} // namespace coupling::measured
