#include "coupling/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace coupling {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// HTML ignores case in tag names, so "</ScRiPt" ends a script too.
bool starts_with_script(std::string_view text) {
  constexpr std::string_view name = "script";
  if (text.size() < name.size())
    return false;
  for (std::size_t k = 0; k < name.size(); ++k)
    if ((text[k] | 0x20) != name[k])
      return false;
  return true;
}

bool takes_prefix(std::string_view unit) {
  return unit == "N" || unit == "m" || unit == "Pa" || unit == "J" || unit == "W" || unit == "s";
}

} // namespace

std::string escape_html(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (char const c : text) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&#39;";
      break;
    default:
      out += c;
    }
  }
  return out;
}

std::string escape_json_in_script(std::string_view json) {
  std::string out(json);
  replace_all(out, "&", "\\u0026");
  replace_all(out, "<", "\\u003c");
  replace_all(out, ">", "\\u003e");
  return out;
}

std::string escape_inline_script(std::string_view code) {
  std::string out;
  out.reserve(code.size());
  for (std::size_t k = 0; k < code.size(); ++k) {
    out += code[k];
    if (code[k] != '<')
      continue;
    auto const rest = code.substr(k + 1);
    if (rest.starts_with("!--") || (rest.starts_with('/') && starts_with_script(rest.substr(1))))
      out += '\\';
  }
  return out;
}

std::string format_quantity(double value, std::string_view unit, int digits) {
  if (!std::isfinite(value))
    return "not reached";
  if (unit == "1" || unit.empty())
    return fmt::format("{:#.{}g}", value, digits);
  if (!takes_prefix(unit) || value == 0.0)
    return fmt::format("{:.{}g} {}", value, digits, unit);
  constexpr std::array<std::string_view, 7> prefixes = {"n", "µ", "m", "", "k", "M", "G"};
  auto const power = static_cast<int>(std::floor(std::log10(std::abs(value)) / 3.0 + 1e-12));
  int last = 3;
  if (unit == "m")
    last = 0; // nobody says kilometre of a press,
  if (unit == "s")
    last = 0; // or kilosecond of a run
  auto const k = std::clamp(power, -3, last);
  double const shown = value / std::pow(1000.0, k);
  auto const prefix = prefixes[static_cast<std::size_t>(k + 3)];
  if (std::abs(shown) >= std::pow(10.0, digits - 1)) // an exponent or a bare point otherwise
    return fmt::format("{:.0f} {}{}", shown, prefix, unit);
  return fmt::format("{:#.{}g} {}{}", shown, digits, prefix, unit);
}

std::string fill_template(std::string_view page,
                          std::map<std::string, std::string, std::less<>> const& values) {
  std::string out;
  while (true) {
    auto const open = page.find("{{");
    if (open == std::string_view::npos)
      return out.append(page);
    auto const close = page.find("}}", open);
    if (close == std::string_view::npos)
      throw std::out_of_range("a {{ of the template is not closed");
    auto const name = page.substr(open + 2, close - open - 2);
    auto const found = values.find(name);
    if (found == values.end())
      throw std::out_of_range("the template asks for " + std::string(name));
    out.append(page.substr(0, open)).append(found->second);
    page.remove_prefix(close + 2);
  }
}

std::string encode_base64(std::span<std::byte const> bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    auto const n = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < 3; ++b)
      word = word << 8 | (b < n ? std::to_integer<std::uint32_t>(bytes[k + b]) : 0U);
    for (std::size_t d = 0; d < 4; ++d)
      out += d <= n ? digits[word >> (18 - 6 * d) & 63U] : '=';
  }
  return out;
}

} // namespace coupling
