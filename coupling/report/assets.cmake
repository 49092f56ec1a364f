# What the report needs at build time: its embedded pages, and the folder of Debian's JavaScript packages.
set(PRESSCHECK_JAVASCRIPT_DIR /usr/share/javascript CACHE PATH "JavaScript libraries that reports carry inside")
set(PRESSCHECK_ASSETS ${CMAKE_CURRENT_BINARY_DIR}/report_assets.cpp)
add_custom_command(
  OUTPUT ${PRESSCHECK_ASSETS}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${PRESSCHECK_ASSETS} -DFOLDER=${CMAKE_CURRENT_LIST_DIR}
          -P ${CMAKE_CURRENT_LIST_DIR}/embed_assets.cmake
  DEPENDS ${CMAKE_CURRENT_LIST_DIR}/embed_assets.cmake
          ${CMAKE_CURRENT_LIST_DIR}/charts.js
          ${CMAKE_CURRENT_LIST_DIR}/compact_shader.js
          ${CMAKE_CURRENT_LIST_DIR}/compact_view.js
          ${CMAKE_CURRENT_LIST_DIR}/compare.html.in
          ${CMAKE_CURRENT_LIST_DIR}/compare.js
          ${CMAKE_CURRENT_LIST_DIR}/finding.css
          ${CMAKE_CURRENT_LIST_DIR}/finding.html.in
          ${CMAKE_CURRENT_LIST_DIR}/finding.js
          ${CMAKE_CURRENT_LIST_DIR}/report.css
          ${CMAKE_CURRENT_LIST_DIR}/report.html.in
          ${CMAKE_CURRENT_LIST_DIR}/report.js
          ${CMAKE_CURRENT_LIST_DIR}/stressed_view.js
          ${CMAKE_CURRENT_LIST_DIR}/study.css
          ${CMAKE_CURRENT_LIST_DIR}/study.html.in
          ${CMAKE_CURRENT_LIST_DIR}/study.js
          ${CMAKE_CURRENT_LIST_DIR}/study_plots.js
          ${CMAKE_CURRENT_LIST_DIR}/surface_plot.js
  VERBATIM)
set_source_files_properties(report/script_library.cpp PROPERTIES
  COMPILE_DEFINITIONS PRESSCHECK_JAVASCRIPT_DIR="${PRESSCHECK_JAVASCRIPT_DIR}")
