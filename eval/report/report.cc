#include "eval/report/report.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "eval/files.h"
#include "eval/report/page.h"
#include "eval/report/result_folder.h"

namespace walkgraph {
namespace {

// JSON inside a script element: no "</script>" and no "<!--" may end or hide it.
std::string EscapeForScript(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

// The template with each marker replaced; what is put in is not searched for markers again.
std::string FillPage(std::string_view style, std::string_view data, std::string_view script) {
  const std::string_view page = PageTemplate();
  std::string text;
  std::size_t from = 0;
  const auto put = [&](std::string_view marker, std::string_view content) {
    const std::size_t at = page.find(marker, from);
    text += page.substr(from, at - from);
    text += content;
    from = at + marker.size();
  };
  put("@STYLE@", style);
  put("@DATA@", data);
  put("@SCRIPT@", script);
  text += page.substr(from);
  return text;
}

}  // namespace

void WriteReport(const std::vector<std::string>& result_dirs, const std::string& out_file) {
  nlohmann::ordered_json data = {{"runs", nlohmann::ordered_json::array()}};
  for (const std::string& dir : result_dirs) data["runs"].push_back(ReadResultFolder(dir));
  const std::string json =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  WriteFileWhole(out_file, FillPage(PageStyle(), EscapeForScript(json), PageScript()));
}

}  // namespace walkgraph
