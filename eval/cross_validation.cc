#include "eval/cross_validation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "eval/random.h"

namespace walkgraph {
namespace {

constexpr std::array<std::string_view, 5> kSplitNames = {"walk", "session", "trial", "phone",
                                                         "block"};
constexpr double kSessionGapS = 60.0;
constexpr double kSessionGapM = 1.0;
constexpr double kBlockSideM = 20.0;

// Whether `next` begins where and when `last` ended.
bool Continues(const Truth& last, const Truth& next) {
  const Waypoint& end = last.waypoints.back();
  const Waypoint& begin = next.waypoints.front();
  const double gap_s = SecondsBetween(end.time_ns, begin.time_ns);
  return gap_s >= 0 && gap_s <= kSessionGapS && begin.floor == end.floor &&
         (begin.position - end.position).norm() <= kSessionGapM;
}

std::vector<std::string> GroupSessions(const std::vector<WalkToSplit>& walks) {
  std::vector<std::string> groups(walks.size());
  std::vector<std::size_t> order;  // walks with waypoints, by time of the first
  for (std::size_t i = 0; i < walks.size(); ++i) {
    groups[i] = walks[i].id;
    if (!walks[i].truth->waypoints.empty()) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return walks[a].truth->waypoints.front().time_ns < walks[b].truth->waypoints.front().time_ns;
  });
  // Two phones may walk at once, so the predecessor need not be the walk just before.
  for (std::size_t j = 0; j < order.size(); ++j) {
    for (std::size_t i = j; i-- > 0;) {
      if (Continues(*walks[order[i]].truth, *walks[order[j]].truth)) {
        groups[order[j]] = groups[order[i]];
        break;
      }
    }
  }
  return groups;
}

std::string BlockOf(const WalkToSplit& walk) {
  const std::vector<Waypoint>& waypoints = walk.truth->waypoints;
  if (waypoints.empty()) return walk.id;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Waypoint& waypoint : waypoints) mean += waypoint.position;
  mean /= static_cast<double>(waypoints.size());
  const auto index = [](double x) {
    return std::to_string(static_cast<long>(std::floor(x / kBlockSideM)));
  };
  return "block " + std::to_string(waypoints.front().floor) + " " + index(mean.x()) + " " +
         index(mean.y());
}

std::vector<std::uint64_t> TransmitterHashes(const Evidence& evidence) {
  std::vector<std::uint64_t> hashes;
  for (const Transmitter& transmitter : evidence.transmitters) {
    hashes.push_back(HashText(std::string(RadioName(transmitter.radio)) + " " + transmitter.name));
  }
  return hashes;
}

std::uint64_t ReadingKey(const std::vector<std::uint64_t>& transmitters,
                         const RadioReading& reading) {
  return transmitters[reading.transmitter] ^
         MixBits(static_cast<std::uint64_t>(reading.heard_ns) + 1);
}

}  // namespace

std::optional<SplitBy> SplitByName(std::string_view name) {
  const auto found = std::find(kSplitNames.begin(), kSplitNames.end(), name);
  if (found == kSplitNames.end()) return std::nullopt;
  return static_cast<SplitBy>(found - kSplitNames.begin());
}

std::vector<std::string> GroupWalks(const std::vector<WalkToSplit>& walks, SplitBy split) {
  if (split == SplitBy::kSession) return GroupSessions(walks);
  std::vector<std::string> groups;
  for (const WalkToSplit& walk : walks) {
    switch (split) {
      case SplitBy::kTrial:
        groups.push_back(walk.trial);
        break;
      case SplitBy::kPhone:
        groups.push_back(walk.device);
        break;
      case SplitBy::kBlock:
        groups.push_back(BlockOf(walk));
        break;
      default:
        groups.push_back(walk.id);
    }
  }
  return groups;
}

int FoldOfGroup(std::string_view group, int folds) {
  // FNV's low bits mix poorly on short names; the finaliser spreads them.
  return static_cast<int>(MixBits(HashText(group)) % static_cast<std::uint64_t>(folds));
}

void HeardReadings::Add(const Evidence& evidence) {
  const std::vector<std::uint64_t> transmitters = TransmitterHashes(evidence);
  for (const RadioReading& reading : evidence.readings) {
    keys_.push_back(ReadingKey(transmitters, reading));
  }
}

void HeardReadings::Freeze() { std::sort(keys_.begin(), keys_.end()); }

int HeardReadings::RemoveFrom(Evidence* evidence) const {
  const std::vector<std::uint64_t> transmitters = TransmitterHashes(*evidence);
  return static_cast<int>(std::erase_if(evidence->readings, [&](const RadioReading& reading) {
    return std::binary_search(keys_.begin(), keys_.end(), ReadingKey(transmitters, reading));
  }));
}

}  // namespace walkgraph
