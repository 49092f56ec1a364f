#include "coupling/reduced/compact.hpp"

#include "dem/expect.hpp"
#include "dem/vec3.hpp"

#include <algorithm>

namespace coupling::reduced {
namespace {

/// Radial pressure that stays is carried over the height of the compact.
double ejection_force(PressedBed const& pressed, FreeCompact const& compact) {
  return pressed.law.wall_friction * compact.radial_pressure * dem::pi * pressed.bed.bore *
         compact.height;
}

double largest_force(std::vector<ChainReading> const& cycle) {
  return std::ranges::max_element(cycle, {}, &ChainReading::load_cell)->load_cell;
}

double mass_of(Press const& press) {
  auto const& bed = press.pressed.bed;
  return press.solid_density * bed.solid_area * 0.25 * dem::pi * bed.bore * bed.bore;
}

struct Number {
  std::string_view name;
  double (*of)(Press const&, std::vector<ChainReading> const&);
};

FreeCompact compact_of(Press const& press, std::vector<ChainReading> const& cycle) {
  auto const& pressed = press.pressed;
  return free_compact(pressed.law, pressed.bed, narrow_height(pressed, smallest_height(cycle)));
}

constexpr Number numbers[] = {
    {"compact_height",
     [](auto const& press, auto const& cycle) { return compact_of(press, cycle).height; }},
    {"compact_diameter", [](auto const& press, auto const&) { return press.pressed.bed.bore; }},
    {"compact_mass", [](auto const& press, auto const&) { return mass_of(press); }},
    {"porosity",
     [](auto const& press, auto const& cycle) {
       return 1.0 - press.pressed.bed.solid_area / compact_of(press, cycle).height;
     }},
    {"max_force", [](auto const&, auto const& cycle) { return largest_force(cycle); }},
    {"ejection_force",
     [](auto const& press, auto const& cycle) {
       return ejection_force(press.pressed, compact_of(press, cycle));
     }},
    {"gap_at_peak", [](auto const&, auto const& cycle) { return smallest_height(cycle); }},
    {"dead_weight", [](auto const& press, auto const&) {
       return press.machine.load_cell.gain * dead_weight + press.machine.load_cell.offset;
     }}};

} // namespace

bool is_foretold(std::string_view scalar) {
  return std::ranges::find(numbers, scalar, &Number::name) != std::end(numbers);
}

double compact_number(std::string_view scalar, Press const& press,
                      std::vector<ChainReading> const& cycle) {
  auto const found = std::ranges::find(numbers, scalar, &Number::name);
  EXPECT(found != std::end(numbers));
  return found->of(press, cycle);
}

} // namespace coupling::reduced
