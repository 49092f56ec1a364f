#pragma once

#include <string_view>

/// The files of this folder that make up the pages, embedded by embed_assets.cmake.
namespace coupling::assets {

extern std::string_view const report_page;    ///< report.html.in
extern std::string_view const compare_page;   ///< compare.html.in
extern std::string_view const style;          ///< report.css
extern std::string_view const charts;         ///< charts.js
extern std::string_view const compact_view;   ///< compact_view.js
extern std::string_view const compact_shader; ///< compact_shader.js
extern std::string_view const stressed_view;  ///< stressed_view.js
extern std::string_view const report_script;  ///< report.js
extern std::string_view const compare_script; ///< compare.js
extern std::string_view const study_page;     ///< study.html.in
extern std::string_view const study_style;    ///< study.css
extern std::string_view const study_plots;    ///< study_plots.js
extern std::string_view const surface_plot;   ///< surface_plot.js
extern std::string_view const study_script;   ///< study.js
extern std::string_view const finding_page;   ///< finding.html.in
extern std::string_view const finding_style;  ///< finding.css
extern std::string_view const finding_script; ///< finding.js

} // namespace coupling::assets
