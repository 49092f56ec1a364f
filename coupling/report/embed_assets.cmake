# Turns the pages' files into one C++ source, so that the program needs no data files of its own.
#   cmake -DOUTPUT=assets.cpp -DFOLDER=coupling/report -P embed_assets.cmake
set(source "// Generated from the files of coupling/report.\n#include \"coupling/report/assets.hpp\"\n\nnamespace coupling::assets {\n")
foreach(entry IN ITEMS "report_page report.html.in" "compare_page compare.html.in" "style report.css" "charts charts.js"
                       "compact_view compact_view.js" "compact_shader compact_shader.js" "report_script report.js"
                       "stressed_view stressed_view.js"
                       "compare_script compare.js" "study_page study.html.in" "study_style study.css"
                       "study_plots study_plots.js" "surface_plot surface_plot.js" "study_script study.js"
                       "finding_page finding.html.in" "finding_style finding.css" "finding_script finding.js")
  separate_arguments(entry)
  list(GET entry 0 name)
  list(GET entry 1 file)
  # Byte by byte: CMake would take brackets and semicolons of the text for its own.
  file(READ "${FOLDER}/${file}" bytes HEX)
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  string(APPEND source "std::string_view const ${name} =\n    \"${bytes}\";\n")
endforeach()
string(APPEND source "}  // namespace coupling::assets\n")
file(WRITE "${OUTPUT}" "${source}")
