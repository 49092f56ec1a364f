#include "coupling/study/study_points.hpp"

#include "coupling/case_setups.hpp"
#include "coupling/study/design.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::study {
namespace {

constexpr double rounding = 1e-9; // of a value that a table writes out

PlacedValue const* find_value(std::vector<PlacedValue> const& values, std::string_view path) {
  auto const found = std::ranges::find(values, path, &PlacedValue::path);
  return found == values.end() ? nullptr : &*found;
}

AxialPoints axial_points_of(std::string const& name) {
  if (name == "circumscribed")
    return AxialPoints::circumscribed;
  return name == "inscribed" ? AxialPoints::inscribed : AxialPoints::face_centred;
}

Eigen::MatrixXd coded_design(StudyFile const& study) {
  StudyDesign const& design = study.design;
  auto const n_factors = static_cast<int>(study.factors.size());
  if (design.kind == DesignKind::central_composite)
    return central_composite(n_factors, axial_points_of(design.axial_points), design.centre_runs);
  if (design.kind == DesignKind::latin_hypercube)
    return latin_hypercube(n_factors, design.runs, design.seed);
  std::vector<int> n_levels;
  for (auto const& factor : study.factors)
    n_levels.push_back(static_cast<int>(factor.levels.size()));
  return full_factorial(n_levels);
}

/// The value at a coded place: a level where there are levels, which need not be equally spaced.
double natural_value(StudyFactor const& factor, double coded) {
  if (factor.levels.empty())
    return factor.rounded(factor.natural(coded));
  auto const last = static_cast<double>(factor.levels.size() - 1);
  return factor.levels.at(static_cast<std::size_t>(std::lround(0.5 * (coded + 1.0) * last)));
}

std::vector<StudyPoint> generated_points(StudyFile const& study) {
  auto const coded = coded_design(study);
  std::vector<StudyPoint> points;
  std::vector<Eigen::Index> rows; // of the design, where each point stands first
  for (Eigen::Index r = 0; r < coded.rows(); ++r) {
    std::vector<double> natural;
    for (std::size_t f = 0; f < study.factors.size(); ++f)
      natural.push_back(natural_value(study.factors[f], coded(r, static_cast<Eigen::Index>(f))));
    auto point = point_at(study, natural);
    auto const same = std::ranges::find(points, point.name, &StudyPoint::name);
    if (same == points.end()) {
      points.push_back(std::move(point));
      rows.push_back(r);
      continue;
    }
    auto const first = rows[static_cast<std::size_t>(same - points.begin())];
    if (coded.row(first) != coded.row(r))
      study.text.refuse("Design/Kind",
                        fmt::format("makes two runs with one name, '{}' (values are told apart by "
                                    "six digits). Move low and high apart, or fewer runs?",
                                    point.name));
    ++same->times;
  }
  return points;
}

std::vector<NamedSetup> chosen_setups(StudyFile const& study) {
  auto const all = read_setups(study.design.table);
  if (study.design.rows.empty())
    return all;
  std::vector<NamedSetup> chosen;
  for (auto const& name : study.design.rows) {
    try {
      chosen.push_back(find_setup(all, name, study.design.table));
    } catch (dem::InvalidInput const& problem) {
      study.text.refuse("Design/Rows", problem.what());
    }
    if (std::ranges::count(study.design.rows, name) > 1)
      study.text.refuse("Design/Rows", fmt::format("names '{}' twice. Name it once?", name));
  }
  return chosen;
}

/// The value of a factor in a row; the factor's other entries must agree, or be left to it.
double value_of_row(StudyFile const& study, StudyFactor const& factor, NamedSetup const& setup,
                    std::vector<PlacedValue>& values) {
  auto const* const first = find_value(setup.values, factor.entries[0].path);
  VALIDATE(first != nullptr,
           fmt::format("{}: setup '{}' says nothing of {} (factor '{}' of {} takes its value from "
                       "there). Add the column, or leave out the factor?",
                       setup.where, setup.name, factor.entries[0].path, factor.name, factor.where));
  double const natural = value_in(factor, factor.entries[0], *first);
  for (auto const& entry : factor.entries) {
    auto const* const written = find_value(setup.values, entry.path);
    if (written == nullptr)
      continue;
    double const own = value_in(factor, entry, *written);
    if (std::abs(own - natural) > rounding * std::abs(natural))
      refuse_entry(written->where, written->path, written->text,
                   fmt::format("does not follow factor '{}' = {} (its Entries in {} say {} times "
                               "the value). Correct one of them?",
                               factor.name, factor.text(natural), study.text.name(),
                               entry.multiplier));
  }
  for (auto& value : factor.values(natural))
    if (find_value(setup.values, value.path) == nullptr)
      values.push_back(std::move(value));
  return natural;
}

StudyPoint point_of_row(StudyFile& study, NamedSetup const& setup) {
  StudyPoint point{setup.name, setup.where, {}, setup.values, 1};
  for (auto const& value : setup.values)
    if (auto const* const common = find_value(study.common, value.path))
      refuse_entry(common->where, common->path, common->text,
                   fmt::format("is set by the table, too ({}: one of them would be lost). Remove "
                               "one?",
                               value.where));
  for (auto& factor : study.factors) {
    if (factor.unit.empty())
      if (auto const* const first = find_value(setup.values, factor.entries[0].path)) {
        auto const& pattern = factor.entries[0].pattern;
        auto const hole = pattern.find("{}");
        auto const tail = pattern.size() - hole - 2;
        if (first->text.size() >= hole + tail)
          factor.unit =
              unit_of(std::string_view(first->text).substr(hole, first->text.size() - hole - tail));
      }
    point.natural.push_back(value_of_row(study, factor, setup, point.values));
  }
  return point;
}

/// Limits of factors that a table leaves open: its smallest and largest values.
void close_limits(StudyFile& study, std::vector<StudyPoint> const& points) {
  for (std::size_t f = 0; f < study.factors.size(); ++f) {
    auto& factor = study.factors[f];
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    for (auto const& point : points) {
      least = std::min(least, point.natural[f]);
      largest = std::max(largest, point.natural[f]);
    }
    VALIDATE(least < largest,
             fmt::format("{}: factor '{}' = {} in all {} rows (a constant cannot be fitted). Other "
                         "rows, or without this factor?",
                         factor.where, factor.name, factor.text(least), points.size()));
    if (std::isnan(factor.low)) {
      factor.low = least;
      factor.high = largest;
    }
  }
}

/// What all rows of a table have in common beside the factors holds for runs beside the table, too.
void keep_shared(StudyFile& study, std::vector<NamedSetup> const& setups) {
  for (auto const& value : setups.front().values) {
    bool const is_shared = std::ranges::all_of(setups, [&](auto const& setup) {
      auto const* const own = find_value(setup.values, value.path);
      return own != nullptr && own->text == value.text;
    });
    bool const is_factor = std::ranges::any_of(study.factors, [&](auto const& factor) {
      return std::ranges::count(factor.entries, value.path, &FactorEntry::path) > 0;
    });
    if (is_shared && !is_factor)
      study.common.push_back(value);
  }
}

} // namespace

StudyPoint point_at(StudyFile const& study, std::span<double const> natural) {
  StudyPoint point{"", study.text.where("Design/Kind"), {natural.begin(), natural.end()}, {}, 1};
  for (std::size_t f = 0; f < study.factors.size(); ++f) {
    point.name += (f == 0 ? "" : "_") + study.factors[f].name_of(natural[f]);
    for (auto& value : study.factors[f].values(natural[f]))
      point.values.push_back(std::move(value));
  }
  return point;
}

std::vector<StudyPoint> points_of(StudyFile& study) {
  if (study.design.kind != DesignKind::table)
    return generated_points(study);
  std::vector<StudyPoint> points;
  auto const setups = chosen_setups(study);
  for (auto const& setup : setups)
    points.push_back(point_of_row(study, setup));
  close_limits(study, points);
  keep_shared(study, setups);
  return points;
}

} // namespace coupling::study
