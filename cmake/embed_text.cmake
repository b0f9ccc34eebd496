# Run as a script at build time: writes OUTPUT, a source that defines the functions declared in
# eval/report/page.h, one per kind of file, from the texts in FOLDER and the plotting library in
# LIBRARY, whose files must be the ones that were taken over.
function(read_texts out)
  set(all "")
  foreach(name IN LISTS ARGN)
    file(READ ${FOLDER}/${name} text)
    string(APPEND all "${text}")
  endforeach()
  set(${out} "${all}" PARENT_SCOPE)
endfunction()

file(STRINGS ${LIBRARY}/SHA256SUMS sums)
foreach(line IN LISTS sums)
  string(REGEX MATCH "^([0-9a-f]+)  (.+)$" matched "${line}")
  file(SHA256 ${LIBRARY}/${CMAKE_MATCH_2} sum)
  if(NOT sum STREQUAL CMAKE_MATCH_1)
    message(FATAL_ERROR "${LIBRARY}/${CMAKE_MATCH_2} is not the file that SHA256SUMS names")
  endif()
endforeach()
file(READ ${LIBRARY}/LICENSE licence)
file(READ ${LIBRARY}/uPlot.iife.min.js library)
file(READ ${LIBRARY}/uPlot.min.css library_css)

read_texts(html page.html)
read_texts(css page.css)
read_texts(study_html study.html)
read_texts(study_js study.js)
read_texts(js data.js charts.js scores.js plan.js courses.js main.js)
file(WRITE ${OUTPUT} "#include \"eval/report/page.h\"

namespace walkgraph {
std::string_view PageTemplate() { return R\"page(${html})page\"; }
std::string_view PageLibrary() { return R\"page(/*
${licence}*/
${library})page\"; }
std::string_view PageLibraryStyle() { return R\"page(${library_css})page\"; }
std::string_view PageStyle() { return R\"page(${css})page\"; }
std::string_view PageScript() { return R\"page(${js})page\"; }
std::string_view StudyTemplate() { return R\"page(${study_html})page\"; }
std::string_view StudyScript() { return R\"page(${study_js})page\"; }
}  // namespace walkgraph
")
