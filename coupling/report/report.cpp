#include "coupling/report/report.hpp"

#include "coupling/record/atomic_file.hpp"
#include "coupling/report/assets.hpp"
#include "coupling/report/html.hpp"
#include "coupling/report/page_data.hpp"
#include "coupling/report/sections.hpp"

#include <algorithm>

namespace coupling {
namespace {

/// Observed values that do not stand beside ours already.
std::vector<ObservedValue> not_compared(ReportData const& data) {
  auto values = data.observed;
  std::erase_if(values, [&](ObservedValue const& value) {
    return std::ranges::any_of(data.comparison, [&](ComparedValue const& row) {
      return row.quantity == value.name && row.source == value.source;
    });
  });
  return values;
}

} // namespace

void write_report(std::filesystem::path const& file, ReportData const& data,
                  std::filesystem::path const& libraries) {
  auto const code = [](std::string_view script) { return escape_inline_script(script); };
  write_file(file, fill_template(assets::report_page,
                                 {
                                     {"title", escape_html(data.title)},
                                     {"version", escape_html(data.summary.version)},
                                     {"style", std::string(assets::style)},
                                     {"verdict", verdict_html(data.summary.checks)},
                                     {"in_words", run_in_words(data)},
                                     {"summary", summary_html(data.summary)},
                                     {"checks", checks_html(data.summary.checks)},
                                     {"tools", tools_html(data.summary.tools, data.stressed)},
                                     {"moment", escape_html(data.grains_moment)},
                                     {"comparison", comparison_html(data.comparison)},
                                     {"observed", observed_html(not_compared(data))},
                                     {"provenance", provenance_html(data.provenance)},
                                     {"case", escape_html(data.resolved_case)},
                                     {"data", escape_json_in_script(report_json(data))},
                                     {"three", read_three_js(libraries)},
                                     {"charts", code(assets::charts)},
                                     {"compact_shader", code(assets::compact_shader)},
                                     {"compact_view", code(assets::compact_view)},
                                     {"stressed_view", code(assets::stressed_view)},
                                     {"script", code(assets::report_script)},
                                 }));
}

} // namespace coupling
