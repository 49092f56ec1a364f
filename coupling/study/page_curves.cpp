#include "coupling/study/page_curves.hpp"

#include "coupling/record/curves.hpp"
#include "coupling/record/run_file.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/page_data.hpp"
#include "coupling/study/grain_picture.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

namespace coupling::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<char const*, 5> drawn{"time", "upper_punch_force", "compact_height",
                                           "mean_overlap", "punch_gap"};

/// Five digits: more than a plot shows.
Json rounded(double value) {
  if (!std::isfinite(value))
    return nullptr;
  std::array<char, 32> text{};
  auto const end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 5);
  double short_value = 0.0;
  std::from_chars(text.begin(), end.ptr, short_value);
  return short_value;
}

Json stages_json(PressRecord const& record) {
  Json stages = Json::array();
  auto const& names = record.stages();
  auto const time = record.column("time");
  for (std::size_t first = 0; first < names.size();) {
    auto last = first;
    while (last + 1 < names.size() && names[last + 1] == names[first])
      ++last;
    stages.push_back(
        {{"name", names[first]}, {"from", time[first == 0 ? 0 : first - 1]}, {"to", time[last]}});
    first = last + 1;
  }
  return stages;
}

Json run_json(ResultsTable const& table, ResultRow const& row, PressRecord const& record,
              std::size_t most) {
  Json json{{"run", row.run.id},
            {"setup", row.run.setup},
            {"validation", row.run.is_validation},
            {"factors", Json::array()}};
  for (std::size_t f = 0; f < table.study.factors.size(); ++f)
    json["factors"].push_back(rounded(table.study.factors[f].coded(row.run.natural[f])));
  auto const rows = rows_to_draw(record, most);
  for (char const* name : drawn) {
    if (!record.has(name))
      continue;
    auto const values = record.column(name);
    for (std::size_t const k : rows)
      json[name].push_back(rounded(values[k]));
  }
  return json;
}

template <class Act> void for_finished(ResultsTable const& table, char const* file, Act act) {
  for (ResultRow const& row : table.rows)
    if (row.is_done() && !row.folder.empty() && std::filesystem::exists(row.folder / file))
      act(row, row.folder / file);
}

std::string dump(Json const& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace

std::string curves_json(ResultsTable const& table, std::size_t most) {
  Json json{{"stages", Json::array()}, {"runs", Json::array()}};
  for_finished(table, "curves.csv", [&](ResultRow const& row, std::filesystem::path const& file) {
    auto const record = read_curves(file);
    if (!record.has("time"))
      return;
    if (json["runs"].empty())
      json["stages"] = stages_json(record);
    json["runs"].push_back(run_json(table, row, record, most));
  });
  return dump(json);
}

std::string shapes_json(ResultsTable const& table, int width) {
  // Twice over the files: the beds of a large study need not stand in memory together.
  std::optional<PictureFrame> frame;
  for_finished(table, "run.h5", [&](ResultRow const&, std::filesystem::path const& file) {
    auto const own = frame_of(read_grains(file));
    frame = frame ? common(*frame, own) : own;
  });
  Json json{{"runs", Json::array()}};
  if (!frame || !(frame->half_width > 0.0))
    return dump(json);
  for_finished(table, "run.h5", [&](ResultRow const& row, std::filesystem::path const& file) {
    auto const picture = draw_grains(read_grains(file), *frame, width);
    json["width"] = picture.width;
    json["height"] = picture.height;
    json["metres"] = rounded(2.0 * frame->half_width);
    json["runs"].push_back(
        {{"run", row.run.id}, {"pixels", encode_base64(std::as_bytes(std::span(picture.pixels)))}});
  });
  return dump(json);
}

} // namespace coupling::study
