#include "coupling/finding/finding_page.hpp"

#include "coupling/finding/page_parts.hpp"
#include "coupling/report/assets.hpp"
#include "coupling/report/html.hpp"

namespace coupling::finding {

std::string finding_page(Finding const& finding) {
  auto const& from = finding.provenance;
  auto const code = [](std::string_view script) { return escape_inline_script(script); };
  return fill_template(assets::finding_page,
                       {
                           {"case", escape_html(from.case_file)},
                           {"measured", escape_html(from.data_folder)},
                           {"version", escape_html(from.version)},
                           {"style", std::string(assets::style)},
                           {"finding_style", std::string(assets::finding_style)},
                           {"verdict", verdict_part(finding)},
                           {"answer", answer_part(finding)},
                           {"misfit", misfit_part(finding)},
                           {"scalars", scalars_part(finding)},
                           {"causes", causes_part(finding)},
                           {"next", next_part(finding)},
                           {"unknown", unknown_part(finding)},
                           {"gain", gain_part(finding)},
                           {"extension", extension_part(finding)},
                           {"detectable", detectable_part(finding)},
                           {"assumed", assumed_part(finding)},
                           {"reading", reading_part(finding)},
                           {"origin", origin_part(finding)},
                           {"data", escape_json_in_script(curves_json(finding))},
                           {"charts", code(assets::charts)},
                           {"study_plots", code(assets::study_plots)},
                           {"script", code(assets::finding_script)},
                       });
}

} // namespace coupling::finding
