# Run as a script at build time: writes OUTPUT, a source that defines the functions declared in
# eval/report/page.h, one per kind of file, from the texts in FOLDER.
function(read_texts out)
  set(all "")
  foreach(name IN LISTS ARGN)
    file(READ ${FOLDER}/${name} text)
    string(APPEND all "${text}")
  endforeach()
  set(${out} "${all}" PARENT_SCOPE)
endfunction()

read_texts(html page.html)
read_texts(css page.css)
read_texts(study_html study.html)
read_texts(study_js study.js)
read_texts(js data.js scores.js plan.js courses.js main.js)
file(WRITE ${OUTPUT} "#include \"eval/report/page.h\"

namespace walkgraph {
std::string_view PageTemplate() { return R\"page(${html})page\"; }
std::string_view PageStyle() { return R\"page(${css})page\"; }
std::string_view PageScript() { return R\"page(${js})page\"; }
std::string_view StudyTemplate() { return R\"page(${study_html})page\"; }
std::string_view StudyScript() { return R\"page(${study_js})page\"; }
}  // namespace walkgraph
")
