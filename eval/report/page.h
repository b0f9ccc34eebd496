#ifndef WALKGRAPH_EVAL_REPORT_PAGE_H_
#define WALKGRAPH_EVAL_REPORT_PAGE_H_

#include <string_view>

namespace walkgraph {

// The files of eval/report/page, built into the library (cmake/embed_text.cmake).
// Markers stand in the order given here, each once.
std::string_view PageTemplate();      // HTML with @STYLE@, @DATA@, @LIBRARY@ and @SCRIPT@
std::string_view PageStyle();         // CSS
std::string_view PageScript();        // JavaScript, all files in order
std::string_view StudyTemplate();     // HTML with @STYLE@, @BODY@ and @SCRIPT@
std::string_view StudyScript();       // JavaScript of that page
std::string_view PageLibrary();       // eval/report/third_party/uplot, its licence before it
std::string_view PageLibraryStyle();  // CSS of the library

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_PAGE_H_
