#include "eval/report/result_text.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>

#include "data/input_error.h"

namespace walkgraph {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::optional<std::string> ReadIfThere(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

Json ParseJson(const fs::path& path, const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw InputError(path.string(), 0, "not JSON", "a result file");
  return json;
}

Json Rounded(double value, double unit) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value / unit) * unit;
}

double Seconds(std::int64_t time_ns, std::int64_t begin_ns) {
  return static_cast<double>(time_ns - begin_ns) * 1e-9;
}

}  // namespace walkgraph
