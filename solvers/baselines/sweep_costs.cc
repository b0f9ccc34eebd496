#include "solvers/baselines/sweep_costs.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <string_view>
#include <type_traits>
#include <utility>

#include "solvers/baselines/likelihood_grid.h"

namespace walkgraph {
namespace {

// A hash of the values it is given, in their order; of this process only.
class ContentHash {
 public:
  template <typename Number>
  void Add(std::span<const Number> numbers) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>, "padding has no value");
    const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()),
                                 numbers.size_bytes());
    Mix(std::hash<std::string_view>()(bytes));
  }
  template <typename... Number>
  void Add(Number... numbers) {
    (Add(std::span<const Number>(&numbers, 1)), ...);
  }
  std::uint64_t value() const { return value_; }

 private:
  void Mix(std::uint64_t more) {
    value_ = (value_ ^ more) * 0x9e3779b97f4a7c15U;
    value_ ^= value_ >> 32U;
  }
  std::uint64_t value_ = 0;
};

std::uint64_t HashOfField(const RadioMap::TransmitterField& field) {
  ContentHash hash;
  hash.Add(field.transmitter, field.column, field.row, field.columns, field.rows);
  hash.Add(field.background_mean_dbm, field.background_log_sigma, field.background_logit_hear);
  hash.Add(field.source_m.x(), field.source_m.y());
  for (const std::vector<float>* values : {&field.mean_dbm, &field.log_sigma, &field.logit_hear}) {
    hash.Add(std::span<const float>(*values));
  }
  return hash.value();
}

// What all sweeps share: the places, what the map has besides its transmitters, the offset and the
// loss.
std::uint64_t HashOfPlaces(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                           const RssiOffsetPrior& offset, const LossSettings& loss) {
  ContentHash hash;
  hash.Add(map.grid.origin_m.x(), map.grid.origin_m.y(), map.grid.spacing_m, map.grid.columns,
           map.grid.rows, map.sigma_min_db, map.hear_weight, map.body_shadow_db);
  hash.Add(std::span<const float>(map.silence_nats));
  hash.Add(offset.mean_db, offset.sigma_db, loss.kind, loss.scale);
  for (const Eigen::Vector2d& position : positions_m) hash.Add(position.x(), position.y());
  return hash.value();
}

// Reads of the map only the fields that sweeps ask for, each once: all would take as long as the
// answer.
class SweepHasher {
 public:
  explicit SweepHasher(const RadioMap& map) : map_(map) {}

  std::uint64_t operator()(const MapSweep& sweep) {
    ContentHash hash;
    hash.Add(sweep.weight, sweep.silence_share, sweep.readings.size(), sweep.facing.x(),
             sweep.facing.y());
    for (const MapSweep::Reading& reading : sweep.readings) {
      hash.Add(reading.rssi_dbm, reading.precision);
      hash.Add(OfField(reading.field));
    }
    return hash.value();
  }

 private:
  std::uint64_t OfField(int field) {
    const auto [known, is_new] = of_field_.try_emplace(field);
    if (is_new) known->second = HashOfField(map_.fields[static_cast<std::size_t>(field)]);
    return known->second;
  }

  const RadioMap& map_;
  std::map<int, std::uint64_t> of_field_;
};

class RecentCosts {
 public:
  using Key = std::pair<std::uint64_t, std::uint64_t>;  // of places, of a sweep
  using Costs = SweepCosts::value_type;

  Costs Find(const Key& key) {
    const auto known = by_key_.find(key);
    if (known == by_key_.end()) return nullptr;
    recent_.splice(recent_.begin(), recent_, known->second);
    return recent_.front().costs;
  }

  void Keep(const Key& key, Costs costs) {
    const auto [known, is_new] = by_key_.try_emplace(key);
    if (!is_new) return;  // two sweeps alike
    numbers_ += costs->size();
    recent_.push_front({key, std::move(costs)});
    known->second = recent_.begin();
    while (numbers_ > kMostNumbers) {
      numbers_ -= recent_.back().costs->size();
      by_key_.erase(recent_.back().key);
      recent_.pop_back();
    }
  }

 private:
  static constexpr std::size_t kMostNumbers = 4'000'000;  // 16 MB
  struct Entry {
    Key key;
    Costs costs;
  };
  std::list<Entry> recent_;  // last asked for first
  std::map<Key, std::list<Entry>::iterator> by_key_;
  std::size_t numbers_ = 0;
};

}  // namespace

SweepCosts EvaluateSweeps(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                          const RssiOffsetPrior& offset, const LossSettings& loss,
                          std::span<const MapSweep> sweeps) {
  static thread_local RecentCosts recent;
  const std::uint64_t places = HashOfPlaces(map, positions_m, offset, loss);
  SweepHasher hash_of(map);
  SweepCosts costs;
  std::vector<std::size_t> missing;  // of the sweeps
  std::vector<RecentCosts::Key> keys;
  for (const MapSweep& sweep : sweeps) {
    keys.emplace_back(places, hash_of(sweep));
    costs.push_back(recent.Find(keys.back()));
    if (!costs.back()) missing.push_back(costs.size() - 1);
  }
  if (missing.empty()) return costs;
  std::vector<MapSweep> asked;
  for (const std::size_t s : missing) asked.push_back(sweeps[s]);
  auto evaluated = LikelihoodGrid(map, positions_m, offset, loss).Evaluate(asked);
  for (std::size_t m = 0; m < missing.size(); ++m) {
    auto& cost = costs[missing[m]];
    cost = std::make_shared<const std::vector<float>>(std::move(evaluated[m]));
    recent.Keep(keys[missing[m]], cost);
  }
  return costs;
}

}  // namespace walkgraph
