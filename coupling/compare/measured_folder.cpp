#include "coupling/compare/measured_folder.hpp"

#include "coupling/compare/si_units.hpp"
#include "coupling/record/atomic_file.hpp"
#include "coupling/record/curves.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coupling {
namespace {

using Json = nlohmann::json;

SourceValue scalar(Json const& json, std::string const& name, std::string const& where) {
  auto const si = si_scale(json.at("unit").get<std::string>(), where + " " + name);
  return {si.factor * json.at("value").get<double>(), si.factor * json.value("sd", 0.0)};
}

Source run_of(Json const& run, std::filesystem::path const& folder, std::string const& where) {
  auto const file = folder / run.at("file").get<std::string>();
  Source source{.label = fmt::format("{} {}", folder.filename().string(), file.stem().string()),
                .record = in_si(read_curves(file), file.string()),
                .values = {}};
  auto const scalars = run.value("scalars", Json::object());
  for (auto const& [name, value] : scalars.items())
    source.values[name] = scalar(value, name, where);
  return source;
}

} // namespace

std::vector<Source> read_measured_folder(std::filesystem::path const& folder) {
  auto const file = folder / "measured.json";
  try {
    auto const json = Json::parse(read_file(file));
    std::vector<Source> sources;
    for (auto const& run : json.at("runs"))
      sources.push_back(run_of(run, std::filesystem::weakly_canonical(folder), file.string()));
    VALIDATE(!sources.empty(),
             file.string() + ": runs is empty (nothing was measured). Is it the right file?");
    return sources;
  } catch (Json::exception const& problem) {
    throw dem::InvalidInput(
        fmt::format("{}: {} (the file does not follow the form of measured data). "
                    "Is an entry missing or misspelt?",
                    file.string(), problem.what()));
  }
}

} // namespace coupling
