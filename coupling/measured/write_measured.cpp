#include "coupling/measured/write_measured.hpp"

#include "coupling/measured/channel_kinds.hpp"
#include "coupling/record/atomic_file.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace coupling::measured {
namespace {

using Json = nlohmann::ordered_json;

std::string csv_name(std::string const& file) {
  return file.ends_with(".csv") ? file : file + ".csv";
}

Json uncertain_json(Uncertain const& quantity, Physical physical) {
  std::string const si(describe(physical).si);
  return {{"value", quantity.value}, {"sd", quantity.sd}, {"unit", si.empty() ? "1" : si}};
}

Json press_json(PressProtocol const& press) {
  Json json = {{"speed_down", press.speed_down},
               {"speed_up", press.speed_up},
               {"end_gap", press.end_gap},
               {"fill_height", press.fill_height},
               {"unit", "SI"}};
  if (press.dwell)
    json["dwell"] = *press.dwell;
  return json;
}

Json run_json(Run const& run) {
  Json json = {{run.has_curve() ? "file" : "name", run.has_curve() ? csv_name(run.file) : run.file},
               {"role", run.role == Role::fit ? "fit" : "held-out"},
               {"press", press_json(run.press)}};
  for (auto const& [name, value] : run.scalars)
    json["scalars"][name] = uncertain_json(value, find_kind(scalar_kinds(), name)->physical);
  if (run.clock_sd > 0.0)
    json["clock"] = {{"sd", run.clock_sd}};
  return json;
}

Json decision_json(Decision const& decision) {
  Json json = Json::object();
  if (!decision.file.empty())
    json["file"] = decision.file;
  if (decision.row > 0)
    json["row"] = decision.row;
  json["what"] = decision.what;
  return json;
}

std::string description(MeasuredData const& data) {
  Json json = {{"sample",
                {{"mass", uncertain_json(data.sample.mass, Physical::mass)},
                 {"die_diameter", uncertain_json(data.sample.die_diameter, Physical::length)}}},
               {"channels", Json::object()},
               {"gap_source", data.gap_source == GapSource::commanded ? "commanded" : "measured"},
               {"runs", Json::array()}};
  if (data.sample.solid_density)
    json["sample"]["solid_density"] = uncertain_json(*data.sample.solid_density, Physical::density);
  for (auto const& channel : data.channels) {
    json["channels"][channel.name] = {{"unit", channel.unit}, {"sd", channel.sd}};
    if (channel.sd_relative > 0.0)
      json["channels"][channel.name]["sd_relative"] = channel.sd_relative;
  }
  for (auto const& run : data.runs)
    json["runs"].push_back(run_json(run));
  for (auto const& decision : data.decisions)
    json["decisions"].push_back(decision_json(decision));
  // A decision may quote a cell whose bytes were odd.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string table(MeasuredData const& data, Run const& run) {
  std::string text = "time [s]";
  std::vector<std::span<double const>> columns;
  for (auto const& channel : data.channels)
    if (run.has(channel.name)) {
      text += fmt::format(",{} [{}]", channel.name, channel.unit);
      columns.push_back(run.channel(channel.name));
      EXPECT(columns.back().size() == run.time.size());
    }
  text += '\n';
  for (std::size_t k = 0; k < run.time.size(); ++k) {
    text += shortest(run.time[k]);
    for (auto const& column : columns)
      text += ',' + shortest(column[k]);
    text += '\n';
  }
  return text;
}

} // namespace

std::map<std::string, std::string> print_measured(MeasuredData const& data) {
  std::map<std::string, std::string> texts;
  std::size_t n_curves = 0;
  for (auto const& run : data.runs)
    if (run.has_curve())
      texts[csv_name(run.file)] = table(data, run), ++n_curves;
  EXPECT(texts.size() == n_curves);
  texts["measured.json"] = description(data);
  return texts;
}

void write_measured(MeasuredData const& data, std::filesystem::path const& folder) {
  auto const texts = print_measured(data);
  std::filesystem::create_directories(folder);
  for (auto const& [file, text] : texts) {
    if (file == "measured.json")
      continue;
    std::filesystem::create_directories((folder / file).parent_path());
    write_file(folder / file, text);
  }
  write_file(folder / "measured.json", texts.at("measured.json"));
}

} // namespace coupling::measured
