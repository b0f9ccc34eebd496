#ifndef WALKGRAPH_EVAL_REPORT_PAGE_H_
#define WALKGRAPH_EVAL_REPORT_PAGE_H_

#include <string_view>

namespace walkgraph {

// The files of eval/report/page, built into the library (cmake/embed_text.cmake).
std::string_view PageTemplate();   // HTML with the markers @STYLE@, @DATA@ and @SCRIPT@, each once
std::string_view PageStyle();      // CSS
std::string_view PageScript();     // JavaScript, all files in order
std::string_view StudyTemplate();  // HTML with the markers @STYLE@, @BODY@ and @SCRIPT@, each once
std::string_view StudyScript();    // JavaScript of that page

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_PAGE_H_
