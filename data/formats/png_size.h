#ifndef WALKGRAPH_DATA_FORMATS_PNG_SIZE_H_
#define WALKGRAPH_DATA_FORMATS_PNG_SIZE_H_

#include <cstdint>
#include <optional>
#include <string>

namespace walkgraph {

struct PngSize {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
};

// Width and height in pixels from the header chunk (PNG specification, section 11.2.1); nullopt
// where the file is missing or no PNG.
std::optional<PngSize> ReadPngSize(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_PNG_SIZE_H_
