#ifndef WALKGRAPH_EVAL_REPORT_PAGE_TEXT_H_
#define WALKGRAPH_EVAL_REPORT_PAGE_TEXT_H_

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace walkgraph {

// The template with each marker replaced by its text, in the order in which they stand in it; what
// is put in is not searched for markers again.
std::string FillTemplate(std::string_view page,
                         const std::vector<std::pair<std::string_view, std::string_view>>& texts);

// A figure as a file of its own: with a background and a text colour, which it takes from the page
// inside one.
std::string StandaloneSvg(const std::string& svg);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_PAGE_TEXT_H_
