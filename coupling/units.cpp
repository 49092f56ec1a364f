#include "coupling/units.hpp"

#include "coupling/nearest_name.hpp"
#include "coupling/quote.hpp"
#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coupling {

namespace {

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
};

constexpr Dimension none{}, mass{.mass = 1}, length{.length = 1}, time_{.time = 1};
constexpr Dimension force{1, 1, -2}, pressure{1, -1, -2}, energy{1, 2, -2};

constexpr std::array units = {
    NamedUnit{"1", {none}},
    NamedUnit{"%", {none, -2}},
    NamedUnit{"rad", {none}},
    NamedUnit{"deg", {none, 0, dem::pi / 180.0}},
    NamedUnit{"m", {length}},
    NamedUnit{"km", {length, 3}},
    NamedUnit{"cm", {length, -2}},
    NamedUnit{"mm", {length, -3}},
    NamedUnit{"um", {length, -6}},
    NamedUnit{"\u00b5m", {length, -6}}, // micro sign
    NamedUnit{"\u03bcm", {length, -6}}, // Greek mu
    NamedUnit{"nm", {length, -9}},
    NamedUnit{"kg", {mass}},
    NamedUnit{"g", {mass, -3}},
    NamedUnit{"mg", {mass, -6}},
    NamedUnit{"ug", {mass, -9}},
    NamedUnit{"t", {mass, 3}},
    NamedUnit{"s", {time_}},
    NamedUnit{"ms", {time_, -3}},
    NamedUnit{"us", {time_, -6}},
    NamedUnit{"ns", {time_, -9}},
    NamedUnit{"min", {time_, 0, 60.0}},
    NamedUnit{"h", {time_, 0, 3600.0}},
    NamedUnit{"N", {force}},
    NamedUnit{"mN", {force, -3}},
    NamedUnit{"kN", {force, 3}},
    NamedUnit{"MN", {force, 6}},
    NamedUnit{"Pa", {pressure}},
    NamedUnit{"kPa", {pressure, 3}},
    NamedUnit{"MPa", {pressure, 6}},
    NamedUnit{"GPa", {pressure, 9}},
    NamedUnit{"bar", {pressure, 5}},
    NamedUnit{"J", {energy}},
    NamedUnit{"mJ", {energy, -3}},
    NamedUnit{"kJ", {energy, 3}},
    NamedUnit{"MJ", {energy, 6}},
};

Unit find_unit(std::string_view symbol) {
  auto const found = std::ranges::find(units, symbol, &NamedUnit::symbol);
  if (found != units.end())
    return found->unit;
  std::vector<std::string> known;
  for (NamedUnit const& unit : units)
    known.emplace_back(unit.symbol);
  throw dem::InvalidInput(
      fmt::format("'{}' is no unit that presscheck knows (units are case-sensitive).{}",
                  quote(symbol), did_you_mean(symbol, known, "Write it in SI units?")));
}

Unit raise(Unit const& unit, int power) {
  return {.dimension = {unit.dimension.mass * power, unit.dimension.length * power,
                        unit.dimension.time * power},
          .decade = unit.decade * power,
          .multiplier = std::pow(unit.multiplier, power)};
}

Unit multiply(Unit const& a, Unit const& b) {
  return {.dimension = {a.dimension.mass + b.dimension.mass,
                        a.dimension.length + b.dimension.length,
                        a.dimension.time + b.dimension.time},
          .decade = a.decade + b.decade,
          .multiplier = a.multiplier * b.multiplier};
}

/// `m` or `m^3`. `m3` is refused with the other unknown names.
Unit parse_factor(std::string_view factor) {
  auto const caret = factor.find('^');
  if (caret == std::string_view::npos)
    return find_unit(factor);
  std::string_view const power = factor.substr(caret + 1);
  bool const is_negative = power.starts_with('-');
  std::string_view const digit = power.substr(is_negative ? 1 : 0);
  VALIDATE(digit.size() == 1 && digit[0] >= '1' && digit[0] <= '9',
           fmt::format("'{}' is no power of a unit (a caret is followed by 1 to 9). Write m^3?",
                       quote(factor)));
  return raise(find_unit(factor.substr(0, caret)), (digit[0] - '0') * (is_negative ? -1 : 1));
}

} // namespace

Unit parse_unit(std::string_view text) {
  Unit product;
  int sign = 1;
  while (true) {
    auto const end = text.find_first_of("/* ");
    product = multiply(product, raise(parse_factor(text.substr(0, end)), sign));
    if (end == std::string_view::npos)
      return product;
    sign = text[end] == '/' ? -1 : 1;
    text.remove_prefix(end + 1);
  }
}

} // namespace coupling
