#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/angle.h"
#include "data/formats/getsensordata.h"
#include "data/formats/png_size.h"
#include "data/formats/text_input.h"
#include "data/input_error.h"

namespace walkgraph {
namespace {

// The file knows no heights. A usual storey; where heights matter (pressure), put a building.json
// with surveyed ones beside the logs.
constexpr double kNominalStoreyHeightM = 3.0;
constexpr double kHighestFloor = 1000;

// The rows of the file, in order.
enum Row { kImage, kFloor, kBuilding, kLatitude, kLongitude, kRotation, kScale, kRowCount };

using Table = std::vector<std::vector<std::string_view>>;

std::vector<std::string_view> SplitAtBlanks(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t length = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, length));
    line.remove_prefix(length);
  }
}

Table ReadTable(std::string_view text, const std::string& path) {
  Table table;
  LineReader lines(text);
  std::string_view line;
  while (lines.Next(&line)) {
    if (line.starts_with('%')) continue;
    std::vector<std::string_view> words = SplitAtBlanks(line);
    if (words.empty()) continue;
    if (!table.empty() && words.size() != table.front().size()) {
      throw InputError(path, lines.number(), std::to_string(words.size()) + " columns",
                       std::to_string(table.front().size()) + ", one per floor");
    }
    table.push_back(std::move(words));
  }
  if (table.size() != kRowCount) {
    throw InputError(path, 0, std::to_string(table.size()) + " rows",
                     "7: image, floor, building, latitude, longitude, rotation, metres per pixel");
  }
  return table;
}

double Number(const Table& table, Row row, std::size_t column, const std::string& path) {
  double value = 0;
  if (!ParseDouble(table[row][column], &value) || !std::isfinite(value)) {
    throw InputError(path, 0, "'" + std::string(table[row][column]) + "' is no number",
                     "a finite number");
  }
  return value;
}

// The rectangle of the image in the building frame; zero where the image is missing.
PlanImage FindImage(const std::string& path, const Eigen::Vector2d& centre, double scale_m) {
  PlanImage image;
  const auto size = ReadPngSize(path);
  if (!size) return image;
  image.path = path;
  const Eigen::Vector2d half = 0.5 * scale_m * Eigen::Vector2d(size->columns, size->rows);
  image.min_corner = centre - half;
  image.max_corner = centre + half;
  return image;
}

// Floors without an image of their own take the box of one that has, for plans of one building
// cover the same ground.
void FillMissingBoxes(std::vector<Floor>* floors) {
  const auto known = std::find_if(floors->begin(), floors->end(), [](const Floor& floor) {
    return floor.max_corner != floor.min_corner;
  });
  if (known == floors->end()) return;
  const Eigen::Vector2d low = known->min_corner;
  const Eigen::Vector2d high = known->max_corner;
  for (Floor& floor : *floors) {
    if (floor.max_corner != floor.min_corner) continue;
    floor.min_corner = low;
    floor.max_corner = high;
  }
}

}  // namespace

Building ReadFloorplansCal(const std::string& path) {
  const std::string text = ReadFileBytes(path);
  const Table table = ReadTable(text, path);
  Building building;
  // The file turns the image clockwise onto north; the frame turns counter-clockwise from east.
  const GeoReference origin{Number(table, kLatitude, 0, path), Number(table, kLongitude, 0, path),
                            DegreesToRadians(-Number(table, kRotation, 0, path))};
  building.origin = origin;
  for (std::size_t column = 0; column < table.front().size(); ++column) {
    if (Number(table, kRotation, column, path) != Number(table, kRotation, 0, path)) {
      throw InputError(path, 0, "floors with different rotations", "one rotation per building");
    }
    const double number = Number(table, kFloor, column, path);
    if (std::abs(number) > kHighestFloor) {
      throw InputError(path, 0, "floor " + std::to_string(number), "a floor number below 1000");
    }
    Floor floor;
    floor.number = static_cast<int>(number);
    floor.name = table[kFloor][column];
    floor.height_m = kNominalStoreyHeightM * floor.number;
    const Eigen::Vector2d centre = Wgs84ToBuilding(Number(table, kLatitude, column, path),
                                                   Number(table, kLongitude, column, path), origin);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    floor.image = FindImage((folder / table[kImage][column]).string(), centre,
                            Number(table, kScale, column, path));
    floor.min_corner = floor.image.min_corner;
    floor.max_corner = floor.image.max_corner;
    building.floors.push_back(std::move(floor));
  }
  std::sort(building.floors.begin(), building.floors.end(),
            [](const Floor& a, const Floor& b) { return a.number < b.number; });
  FillMissingBoxes(&building.floors);
  return building;
}

}  // namespace walkgraph
