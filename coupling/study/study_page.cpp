#include "coupling/study/study_page.hpp"

#include "coupling/record/atomic_file.hpp"
#include "coupling/report/assets.hpp"
#include "coupling/report/html.hpp"
#include "coupling/study/page_tables.hpp"

namespace coupling::study {

void write_study_page(StudyPage const& page, std::filesystem::path const& file) {
  auto const code = [](std::string_view script) { return escape_inline_script(script); };
  write_file(file, fill_template(assets::study_page,
                                 {
                                     {"title", escape_html(page.table.study.title)},
                                     {"version", escape_html(PRESSCHECK_VERSION)},
                                     {"style", std::string(assets::style)},
                                     {"study_style", std::string(assets::study_style)},
                                     {"lead", lead_html(page)},
                                     {"runs_verdict", runs_verdict_html(page)},
                                     {"answers", answers_html(page)},
                                     {"calibration", calibration_html(page)},
                                     {"validation", validation_html(page)},
                                     {"surfaces", surfaces_html(page)},
                                     {"trends", trends_html(page)},
                                     {"cost", cost_html(page)},
                                     {"design", design_html(page)},
                                     {"provenance", study_provenance_html(page)},
                                     {"study", escape_html(page.table.study.resolved_text)},
                                     {"data", escape_json_in_script(study_page_json(page))},
                                     {"charts", code(assets::charts)},
                                     {"study_plots", code(assets::study_plots)},
                                     {"surface_plot", code(assets::surface_plot)},
                                     {"script", code(assets::study_script)},
                                 }));
}

} // namespace coupling::study
