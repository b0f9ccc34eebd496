#include "frontends/radio_map/site_file.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <type_traits>

#include "data/input_error.h"

namespace walkgraph {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the site file is written in the byte order of memory");

constexpr char kMagic[] = "WALKGRAPHSITE\n";
constexpr std::size_t kMagicSize = sizeof(kMagic) - 1;
constexpr std::uint32_t kVersion = 9;
constexpr std::size_t kHeaderSize = kMagicSize + sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t);

std::uint64_t Fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  return hash;
}

// Writes and reads the same fields in the same order: Archive() below is the format's definition.
class Writer {
 public:
  template <typename T>
  void Scalar(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <typename T>
  std::uint64_t Size(const T& container) {
    const std::uint64_t size = container.size();
    Scalar(size);
    return size;
  }
  template <typename T>
  void Scalars(const std::vector<T>& values) {
    Size(values);
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void Text(const std::string& text) {
    Size(text);
    bytes_ += text;
  }
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  template <typename T>
  void Scalar(T& value) {
    std::memcpy(&value, Take(sizeof(T)), sizeof(T));
  }
  // The stored size; no more than what the remaining bytes could hold at one byte per element.
  template <typename T>
  std::uint64_t Size(T& container) {
    std::uint64_t size = 0;
    Scalar(size);
    if (size > bytes_.size()) Fail();
    container.resize(size);
    return size;
  }
  template <typename T>
  void Scalars(std::vector<T>& values) {
    std::uint64_t size = 0;
    Scalar(size);
    if (size > bytes_.size() / sizeof(T)) Fail();
    values.resize(size);
    if (size > 0) std::memcpy(values.data(), Take(size * sizeof(T)), size * sizeof(T));
  }
  void Text(std::string& text) {
    const std::uint64_t size = Size(text);
    if (size > 0) std::memcpy(text.data(), Take(size), size);
  }
  void ExpectEnd() const {
    if (!bytes_.empty()) Fail();
  }

 private:
  const char* Take(std::size_t size) {
    if (size > bytes_.size()) Fail();
    const char* at = bytes_.data();
    bytes_.remove_prefix(size);
    return at;
  }
  [[noreturn]] void Fail() const {
    throw InputError(name_, 0, "the content of the site does not fit its length",
                     "a site file written by walkgraph survey");
  }

  std::string_view bytes_;
  const std::string& name_;
};

template <typename A, typename V>
void Vector2(A& a, V& v) {
  a.Scalar(v.x());
  a.Scalar(v.y());
}

template <typename A, typename T, typename F>
void Each(A& a, T& container, F&& archive) {
  a.Size(container);
  for (auto& element : container) archive(a, element);
}

template <typename A, typename P>
void ArchivePolygons(A& a, P& polygons) {
  Each(a, polygons,
       [](A& b, auto& ring) { Each(b, ring, [](A& c, auto& vertex) { Vector2(c, vertex); }); });
}

template <typename A, typename F>
void ArchiveFloor(A& a, F& floor) {
  a.Scalar(floor.number);
  a.Text(floor.name);
  a.Scalar(floor.height_m);
  Vector2(a, floor.min_corner);
  Vector2(a, floor.max_corner);
  ArchivePolygons(a, floor.outline);
  ArchivePolygons(a, floor.obstacles);
  Each(a, floor.ways.nodes, [](A& b, auto& node) { Vector2(b, node); });
  Each(a, floor.ways.links, [](A& b, auto& link) {
    b.Scalar(link[0]);
    b.Scalar(link[1]);
  });
  a.Text(floor.image.path);
  Vector2(a, floor.image.min_corner);
  Vector2(a, floor.image.max_corner);
}

void ArchiveOrigin(Writer& a, const std::optional<GeoReference>& origin) {
  a.Scalar(static_cast<std::uint8_t>(origin.has_value()));
  const GeoReference value = origin.value_or(GeoReference{});
  a.Scalar(value.latitude_deg);
  a.Scalar(value.longitude_deg);
  a.Scalar(value.rotation_rad);
}

void ArchiveOrigin(Reader& a, std::optional<GeoReference>& origin) {
  std::uint8_t present = 0;
  GeoReference value;
  a.Scalar(present);
  a.Scalar(value.latitude_deg);
  a.Scalar(value.longitude_deg);
  a.Scalar(value.rotation_rad);
  if (present != 0) origin = value;
}

template <typename A, typename G>
void ArchiveGrid(A& a, G& grid) {
  Vector2(a, grid.origin_m);
  a.Scalar(grid.spacing_m);
  a.Scalar(grid.columns);
  a.Scalar(grid.rows);
}

template <typename A, typename M>
void ArchiveMap(A& a, M& map) {
  a.Scalar(map.floor);
  a.Scalar(map.radio);
  ArchiveGrid(a, map.grid);
  a.Scalar(map.sigma_min_db);
  a.Scalar(map.n_eff);
  a.Scalar(map.hear_weight);
  a.Scalar(map.map_error_sigma_m);
  a.Scalar(map.map_error_growth);
  a.Scalar(map.body_shadow_db);
  Each(a, map.fields, [](A& b, auto& field) {
    b.Scalar(field.transmitter);
    b.Scalar(field.column);
    b.Scalar(field.row);
    b.Scalar(field.columns);
    b.Scalar(field.rows);
    b.Scalar(field.background_mean_dbm);
    b.Scalar(field.background_log_sigma);
    b.Scalar(field.background_logit_hear);
    Vector2(b, field.source_m);
    b.Scalars(field.mean_dbm);
    b.Scalars(field.log_sigma);
    b.Scalars(field.logit_hear);
  });
  a.Scalars(map.silence_nats);
  a.Scalars(map.survey_distance_m);
}

template <typename A, typename M>
void ArchiveMagneticMap(A& a, M& map) {
  a.Scalar(map.floor);
  ArchiveGrid(a, map.grid);
  for (auto& component : map.components) {
    a.Scalars(component.mean_ut);
    a.Scalars(component.log_sigma);
  }
  a.Scalar(map.sigma_min_ut);
  a.Scalar(map.correlation_s);
  a.Scalar(map.map_error_sigma_m);
}

template <typename A, typename S>
void ArchiveScan(A& a, S& scan) {
  a.Scalar(scan.printed_ns);
  a.Scalar(scan.walk);
  a.Scalar(scan.trial);
  a.Scalar(scan.floor);
  a.Scalar(scan.radio);
  a.Scalar(scan.device_offset_db);
  Each(a, scan.readings, [](A& b, auto& reading) {
    b.Scalar(reading.transmitter);
    b.Scalar(reading.rssi_dbm);
    b.Scalar(reading.age_s);
    Vector2(b, reading.position_m);
    b.Scalar(reading.heading_rad);
    b.Scalar(reading.shadow_db);
  });
}

template <typename A, typename S>
void ArchiveSite(A& a, S& site) {
  a.Text(site.building.name);
  Each(a, site.building.floors, [](A& b, auto& floor) { ArchiveFloor(b, floor); });
  Each(a, site.building.connectors, [](A& b, auto& connector) {
    b.Text(connector.name);
    b.Scalar(connector.kind);
    b.Scalar(connector.radius_m);
    Each(b, connector.stops, [](A& c, auto& stop) {
      c.Scalar(stop.floor);
      Vector2(c, stop.position);
    });
  });
  ArchiveOrigin(a, site.building.origin);
  Each(a, site.transmitters, [](A& b, auto& transmitter) {
    b.Scalar(transmitter.radio);
    b.Text(transmitter.name);
  });
  Each(a, site.path, [](A& b, auto& point) {
    Vector2(b, point.position_m);
    b.Scalar(point.floor);
    b.Scalar(point.walk);
  });
  Each(a, site.scans, [](A& b, auto& scan) { ArchiveScan(b, scan); });
  Each(a, site.magnetic, [](A& b, auto& sample) {
    Vector2(b, sample.position_m);
    b.Scalar(sample.floor);
    b.Scalar(sample.walk);
    b.Scalar(sample.trial);
    b.Scalar(sample.norm_ut);
    b.Scalar(sample.inclination_rad);
  });
  Each(a, site.maps, [](A& b, auto& map) { ArchiveMap(b, map); });
  Each(a, site.magnetic_maps, [](A& b, auto& map) { ArchiveMagneticMap(b, map); });
  Each(a, site.barometric_offsets, [](A& b, auto& offset) {
    b.Text(offset.device);
    b.Scalar(offset.unix_ns);
    b.Scalar(offset.offset_m);
    b.Scalar(offset.sigma_m);
  });
  Each(a, site.loudness, [](A& b, auto& loudness) {
    b.Text(loudness.device);
    b.Scalar(loudness.radio);
    b.Scalar(loudness.mean_db);
    b.Scalar(loudness.sigma_db);
  });
  for (auto& lag_s : site.reading_lag_s) a.Scalar(lag_s);
}

// Control points of a grid; 0 where it is no grid to interpolate on.
std::uint64_t PointsOf(const FieldGrid& grid) {
  if (grid.columns < 4 || grid.rows < 4 || !(grid.spacing_m > 0)) return 0;
  return static_cast<std::uint64_t>(grid.columns) * static_cast<std::uint64_t>(grid.rows);
}

bool IsConsistent(const MagneticMap& map) {
  const std::uint64_t points = PointsOf(map.grid);
  return points > 0 && map.sigma_min_ut > 0 && map.correlation_s > 0 &&
         std::all_of(map.components.begin(), map.components.end(), [points](const auto& component) {
           return component.mean_ut.size() == points && component.log_sigma.size() == points;
         });
}

// What queries rely on without looking: sizes that fit each other and indices that exist.
bool IsConsistent(const Site& site) {
  for (const MagneticMap& map : site.magnetic_maps) {
    if (!IsConsistent(map)) return false;
  }
  for (const RadioMap& map : site.maps) {
    const FieldGrid& grid = map.grid;
    const std::uint64_t points = PointsOf(grid);
    if (points == 0 || map.silence_nats.size() != points) return false;
    if (!map.survey_distance_m.empty() && map.survey_distance_m.size() != points) return false;
    for (const RadioMap::TransmitterField& f : map.fields) {
      if (f.column < 0 || f.row < 0 || f.columns < 0 || f.rows < 0) return false;
      if (f.columns > grid.columns - f.column || f.rows > grid.rows - f.row) return false;
      const auto size = static_cast<std::uint64_t>(f.columns) * f.rows;
      if (f.mean_dbm.size() != size || f.log_sigma.size() != size || f.logit_hear.size() != size) {
        return false;
      }
      if (f.transmitter >= site.transmitters.size()) return false;
    }
  }
  for (const SurveyScan& scan : site.scans) {
    for (const SurveyReading& reading : scan.readings) {
      if (reading.transmitter >= site.transmitters.size()) return false;
    }
  }
  return true;
}

}  // namespace

std::string SerializeSite(const Site& site) {
  Writer content;
  ArchiveSite(content, site);
  const std::string body = content.Take();
  Writer header;
  header.Scalar(kVersion);
  header.Scalar(static_cast<std::uint64_t>(body.size()));
  header.Scalar(Fnv1a(body));
  return std::string(kMagic, kMagicSize) + header.Take() + body;
}

Site ParseSite(const std::string& bytes, const std::string& name) {
  if (bytes.size() < kMagicSize || bytes.compare(0, kMagicSize, kMagic) != 0) {
    throw InputError(name, 0, "not a site file", "a file written by walkgraph survey");
  }
  if (bytes.size() < kHeaderSize) {
    throw InputError(name, 0, "cut after " + std::to_string(bytes.size()) + " bytes",
                     "a header of " + std::to_string(kHeaderSize) + " bytes");
  }
  Reader header(std::string_view(bytes).substr(kMagicSize), name);
  std::uint32_t version = 0;
  std::uint64_t size = 0, checksum = 0;
  header.Scalar(version);
  header.Scalar(size);
  header.Scalar(checksum);
  if (version != kVersion) {
    throw InputError(name, 0, "site format version " + std::to_string(version),
                     "version " + std::to_string(kVersion) + " (train the site again)");
  }
  const std::string_view body = std::string_view(bytes).substr(kHeaderSize);
  if (body.size() != size) {
    throw InputError(name, 0, "content of " + std::to_string(body.size()) + " bytes",
                     std::to_string(size) + " bytes (the file was cut or has grown)");
  }
  if (Fnv1a(body) != checksum) {
    throw InputError(name, 0, "damaged content", "bytes that match the file's checksum");
  }
  Site site;
  Reader content(body, name);
  ArchiveSite(content, site);
  content.ExpectEnd();
  if (!IsConsistent(site)) {
    throw InputError(name, 0, "fields whose sizes do not fit", "a consistent site");
  }
  return site;
}

void WriteSiteFile(const Site& site, const std::string& path) {
  const std::string bytes = SerializeSite(site);
  const std::string beside = path + ".partial";
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) throw std::runtime_error(path + ": cannot be written");
  }
  std::filesystem::rename(beside, path);
}

Site ReadSiteFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  // A folder opens, but reading it throws something else.
  if (!in || std::filesystem::is_directory(path))
    throw InputError(path, 0, "cannot be opened", "a site file");
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return ParseSite(bytes, path);
}

}  // namespace walkgraph
