#include "tests/diagnosis/hide/cases.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace hidden {
namespace {

constexpr std::array<std::string_view, 4> classes = {"clean", "single", "double", "unknown"};
constexpr std::array<std::string_view, 5> sets = {"A", "D", "E", "F", "G"};

constexpr std::array<std::string_view, 11> extras = {
    "nothing",     "compact_height", "compact_mass", "compact_diameter",
    "gap_at_peak", "dead_weight",    "dwell_60",     "dwell_600",
    "fast",        "slow",           "wider"};

template <class Value, std::size_t n>
Value named(std::array<std::string_view, n> const& names, std::string_view name,
            std::string_view what) {
  for (std::size_t k = 0; k < n; ++k)
    if (names[k] == name)
      return static_cast<Value>(k);
  throw std::invalid_argument(
      fmt::format("{} '{}' is none of {}. Is it misspelt?", what, name, fmt::join(names, ", ")));
}

} // namespace

CaseClass class_named(std::string_view name) {
  return named<CaseClass>(classes, name, "class");
}
Observables observables_named(std::string_view name) {
  return named<Observables>(sets, name, "observables");
}
Extra extra_named(std::string_view name) {
  return named<Extra>(extras, name, "measurement");
}
bool is_pressing(Extra extra) {
  return extra >= Extra::dwell_60;
}
std::string_view name_of(CaseClass kind) {
  return classes[static_cast<std::size_t>(kind)];
}
std::string_view name_of(Observables set) {
  return sets[static_cast<std::size_t>(set)];
}

bool has_all_gauges(Observables set) {
  return set != Observables::A && set != Observables::F;
}
bool has_compact_height(Observables set) {
  return set != Observables::A;
}

} // namespace hidden
