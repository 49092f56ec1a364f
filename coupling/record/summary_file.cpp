#include "coupling/record/summary_file.hpp"

#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace coupling {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number(Json const& json) {
  return json.is_null() ? ToolSummary::none : json.get<double>();
}

Json to_json(Check const& check) {
  return {{"name", check.name},
          {"value", number(check.value)},
          {"tolerance", number(check.tolerance)},
          {"ok", check.ok}};
}

Check check_from(Json const& json) {
  return {json.at("name"), number(json.at("value")), number(json.at("tolerance")), json.at("ok")};
}

Json to_json(ToolSummary const& tool) {
  Json json{{"name", tool.name}, {"max_von_mises_Pa", number(tool.max_von_mises)}};
  json["where_m"] = Json(nullptr);
  if (tool.where.allFinite())
    json["where_m"] = {tool.where.x(), tool.where.y(), tool.where.z()};
  json["valid_below_depth_m"] = number(tool.valid_below_depth);
  json["yield_utilisation"] = number(tool.yield_utilisation);
  json["contact_share"] = number(tool.contact_share);
  return json;
}

ToolSummary tool_from(Json const& json) {
  ToolSummary tool{.name = json.at("name"), .max_von_mises = number(json.at("max_von_mises_Pa"))};
  Json const& where = json.at("where_m");
  if (!where.is_null())
    tool.where = {where.at(0).get<double>(), where.at(1).get<double>(), where.at(2).get<double>()};
  tool.valid_below_depth = number(json.at("valid_below_depth_m"));
  tool.yield_utilisation = number(json.at("yield_utilisation"));
  tool.contact_share = number(json.value("contact_share", Json(nullptr)));
  return tool;
}

Summary summary_from(Json const& json) {
  Summary summary;
  summary.max_force = number(json.at("max_force_N"));
  summary.ejection_force = number(json.value("ejection_force_N", Json(nullptr)));
  summary.porosity = number(json.at("porosity"));
  summary.porosity_core = number(json.at("porosity_core"));
  summary.compact_height = number(json.at("compact_height_m"));
  summary.springback = number(json.at("springback"));
  summary.shape_quality =
      json.at("shape_quality").is_null() ? 0 : json.at("shape_quality").get<int>();
  summary.shape_similarity = number(json.at("shape_similarity"));
  summary.grains = json.at("grains");
  summary.steps = json.at("steps");
  summary.time_step = number(json.at("time_step_s"));
  summary.wall_seconds = number(json.at("wall_seconds"));
  summary.particle_steps_per_second = number(json.at("particle_steps_per_second"));
  summary.mode = json.at("mode");
  summary.version = json.at("version");
  for (Json const& check : json.at("checks"))
    summary.checks.push_back(check_from(check));
  for (Json const& tool : json.at("tools"))
    summary.tools.push_back(tool_from(tool));
  return summary;
}

} // namespace

std::string summary_json(Summary const& summary) {
  Json json;
  json["max_force_N"] = number(summary.max_force);
  json["ejection_force_N"] = number(summary.ejection_force);
  json["porosity"] = number(summary.porosity);
  json["porosity_core"] = number(summary.porosity_core);
  json["compact_height_m"] = number(summary.compact_height);
  json["springback"] = number(summary.springback);
  json["shape_quality"] = summary.shape_quality == 0 ? Json(nullptr) : Json(summary.shape_quality);
  json["shape_similarity"] = number(summary.shape_similarity);
  json["grains"] = summary.grains;
  json["steps"] = summary.steps;
  json["time_step_s"] = number(summary.time_step);
  json["wall_seconds"] = number(summary.wall_seconds);
  json["particle_steps_per_second"] = number(summary.particle_steps_per_second);
  json["mode"] = summary.mode;
  json["version"] = summary.version;
  json["checks"] = Json::array();
  for (Check const& check : summary.checks)
    json["checks"].push_back(to_json(check));
  json["tools"] = Json::array();
  for (ToolSummary const& tool : summary.tools)
    json["tools"].push_back(to_json(tool));
  // Bytes that are no UTF-8 (a tool's name from an old file) become a replacement mark instead of
  // ending the run.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(std::filesystem::path const& file, Summary const& summary) {
  write_file(file, summary_json(summary));
}

Summary read_summary(std::filesystem::path const& file) {
  try {
    return summary_from(Json::parse(read_file(file)));
  } catch (Json::exception const& error) {
    throw dem::InvalidInput(
        fmt::format("{}: cannot be understood: {} (it is no summary of a run). Was it edited?",
                    file.string(), error.what()));
  }
}

} // namespace coupling
