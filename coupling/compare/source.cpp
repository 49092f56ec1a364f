#include "coupling/compare/source.hpp"

#include "coupling/compare/measured_folder.hpp"
#include "coupling/compare/si_units.hpp"
#include "coupling/compare/value_table.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/summary_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling {
namespace {

/// "runs/quick/" -> "quick"
std::string label_of(std::filesystem::path const& path) {
  auto const name = path.filename().empty() ? path.parent_path().filename() : path.filename();
  return name.extension() == ".csv" ? name.stem().string() : name.string();
}

Source read_run(std::filesystem::path const& folder) {
  auto const curves = folder / "curves.csv";
  Source source{.label = label_of(folder),
                .record = in_si(read_curves(curves), curves.string()),
                .values = {}};
  if (auto const summary = folder / "summary.json"; std::filesystem::exists(summary))
    source.values = values_of(read_summary(summary));
  return source;
}

std::vector<Source> read_table(std::filesystem::path const& file) {
  std::vector<Source> sources;
  for (auto const& [setup, value] : read_value_table(file)) {
    auto const label = setup.empty() ? label_of(file) : label_of(file) + " " + setup;
    auto found = std::ranges::find(sources, label, &Source::label);
    if (found == sources.end()) {
      sources.push_back({.label = label, .record = PressRecord({}), .values = {}});
      found = sources.end() - 1;
    }
    found->values[value.name] = {value.value, std::isnan(value.sd) ? 0.0 : value.sd};
  }
  return sources;
}

} // namespace

std::map<std::string, SourceValue> values_of(Summary const& s) {
  std::map<std::string, SourceValue> values;
  auto const add = [&](char const* name, double value) {
    if (std::isfinite(value))
      values[name] = {value};
  };
  add("max_force", s.max_force);
  add("porosity", s.porosity);
  add("porosity_core", s.porosity_core);
  add("compact_height", s.compact_height);
  add("springback", s.springback);
  if (s.shape_quality > 0)
    add("shape_quality", s.shape_quality);
  return values;
}

std::vector<Source> read_sources(std::filesystem::path const& path) {
  auto const name = path.string();
  VALIDATE(std::filesystem::exists(path), name + ": does not exist. Is the name right?");
  if (std::filesystem::is_directory(path)) {
    if (std::filesystem::exists(path / "curves.csv"))
      return {read_run(path)};
    if (std::filesystem::exists(path / "measured.json"))
      return read_measured_folder(path);
    throw dem::InvalidInput(
        name + ": holds neither curves.csv nor measured.json (a run or measured data is needed). "
               "Is it the right folder?");
  }
  if (is_value_table(read_file(path)))
    return read_table(path);
  return {{.label = label_of(path), .record = in_si(read_curves(path), name), .values = {}}};
}

} // namespace coupling
