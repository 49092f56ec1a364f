#include "coupling/compare/source.hpp"

#include "coupling/compare/measured_folder.hpp"
#include "coupling/compare/si_units.hpp"
#include "coupling/compare/value_table.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "coupling/record/summary_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>

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

std::vector<Source> read_table(std::filesystem::path const& file, std::string const& setup = "") {
  std::vector<Source> sources;
  for (auto const& row : read_value_table(file)) {
    if (!setup.empty() && row.setup != setup)
      continue;
    auto const label = label_of(file) + (row.label.empty() ? "" : " " + row.label);
    Source source{.label = label, .record = PressRecord({}), .values = {}};
    for (auto const& v : row.values)
      source.values[v.name] = {v.value, std::isnan(v.sd) ? 0.0 : v.sd};
    sources.push_back(std::move(source));
  }
  VALIDATE(!sources.empty(),
           fmt::format("{}: has no setup {}. Which one of its column setup is meant?",
                       file.string(), setup));
  return sources;
}

/// "table7.csv:E0250_CED5_D500", where no file has that whole name.
std::vector<Source> read_setup(std::filesystem::path const& path) {
  auto const name = path.string();
  auto const colon = name.rfind(':');
  VALIDATE(colon != std::string::npos && std::filesystem::is_regular_file(name.substr(0, colon)),
           name + ": does not exist. Is the name right?");
  return read_table(name.substr(0, colon), name.substr(colon + 1));
}

} // namespace

std::map<std::string, SourceValue> values_of(Summary const& s) {
  std::map<std::string, SourceValue> values;
  auto const add = [&](char const* name, double value) {
    if (std::isfinite(value))
      values[name] = {value};
  };
  add("max_force", s.max_force);
  add("ejection_force", s.ejection_force);
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
  if (!std::filesystem::exists(path))
    return read_setup(path);
  if (std::filesystem::is_directory(path)) {
    if (std::filesystem::exists(path / "curves.csv"))
      return {read_run(path)};
    if (std::filesystem::exists(path / "measured.json"))
      return read_measured_folder(path);
    throw dem::InvalidInput(
        name + ": holds neither curves.csv nor measured.json (a run or measured data is needed). "
               "Is it the right folder?");
  }
  if (is_value_table(read_file(path), name))
    return read_table(path);
  return {{.label = label_of(path), .record = in_si(read_curves(path), name), .values = {}}};
}

} // namespace coupling
