#include "solvers/baselines/sweep_costs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <set>
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

void AddField(const RadioMap::TransmitterField& field, ContentHash* hash) {
  hash->Add(field.transmitter, field.column, field.row, field.columns, field.rows);
  hash->Add(field.background_mean_dbm, field.background_log_sigma, field.background_logit_hear);
  for (const std::vector<float>* values : {&field.mean_dbm, &field.log_sigma, &field.logit_hear}) {
    hash->Add(std::span<const float>(*values));
  }
}

// Of the map only the fields that the sweeps ask for: all would take as long as the answer.
std::uint64_t HashOfPlaces(const RadioMap& map, std::span<const Eigen::Vector2d> positions_m,
                           std::span<const MapSweep> sweeps) {
  ContentHash hash;
  hash.Add(map.grid.origin_m.x(), map.grid.origin_m.y(), map.grid.spacing_m, map.grid.columns,
           map.grid.rows, map.sigma_min_db, map.hear_weight);
  std::set<int> asked;
  for (const MapSweep& sweep : sweeps) {
    for (const MapSweep::Reading& reading : sweep.readings) asked.insert(reading.field);
  }
  for (const int field : asked) AddField(map.fields[static_cast<std::size_t>(field)], &hash);
  hash.Add(std::span<const float>(map.silence_nats));
  for (const Eigen::Vector2d& position : positions_m) hash.Add(position.x(), position.y());
  return hash.value();
}

std::uint64_t HashOfSweeps(const RssiOffsetPrior& offset, const LossSettings& loss,
                           std::span<const MapSweep> sweeps) {
  ContentHash hash;
  hash.Add(offset.mean_db, offset.sigma_db, loss.kind, loss.scale);
  for (const MapSweep& sweep : sweeps) {
    hash.Add(sweep.weight, sweep.silence_share, sweep.readings.size());
    for (const MapSweep::Reading& reading : sweep.readings) {
      hash.Add(reading.field, reading.rssi_dbm, reading.precision);
    }
  }
  return hash.value();
}

class RecentCosts {
 public:
  using Key = std::pair<std::uint64_t, std::uint64_t>;

  std::shared_ptr<const SweepCosts> Find(const Key& key) {
    const auto known = std::find_if(recent_.begin(), recent_.end(),
                                    [&key](const Entry& entry) { return entry.key == key; });
    if (known == recent_.end()) return nullptr;
    recent_.splice(recent_.begin(), recent_, known);
    return recent_.front().costs;
  }

  void Keep(const Key& key, std::shared_ptr<const SweepCosts> costs, std::size_t numbers) {
    if (numbers > kMostNumbers) return;
    recent_.push_front({key, std::move(costs), numbers});
    numbers_ += numbers;
    while (numbers_ > kMostNumbers) {
      numbers_ -= recent_.back().numbers;
      recent_.pop_back();
    }
  }

 private:
  static constexpr std::size_t kMostNumbers = 4'000'000;  // 16 MB
  struct Entry {
    Key key;
    std::shared_ptr<const SweepCosts> costs;
    std::size_t numbers = 0;
  };
  std::list<Entry> recent_;  // last asked for first
  std::size_t numbers_ = 0;
};

}  // namespace

std::shared_ptr<const SweepCosts> EvaluateSweeps(const RadioMap& map,
                                                 std::span<const Eigen::Vector2d> positions_m,
                                                 const RssiOffsetPrior& offset,
                                                 const LossSettings& loss,
                                                 std::span<const MapSweep> sweeps) {
  static thread_local RecentCosts recent;
  const RecentCosts::Key key = {HashOfPlaces(map, positions_m, sweeps),
                                HashOfSweeps(offset, loss, sweeps)};
  if (auto known = recent.Find(key)) return known;
  const LikelihoodGrid grid(map, positions_m, offset, loss);
  auto costs = std::make_shared<const SweepCosts>(grid.Evaluate(sweeps));
  recent.Keep(key, costs, positions_m.size() * sweeps.size());
  return costs;
}

}  // namespace walkgraph
