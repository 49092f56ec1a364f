#include "coupling/study/study_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace coupling::study {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json design_json(StudyFile const& study) {
  StudyDesign const& design = study.design;
  Json json{{"kind", design.kind_name}, {"replicates", design.replicates}};
  if (!design.results.empty())
    json["results"] = design.results.string();
  if (!design.table.empty())
    json["table"] = design.table.string();
  return json;
}

Json factor_json(StudyFactor const& factor) {
  Json entries = Json::array();
  for (auto const& entry : factor.entries)
    entries.push_back(
        {{"entry", entry.path}, {"multiplier", entry.multiplier}, {"pattern", entry.pattern}});
  return {{"name", factor.name},
          {"unit", factor.si_unit()},
          {"low", number(factor.low)},
          {"high", number(factor.high)},
          {"entries", entries}};
}

Json response_json(StudyResponse const& response) {
  Json json{{"name", response.name}, {"quantity", response.quantity}, {"unit", response.unit}};
  json["target"] = response.target ? Json(*response.target) : Json(nullptr);
  json["target_uncertainty"] = response.uncertainty ? Json(*response.uncertainty) : Json(nullptr);
  return json;
}

Json run_json(ResultRow const& row, std::vector<StudyFactor> const& factors) {
  Json json{{"run", row.run.id},
            {"setup", row.run.setup},
            {"replicate", row.run.replicate},
            {"role", row.run.is_validation ? "validation" : "design"},
            {"status", word(row.state)},
            {"case", row.run.hash}};
  if (!row.folder.empty())
    json["folder"] = row.folder.string();
  if (!row.reason.empty())
    json["reason"] = row.reason;
  for (std::size_t f = 0; f < factors.size(); ++f)
    json["factors"][factors[f].name] = {{"natural", number(row.run.natural[f])},
                                        {"coded", number(factors[f].coded(row.run.natural[f]))}};
  json["cost"] = {{"grains", row.estimate.grains},
                  {"steps", row.estimate.steps},
                  {"particle_steps", row.estimate.particle_steps()},
                  {"expected_cpu_seconds", row.estimate.cpu_seconds()},
                  {"cpu_seconds", row.cpu_seconds},
                  {"wall_seconds", row.wall_seconds}};
  return json;
}

Json cost_json(ResultsTable const& table) {
  double expected = 0.0, used = 0.0, particle_steps = 0.0, done_steps = 0.0, done_seconds = 0.0;
  for (auto const& row : table.rows) {
    expected += row.estimate.cpu_seconds();
    used += row.cpu_seconds;
    particle_steps += row.estimate.particle_steps();
    if (row.is_done()) {
      done_steps += row.estimate.particle_steps();
      done_seconds += row.cpu_seconds;
    }
  }
  return {{"runs", table.rows.size()},
          {"particle_steps", particle_steps},
          {"expected_cpu_seconds", expected},
          {"cpu_seconds", used},
          {"seconds_per_particle_step",
           done_steps > 0.0 ? number(done_seconds / done_steps) : Json(nullptr)}};
}

} // namespace

std::string study_json(ResultsTable const& table) {
  Json json;
  json["title"] = table.study.title;
  json["version"] = PRESSCHECK_VERSION;
  json["case"] = table.study.case_file.string();
  json["design"] = design_json(table.study);
  json["factors"] = Json::array();
  for (auto const& factor : table.study.factors)
    json["factors"].push_back(factor_json(factor));
  json["responses"] = Json::array();
  for (auto const& response : table.study.responses)
    json["responses"].push_back(response_json(response));
  json["runs"] = Json::array();
  for (auto const& row : table.rows)
    json["runs"].push_back(run_json(row, table.study.factors));
  json["cost"] = cost_json(table);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace coupling::study
