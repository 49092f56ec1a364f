#include "tests/performance/speed_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace performance {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double median(Samples const& sorted) {
  std::size_t const half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
}

std::string verdict(double value, Bar bar) {
  if (bar.low == -infinity && bar.high == infinity)
    return "";
  std::string const wanted =
      bar.high == infinity ? fmt::format(">= {:g}", bar.low) : fmt::format("<= {:g}", bar.high);
  return wanted + (bar.low <= value && value <= bar.high ? "  ok" : "  MISSED");
}

} // namespace

Bar at_least(double value) {
  return {value, infinity};
}
Bar at_most(double value) {
  return {-infinity, value};
}
Bar no_bar() {
  return {-infinity, infinity};
}

bool print_row(std::string const& name, std::string const& unit, Samples samples, Bar bar) {
  std::ranges::sort(samples);
  double const middle = median(samples);
  fmt::print("{:<32} {:<16} min {:>9.4g}  median {:>9.4g}  max {:>9.4g}  {}\n", name, unit,
             samples.front(), middle, samples.back(), verdict(middle, bar));
  return bar.low <= middle && middle <= bar.high;
}

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name"))
      return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

} // namespace performance
