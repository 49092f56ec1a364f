#include "coupling/record/atomic_file.hpp"
#include "coupling/verification/verify.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace coupling::verification {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (char const c : text) {
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

/// NaN has no JSON number; null says that there is none.
nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

constexpr std::string_view style =
    R"(body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:75rem;
padding:0 1rem;color:#1b1f24}table{border-collapse:collapse;width:100%}th,td{padding:.3rem .6rem;text-align:left;
border-bottom:1px solid #d8dee4}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}
.ok{color:#116329}.failed{color:#a40e26;font-weight:600}td.s{color:#57606a;font-size:.85em})";

} // namespace

void write_json(std::vector<Benchmark> const& rows, std::filesystem::path const& file) {
  auto list = nlohmann::ordered_json::array();
  for (Benchmark const& row : rows) {
    list.push_back({{"name", row.name},
                    {"reference", number(row.reference)},
                    {"result", number(row.result)},
                    {"error", number(row.error)},
                    {"tolerance", number(row.tolerance)},
                    {"ok", row.ok},
                    {"source", row.source}});
  }
  write_file(file, list.dump(1) + "\n");
}

void write_html(std::vector<Benchmark> const& rows, std::filesystem::path const& file) {
  auto const failed = std::ranges::count_if(rows, [](Benchmark const& row) { return !row.ok; });
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>presscheck "
      "verify</title>"
      "<style>{}</style></head><body>\n<h1>Verification</h1>\n<p>{} benchmarks, "
      "<span class=\"{}\">{} failed</span>.</p>\n<table><thead><tr><th>benchmark</th><th "
      "class=\"n\">reference</th>"
      "<th class=\"n\">result</th><th class=\"n\">error</th><th "
      "class=\"n\">tolerance</th><th>verdict</th>"
      "<th>source</th></tr></thead><tbody>\n",
      style, rows.size(), failed == 0 ? "ok" : "failed", failed);
  for (Benchmark const& row : rows) {
    text +=
        fmt::format("<tr><td>{}</td><td class=\"n\">{:.7g}</td><td class=\"n\">{:.7g}</td>"
                    "<td class=\"n\">{:.2g}</td><td class=\"n\">{:.2g}</td><td class=\"{}\">{}</td>"
                    "<td class=\"s\">{}</td></tr>\n",
                    escaped(row.name), row.reference, row.result, row.error, row.tolerance,
                    row.ok ? "ok" : "failed", row.ok ? "ok" : "failed", escaped(row.source));
  }
  write_file(file, text + "</tbody></table>\n</body></html>\n");
}

} // namespace coupling::verification
