#include "coupling/quantity.hpp"

#include "coupling/units.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace coupling {

PhysicalName const& describe(Physical physical) {
  static constexpr PhysicalName names[] = {
      {"a ratio", "", "a bare number or %", {}},
      {"a length", "m", "m, mm, um", {0, 1, 0}},
      {"a mass", "kg", "kg, g, mg", {1, 0, 0}},
      {"a time", "s", "s, ms, us, min", {0, 0, 1}},
      {"a speed", "m/s", "m/s, mm/s, mm/min", {0, 1, -1}},
      {"an acceleration", "m/s^2", "m/s^2", {0, 1, -2}},
      {"a stiffness", "N/m", "N/m, kN/mm", {1, 0, -2}},
      {"an angular speed", "rad/s", "rad/s, 1/s", {0, 0, -1}},
      {"a force", "N", "N, kN", {1, 1, -2}},
      {"a modulus or pressure", "Pa", "Pa, kPa, MPa, GPa", {1, -1, -2}},
      {"a density", "kg/m^3", "kg/m^3, g/cm^3", {1, -3, 0}},
      {"an energy density", "J/m^3", "J/m^3, kJ/m^3, MJ/m^3", {1, -1, -2}},
      {"an energy per area", "J/m^2", "J/m^2, mJ/m^2", {1, 0, -2}},
      {"a force rate", "N/s", "N/s, N/min", {1, 1, -3}},
  };
  return names[static_cast<std::size_t>(physical)];
}

namespace {

std::string_view trim(std::string_view text) {
  auto const first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Length of the leading decimal number, 0 if there is none:  [+-] digits [. digits] [e [+-]
/// digits]
std::size_t number_length(std::string_view text) {
  auto const skip_digits = [&](std::size_t at) {
    while (at < text.size() && text[at] >= '0' && text[at] <= '9')
      ++at;
    return at;
  };
  std::size_t const start = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  std::size_t end = skip_digits(start);
  std::size_t n_digits = end - start;
  if (end < text.size() && text[end] == '.') {
    std::size_t const fraction = skip_digits(end + 1);
    n_digits += fraction - end - 1;
    end = fraction;
  }
  if (n_digits == 0)
    return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+'))
      ++exponent;
    if (skip_digits(exponent) > exponent)
      end = skip_digits(exponent);
  }
  return end;
}

/// The number times 10^decade, rounded once.
double scaled_number(std::string_view number, int decade) {
  if (number.starts_with('+'))
    number.remove_prefix(1);
  auto const e = number.find_first_of("eE");
  long exponent = decade;
  if (e != std::string_view::npos) {
    long written = 0;
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+'))
      digits.remove_prefix(1);
    auto const read = std::from_chars(digits.data(), digits.data() + digits.size(), written);
    VALIDATE(read.ec == std::errc{} && std::abs(written) < 10000,
             "is too large or too small for a number (double precision ends at 1e308). Check the "
             "exponent?");
    exponent += written;
  }
  std::string const text = fmt::format("{}e{}", number.substr(0, e), exponent);
  double value = 0.0;
  auto const read = std::from_chars(text.data(), text.data() + text.size(), value);
  VALIDATE(read.ec == std::errc{} && std::isfinite(value),
           "is too large or too small for a number (double precision ends at 1e308). Check the "
           "exponent?");
  return value;
}

/// What is wrong with a text that does not start with a number.
std::string no_number(std::string_view text, PhysicalName const& physical) {
  if (text.empty())
    return fmt::format("is empty ({} is needed). Give it a value?", physical.words);
  auto const at = text.find_first_not_of("+-");
  char const first = at == std::string_view::npos ? ' ' : text[at];
  if (first == 'n' || first == 'N' || first == 'i' || first == 'I')
    return fmt::format("is no finite number ({} is needed). Give it a value?", physical.words);
  return fmt::format("does not start with a number ({} is needed, in {}). Give it a value?",
                     physical.words, physical.examples);
}

} // namespace

double parse_quantity(std::string_view text, Physical physical) {
  PhysicalName const& name = describe(physical);
  text = trim(text);
  std::size_t const length = number_length(text);
  VALIDATE(length > 0, no_number(text, name));
  std::string_view const number = text.substr(0, length);
  std::string_view const unit_text = trim(text.substr(length));
  if (unit_text.empty())
    return scaled_number(number, 0);

  VALIDATE(unit_text[0] != ',',
           fmt::format("holds a comma (decimals are written with a point). Write {}.{}?", number,
                       unit_text.substr(1)));
  Unit const unit = parse_unit(unit_text);
  VALIDATE(unit.dimension == name.dimension,
           fmt::format("has a unit that does not fit ({} is needed). Write it in {}?", name.words,
                       name.examples));
  double const value = scaled_number(number, unit.decade) * unit.multiplier;
  VALIDATE(std::isfinite(value),
           "is too large for a number (double precision ends at 1e308). Check the exponent?");
  return value;
}

std::string print_number(double value) {
  return fmt::format("{}", value);
}

std::string print_quantity(double value, Physical physical) {
  std::string_view const si = describe(physical).si;
  return si.empty() ? print_number(value) : fmt::format("{} {}", value, si);
}

} // namespace coupling
