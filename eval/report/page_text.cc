#include "eval/report/page_text.h"

#include <cstddef>

namespace walkgraph {

std::string FillTemplate(std::string_view page,
                         const std::vector<std::pair<std::string_view, std::string_view>>& texts) {
  std::string filled;
  for (const auto& [marker, text] : texts) {
    const std::size_t at = page.find(marker);
    filled.append(page.substr(0, at)).append(text);
    page.remove_prefix(at + marker.size());
  }
  return filled.append(page);
}

std::string StandaloneSvg(const std::string& svg) {
  constexpr std::string_view kOpening = "<svg ";
  return std::string(kOpening) + "style=\"color:#1b1e23;background:#fff\" " +
         svg.substr(kOpening.size());
}

}  // namespace walkgraph
