#include "coupling/compare/compare.hpp"

#include "coupling/compare/force_curve.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace coupling {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Equal labels would make equal legends.
void tell_apart(std::vector<Source>& sources) {
  std::set<std::string> taken;
  for (auto& source : sources) {
    auto const plain = source.label;
    for (int n = 2; !taken.insert(source.label).second; ++n)
      source.label = fmt::format("{} ({})", plain, n);
  }
}

/// Adds what the curve tells; a value that the source states itself stays.
void add_values_of_curve(Source& source, std::optional<ForceCurve> const& curve) {
  auto const add = [&](char const* name, double value) {
    if (std::isfinite(value))
      source.values.try_emplace(name, SourceValue{value});
  };
  if (curve) {
    add("smallest_gap", curve->smallest_gap);
    add("loading_work", curve->loading_work);
    add("unloading_work", curve->unloading_work);
  }
  auto const largest = [&](char const* column) {
    double found = unknown;
    if (source.record.has(column))
      for (double const v : source.record.column(column))
        if (std::isfinite(v) && !(v <= found))
          found = v;
    return found;
  };
  add("max_force", largest("upper_punch_force"));
  add("max_wall_pressure", largest("wall_radial_pressure"));
  add("max_mean_overlap", largest("mean_overlap"));
  auto const height = source.values.find("compact_height");
  auto const gap = source.values.find("smallest_gap");
  if (height != source.values.end() && gap != source.values.end())
    add("springback", height->second.value / gap->second.value - 1.0);
}

std::vector<QuantityRow> kinds(Tolerances const& t) {
  auto const row = [](char const* name, char const* words, char const* unit, double tolerance,
                      bool is_relative) {
    return QuantityRow{name, words, unit, tolerance, is_relative, {}, {}, {}, {}};
  };
  return {row("max_force", "largest punch force", "N", t.force, true),
          row("max_wall_pressure", "largest wall pressure", "Pa", t.force, true),
          row("ejection_force", "ejection force", "N", t.force, true),
          row("smallest_gap", "smallest gap", "m", t.gap, true),
          row("compact_height", "compact height", "m", t.height, true),
          row("springback", "springback", "1", t.springback, false),
          row("porosity", "porosity", "1", t.porosity, false),
          row("porosity_core", "porosity of the core", "1", t.porosity, false),
          row("loading_work", "work of loading", "J", t.work, true),
          row("unloading_work", "work of unloading", "J", t.work, true),
          row("max_mean_overlap", "largest mean overlap", "m", t.overlap, true),
          row("shape_quality", "shape quality", "1", t.shape_quality, false)};
}

SourceValue value_of(Source const& source, std::string const& name) {
  auto const found = source.values.find(name);
  return found == source.values.end() ? SourceValue{unknown} : found->second;
}

void fill(QuantityRow& row, std::vector<Source> const& sources) {
  auto const reference = value_of(sources.front(), row.name);
  auto const scale = row.is_relative ? std::abs(reference.value) : 1.0;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    auto const own = value_of(sources[k], row.name);
    row.values.push_back(own.value);
    auto const difference = k == 0                         ? unknown
                            : own.value == reference.value ? 0.0
                                                           : (own.value - reference.value) / scale;
    row.differences.push_back(difference);
    auto const allowed = std::max(row.tolerance, 2.0 * std::hypot(own.sd, reference.sd) / scale);
    row.allowed.push_back(std::isfinite(allowed) ? allowed : row.tolerance);
    row.agreement.push_back(!std::isfinite(difference)        ? Agreement::unknown
                            : std::abs(difference) <= allowed ? Agreement::within
                                                              : Agreement::beyond);
  }
}

CurveRow curve_row(std::size_t source, char const* branch, BranchDifference const& found,
                   Tolerances const& t) {
  bool const is_within = found.largest <= t.curve_largest && found.rms <= t.curve_rms;
  return {source,       branch,    found.largest,
          found.at_gap, found.rms, is_within ? Agreement::within : Agreement::beyond};
}

void compare_curves(Comparison& comparison, std::vector<std::optional<ForceCurve>> const& curves,
                    Tolerances const& t) {
  auto const& sources = comparison.sources;
  std::string without;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (!curves[k])
      without += (without.empty() ? "" : ", ") + sources[k].label;
    if (k == 0 || !curves[0] || !curves[k])
      continue;
    auto const add = [&](char const* name, ForceBranch const& reference, ForceBranch const& own) {
      if (auto const found = difference(reference, own, curves[0]->peak))
        comparison.curves.push_back(curve_row(k, name, *found, t));
      else
        comparison.missing.push_back(fmt::format("{} and {} have no gaps in common while {}.",
                                                 sources[0].label, sources[k].label, name));
    };
    add("loading", curves[0]->loading, curves[k]->loading);
    add("unloading", curves[0]->unloading, curves[k]->unloading);
  }
  if (!without.empty())
    comparison.missing.push_back(
        "force over gap: no rows with both punch_gap and upper_punch_force in " + without + ".");
}

void compare_values(Comparison& comparison, Tolerances const& tolerances) {
  for (auto& row : kinds(tolerances)) {
    fill(row, comparison.sources);
    std::string without;
    for (std::size_t k = 0; k < row.values.size(); ++k)
      if (!std::isfinite(row.values[k]))
        without += (without.empty() ? "" : ", ") + comparison.sources[k].label;
    auto const n_known =
        std::ranges::count_if(row.values, [](double v) { return std::isfinite(v); });
    if (n_known > 0 && !without.empty())
      comparison.missing.push_back(fmt::format("{}: not known for {}.", row.words, without));
    if (n_known > 1)
      comparison.quantities.push_back(std::move(row));
  }
}

std::vector<std::string> what_is_beyond(Comparison const& c) {
  std::vector<std::string> which;
  for (auto const& row : c.quantities)
    for (std::size_t k = 0; k < row.agreement.size(); ++k)
      if (row.agreement[k] == Agreement::beyond)
        which.push_back(fmt::format("{} of {} {}", row.words, c.sources[k].label,
                                    row.is_relative
                                        ? fmt::format("{:+.2f} %", 100.0 * row.differences[k])
                                        : fmt::format("{:+.4g}", row.differences[k])));
  for (auto const& row : c.curves)
    if (row.agreement == Agreement::beyond)
      which.push_back(fmt::format("{} curve of {} up to {:.2f} % of the peak", row.branch,
                                  c.sources[row.source].label, 100.0 * row.largest));
  return which;
}

} // namespace

Comparison compare(std::vector<Source> sources, Tolerances const& tolerances) {
  VALIDATE(sources.size() > 1,
           fmt::format("{}: is the only source (a comparison needs two). Name another one?",
                       sources.empty() ? "compare" : sources[0].label));
  tell_apart(sources);
  std::vector<std::optional<ForceCurve>> curves;
  for (auto& source : sources) {
    curves.push_back(force_curve(source.record));
    add_values_of_curve(source, curves.back());
  }
  Comparison comparison{
      .sources = std::move(sources), .quantities = {}, .curves = {}, .missing = {}};
  compare_values(comparison, tolerances);
  compare_curves(comparison, curves, tolerances);
  VALIDATE(!comparison.quantities.empty() || !comparison.curves.empty(),
           fmt::format("{} and the others: have no quantity in common (curves need punch_gap and "
                       "upper_punch_force). "
                       "Are the columns named as in curves.csv?",
                       comparison.sources[0].label));
  return comparison;
}

std::size_t Comparison::n_compared() const {
  std::size_t n = curves.size();
  for (auto const& row : quantities)
    n += static_cast<std::size_t>(
        std::ranges::count_if(row.agreement, [](auto a) { return a != Agreement::unknown; }));
  return n;
}

std::size_t Comparison::n_beyond() const {
  auto n = std::ranges::count(curves, Agreement::beyond, &CurveRow::agreement);
  for (auto const& row : quantities)
    n += std::ranges::count(row.agreement, Agreement::beyond);
  return static_cast<std::size_t>(n);
}

std::string in_words(Comparison const& c) {
  auto const reference = c.sources[0].label;
  if (c.n_compared() == 0)
    return fmt::format("Nothing could be held against {}: it knows none of the others' numbers.",
                       reference);
  if (c.agrees())
    return fmt::format("All {} comparisons with {} are within their tolerances.", c.n_compared(),
                       reference);
  auto const which = what_is_beyond(c);
  constexpr std::size_t most = 6; // the table has them all
  auto text = fmt::format(
      "{} of {} comparisons with {} are beyond their tolerance: {}", c.n_beyond(), c.n_compared(),
      reference, fmt::join(which.begin(), which.begin() + std::min(most, which.size()), "; "));
  return text + (which.size() > most ? fmt::format("; and {} more.", which.size() - most) : ".");
}

} // namespace coupling
