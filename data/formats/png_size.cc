#include "data/formats/png_size.h"

#include <string_view>

#include "data/formats/text_input.h"

namespace walkgraph {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kTypeAt = 12;  // signature (8 bytes), then the length of the first chunk (4)
constexpr std::size_t kWidthAt = 16;
constexpr std::size_t kHeightAt = 20;
constexpr std::size_t kHeaderBytes = 24;

std::uint32_t BigEndian32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace

std::optional<PngSize> ReadPngSize(const std::string& path) {
  const std::string bytes = ReadFileBeginning(path, kHeaderBytes);
  const std::string_view header = bytes;
  if (header.size() < kHeaderBytes || !header.starts_with(kSignature) ||
      header.substr(kTypeAt, 4) != "IHDR") {
    return std::nullopt;
  }
  return PngSize{BigEndian32(header.substr(kWidthAt)), BigEndian32(header.substr(kHeightAt))};
}

}  // namespace walkgraph
