#include "tests/diagnosis/grains/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hidden {
namespace {

std::vector<std::string> cells_of(std::string const& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');)
    cells.push_back(cell);
  return cells;
}

std::ifstream opened(std::filesystem::path const& file) {
  std::ifstream stream(file);
  if (!stream)
    throw std::runtime_error(
        fmt::format("{}: cannot be read. Did the simulation fail?", file.string()));
  return stream;
}

/// One line of a table by the names of its columns.
class Row {
public:
  Row(std::filesystem::path const& file, std::vector<std::string> const& header)
      : file_(file), header_(header) {}

  std::string const& text(std::string const& name) const {
    auto const at = std::ranges::find(header_, name) - header_.begin();
    if (static_cast<std::size_t>(at) >= cells.size())
      throw std::runtime_error(fmt::format("{}: has no column '{}' in some row. Is it a run of "
                                           "this version?",
                                           file_.string(), name));
    return cells[static_cast<std::size_t>(at)];
  }
  double number(std::string const& name) const {
    auto const& cell = text(name);
    double value = 0.0;
    auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size())
      throw std::runtime_error(fmt::format("{}: '{}' in column '{}' is no number. Was it cut off?",
                                           file_.string(), cell, name));
    return value;
  }
  std::vector<std::string> cells;

private:
  std::filesystem::path file_;
  std::vector<std::string> header_;
};

/// Before and after the lowest height.
Curve divided(std::vector<Pressed> const& all, std::filesystem::path const& file) {
  auto const turn = std::ranges::min_element(all, {}, &Pressed::height);
  if (turn - all.begin() < 10 || all.end() - turn < 10)
    throw std::runtime_error(
        fmt::format("{}: is no press cycle ({} records, the lowest punch at {}). Did it end early?",
                    file.string(), all.size(), turn - all.begin()));
  return {.loading = {all.begin(), turn + 1}, .unloading = {turn, all.end()}};
}

/// Linear between the records around a height, of a stroke in which heights only fall or only rise.
Pressed at_height(std::vector<Pressed> const& stroke, double height) {
  bool const rises = stroke.back().height > stroke.front().height;
  auto const after = std::ranges::lower_bound(stroke, rises ? height : -height, {}, [&](auto& at) {
    return rises ? at.height : -at.height;
  });
  auto const next = std::clamp(after, stroke.begin() + 1, stroke.end() - 1);
  auto const &a = *(next - 1), &b = *next;
  double const way = b.height - a.height;
  double const share = way != 0.0 ? std::clamp((height - a.height) / way, 0.0, 1.0) : 1.0;
  return {.height = height,
          .upper = a.upper + share * (b.upper - a.upper),
          .lower = a.lower + share * (b.lower - a.lower),
          .radial = a.radial + share * (b.radial - a.radial)};
}

} // namespace

double Curve::peak() const {
  return std::ranges::max_element(loading, {}, &Pressed::upper)->upper;
}

Curve mean_of(std::vector<Curve> const& curves) {
  Curve mean = curves.front();
  auto const n = static_cast<double>(curves.size());
  for (auto const stroke : {&Curve::loading, &Curve::unloading})
    for (auto& at : mean.*stroke) {
      Pressed sum{.height = at.height, .upper = 0.0, .lower = 0.0, .radial = 0.0};
      for (auto const& curve : curves) {
        auto const own = at_height(curve.*stroke, at.height);
        sum.upper += own.upper / n, sum.lower += own.lower / n, sum.radial += own.radial / n;
      }
      at = sum;
    }
  mean.compact_height = 0.0;
  for (auto const& curve : curves)
    mean.compact_height += curve.compact_height / n;
  return mean;
}

Curve scaled(Curve curve, double factor) {
  for (auto const stroke : {&Curve::loading, &Curve::unloading})
    for (auto& at : curve.*stroke)
      at.upper *= factor, at.lower *= factor, at.radial *= factor;
  return curve;
}

Curve read_run(std::filesystem::path const& folder) {
  auto const file = folder / "curves.csv";
  auto stream = opened(file);
  std::string line;
  std::getline(stream, line);
  Row row(file, cells_of(line));
  std::vector<Pressed> all;
  double compact_height = 0.0;
  while (std::getline(stream, line)) {
    row.cells = cells_of(line);
    auto const& stage = row.text("stage");
    compact_height = row.number("compact_height [m]");
    if (stage != "loading" && stage != "unloading")
      continue;
    all.push_back({.height = row.number("bed_height [m]"),
                   .upper = row.number("upper_punch_force [N]"),
                   .lower = row.number("lower_punch_force [N]"),
                   .radial = row.number("wall_radial_pressure [Pa]")});
  }
  auto curve = divided(all, file);
  curve.compact_height = compact_height;
  return curve;
}

Curve read_peer(std::filesystem::path const& file, double bore) {
  auto stream = opened(file);
  std::vector<Pressed> all;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    double time = 0.0, wall = 0.0;
    Pressed at{};
    if (words >> time >> at.height >> at.upper >> at.lower >> wall) {
      at.radial = wall / (std::numbers::pi * bore * at.height);
      all.push_back(at);
    }
  }
  return divided(all, file);
}

} // namespace hidden
