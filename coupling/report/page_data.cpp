#include "coupling/report/page_data.hpp"

#include "coupling/report/html.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <set>

namespace coupling {
namespace {

static_assert(std::endian::native == std::endian::little,
              "browsers read the packed numbers as little-endian");

void append_number(std::string& out, double value) {
  if (std::isfinite(value))
    fmt::format_to(std::back_inserter(out), "{:.7g}", value);
  else
    out += "null";
}

/// Rows at which the extreme of a column lies, if there is such a column with any number in it.
template <typename Better>
void keep_extreme(PressRecord const& record, std::string_view name, Better better,
                  std::set<std::size_t>& rows) {
  if (!record.has(name))
    return;
  auto const values = record.column(name);
  std::size_t best = values.size();
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isnan(values[k]) && (best == values.size() || better(values[k], values[best])))
      best = k;
  if (best < values.size())
    rows.insert(best);
}

std::string stages_json(PressRecord const& record, std::span<std::size_t const> rows) {
  std::string out = "[";
  for (std::size_t first = 0; first < rows.size();) {
    auto const& name = record.stages()[rows[first]];
    auto last = first;
    while (last + 1 < rows.size() && record.stages()[rows[last + 1]] == name)
      ++last;
    if (out.size() > 1)
      out += ',';
    out += fmt::format(R"({{"name":{},"first":{},"last":{}}})", json_text(name), first, last);
    first = last + 1;
  }
  return out + "]";
}

} // namespace

std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<std::size_t> rows_to_draw(PressRecord const& record, std::size_t most) {
  std::set<std::size_t> rows;
  auto const n = record.size();
  auto const stride = std::max<std::size_t>(1, (n + most - 1) / most);
  for (std::size_t k = 0; k < n; k += stride)
    rows.insert(k);
  for (std::size_t k = 0; k < n; ++k) {
    auto const& stages = record.stages();
    if (k == 0 || k + 1 == n || stages[k] != stages[k - 1] || stages[k] != stages[k + 1])
      rows.insert(k);
  }
  keep_extreme(record, "upper_punch_force", std::greater<>{}, rows);
  keep_extreme(record, "punch_gap", std::less<>{}, rows);
  return {rows.begin(), rows.end()};
}

std::string record_json(PressRecord const& record) {
  auto const rows = rows_to_draw(record);
  std::string out = "{\"columns\":[";
  for (std::size_t c = 0; c < record.columns().size(); ++c) {
    auto const& [name, unit] = record.columns()[c];
    if (c > 0)
      out += ',';
    out += fmt::format(R"({{"name":{},"unit":{},"values":[)", json_text(name), json_text(unit));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (k > 0)
        out += ',';
      append_number(out, record.rows()[rows[k]][c]);
    }
    out += "]}";
  }
  return out + "],\"stages\":" + stages_json(record, rows) + "}";
}

std::vector<std::size_t> grains_to_draw(std::span<PicturedGrain const> grains, std::size_t most) {
  double outside = 0.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double widest = 0.0;
  for (auto const& g : grains) {
    outside = std::max(outside, std::hypot(g.position.x(), g.position.y()) + g.radius);
    low = std::min(low, g.position.z() - g.radius);
    high = std::max(high, g.position.z() + g.radius);
    widest = std::max(widest, g.radius);
  }
  auto const is_at_surface = [&](PicturedGrain const& g) {
    return std::hypot(g.position.x(), g.position.y()) + g.radius > outside - widest ||
           g.position.z() - g.radius < low + widest || g.position.z() + g.radius > high - widest;
  };
  auto const stride = std::max<std::size_t>(1, (grains.size() + most - 1) / most);
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (k % stride == 0 || is_at_surface(grains[k]))
      shown.push_back(k);
  return shown;
}

std::string grains_json(std::span<PicturedGrain const> grains) {
  auto const shown = grains_to_draw(grains);
  std::vector<float> numbers;
  std::vector<std::uint8_t> component;
  numbers.reserve(6 * shown.size());
  for (auto const k : shown) {
    auto const& g = grains[k];
    for (double const value :
         {g.position.x(), g.position.y(), g.position.z(), g.radius, g.mean_overlap, g.stress})
      numbers.push_back(static_cast<float>(value));
    component.push_back(g.component);
  }
  return fmt::format(R"({{"shown":{},"of":{},"numbers":"{}","component":"{}"}})", shown.size(),
                     grains.size(), encode_base64(std::as_bytes(std::span(numbers))),
                     encode_base64(std::as_bytes(std::span(component))));
}

std::string stressed_json(StressPicture const& picture) {
  auto const packed = [](auto const& numbers) {
    return encode_base64(std::as_bytes(std::span(numbers)));
  };
  std::string out = fmt::format(R"({{"grains":{},"tools":[)", grains_json(picture.grains));
  for (PicturedTool const& tool : picture.tools) {
    std::vector<float> places;
    for (dem::Vec3 const& x : tool.vertices)
      for (int c = 0; c < 3; ++c)
        places.push_back(static_cast<float>(x[c]));
    std::vector<float> const stress(tool.von_mises.begin(), tool.von_mises.end());
    if (&tool != &picture.tools.front())
      out += ',';
    out +=
        fmt::format(R"({{"name":{},"vertices":"{}","triangles":"{}","von_mises":"{}"}})",
                    json_text(tool.name), packed(places), packed(tool.triangles), packed(stress));
  }
  return out + "]}";
}

std::string report_json(ReportData const& data) {
  std::string out =
      "{\"record\":" + record_json(data.record) + ",\"grains\":" + grains_json(data.grains);
  auto const append_list = [&](char const* key, auto const& items, auto const& write) {
    out += fmt::format(",\"{}\":[", key);
    for (std::size_t k = 0; k < items.size(); ++k) {
      if (k > 0)
        out += ',';
      write(items[k]);
    }
    out += ']';
  };
  if (!data.stressed.tools.empty())
    out += ",\"stressed\":" + stressed_json(data.stressed);
  append_list("components", data.components,
              [&](std::string const& name) { out += json_text(name); });
  append_list("tools", data.tools, [&](ToolOutline const& tool) {
    out += fmt::format(R"({{"name":{},"radius":)", json_text(tool.name));
    append_number(out, tool.radius);
    out += ",\"bottom\":";
    append_number(out, tool.bottom);
    out += ",\"top\":";
    append_number(out, tool.top);
    out += "}";
  });
  append_list("observed", data.observed, [&](ObservedValue const& value) {
    out += fmt::format(R"({{"name":{},"unit":{},"source":{},"value":)", json_text(value.name),
                       json_text(value.unit), json_text(value.source));
    append_number(out, value.value);
    out += ",\"sd\":";
    append_number(out, value.sd);
    out += '}';
  });
  return out + "}";
}

} // namespace coupling
