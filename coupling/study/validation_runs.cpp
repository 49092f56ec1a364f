#include "coupling/study/validation_runs.hpp"

#include "coupling/record/atomic_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace coupling::study {
namespace {

using Json = nlohmann::ordered_json;

/// A point and its number of packings, as kept in `validation.json`.
Json read_kept(BatchFolder const& folder) {
  auto const file = folder.path() / "validation.json";
  if (!std::filesystem::exists(file))
    return Json::array();
  auto const json = Json::parse(read_file(file), nullptr, false);
  return json.is_array() ? json : Json::array();
}

} // namespace

std::vector<StudyRun> add_validation_runs(StudyPlan const& plan, BatchFolder const& folder,
                                          std::span<double const> natural, int replicates) {
  auto runs = runs_at(plan, "validation", natural, replicates);
  folder.add_cases(runs);
  Json const point{{"natural", std::vector<double>(natural.begin(), natural.end())},
                   {"replicates", replicates}};
  auto kept = read_kept(folder);
  if (std::ranges::find(kept, point) == kept.end()) {
    kept.push_back(point);
    write_file(folder.path() / "validation.json", kept.dump(1) + "\n");
  }
  return runs;
}

std::vector<StudyRun> kept_validation_runs(StudyPlan const& plan, BatchFolder const& folder) {
  std::vector<StudyRun> runs;
  for (auto const& point : read_kept(folder)) {
    auto const natural = point.at("natural").get<std::vector<double>>();
    if (natural.size() != plan.study.factors.size())
      continue; // of a study that had other factors
    for (auto& run : runs_at(plan, "validation", natural, point.at("replicates").get<int>()))
      if (std::ranges::count(runs, run.id, &StudyRun::id) == 0)
        runs.push_back(std::move(run));
  }
  return runs;
}

} // namespace coupling::study
