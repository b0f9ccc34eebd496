#include "data/simulator/itinerary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace walkgraph {
namespace {

constexpr double kStraightRad = 0.5;  // what is still straight on
constexpr double kEndShare = 0.25;    // of a link: walks begin and end no nearer to its nodes

bool IsCabin(const Plan& plan, int node) {
  return std::any_of(plan.links.begin(), plan.links.end(), [node](const WayLink& link) {
    return link.kind == WayKind::kLift && (link.from == node || link.to == node);
  });
}

int OtherEnd(const WayLink& link, int node) { return link.from == node ? link.to : link.from; }

bool LeadsToCabin(const Plan& plan, const WayLink& link) {
  return link.kind == WayKind::kCorridor && (IsCabin(plan, link.from) || IsCabin(plan, link.to));
}

class TourMaker {
 public:
  TourMaker(const Plan& plan, const Gait& gait, const SimulationSettings& settings, Random* random)
      : plan_(plan), gait_(gait), settings_(settings), random_(random) {
    next_stop_s_ = StopInterval();
  }

  std::vector<Leg> Make(int first_link, double duration_s);

 private:
  struct PlannedStop {
    std::size_t corner;  // that it comes before
    double share;        // of the way there from the corner before it
    double duration_s;
  };

  void Begin(int first_link);
  // A link to go on along from the node that was reached; -1 in a dead end.
  int ChooseLink();
  int ChooseCorridor(const std::vector<int>& corridors);
  void Follow(int link);
  void AddCorner(const Eigen::Vector2d& position_m, double height_m, WayKind kind);
  void GoHalfWay(int link);
  void CloseLeg(double lift_rise_m, bool last);
  double StopInterval();
  Eigen::Vector2d Scattered(int node);

  const Plan& plan_;
  Gait gait_;
  const SimulationSettings& settings_;
  Random* random_;
  std::vector<Leg> legs_;
  std::vector<RouteCorner> corners_;
  std::vector<PlannedStop> stops_;
  int node_ = 0;
  int arrived_by_ = -1;
  double elapsed_s_ = 0;  // as planned
  double next_stop_s_ = 0;
};

double TourMaker::StopInterval() {
  const double mean_s = settings_.walks.stop_every_s;
  const double lot = -std::log(1.0 - random_->Uniform());
  return mean_s > 0.0 ? mean_s * lot : 1e12;
}

Eigen::Vector2d TourMaker::Scattered(int node) {
  Eigen::Vector2d position_m = plan_.Node(node).position_m;
  if (plan_.scatter_m > 0.0) {
    position_m.x() += random_->Uniform(-plan_.scatter_m, plan_.scatter_m);
    position_m.y() += random_->Uniform(-plan_.scatter_m, plan_.scatter_m);
  }
  return position_m;
}

void TourMaker::AddCorner(const Eigen::Vector2d& position_m, double height_m, WayKind kind) {
  const GaitSettings& gait = settings_.gait;
  const RideSettings& ride = settings_.ride;
  double speed_mps = gait_.step_rate_hz * gait_.step_length_m;
  if (kind == WayKind::kStairs) speed_mps = gait.tread_m * gait.stairs_up_rate_hz;
  if (kind == WayKind::kEscalator) speed_mps = ride.escalator_speed_mps;
  const double takes_s = (position_m - corners_.back().position_m).norm() / speed_mps;
  corners_.push_back({position_m, height_m, kind});
  elapsed_s_ += takes_s;
  if (kind != WayKind::kCorridor || elapsed_s_ < next_stop_s_) return;
  const double duration_s = -settings_.walks.stop_s * std::log(1.0 - random_->Uniform());
  stops_.push_back({corners_.size() - 1, random_->Uniform(0.3, 0.7), duration_s});
  elapsed_s_ += duration_s;
  next_stop_s_ = elapsed_s_ + StopInterval();
}

void TourMaker::Begin(int first_link) {
  const WayLink& link = plan_.Link(first_link);
  const bool forward = random_->Uniform() < 0.5;
  node_ = forward ? link.to : link.from;
  const Eigen::Vector2d from = plan_.Node(OtherEnd(link, node_)).position_m;
  const Eigen::Vector2d to = plan_.Node(node_).position_m;
  const double share = random_->Uniform(kEndShare, 1.0 - kEndShare);
  const double height_m = plan_.HeightOf(plan_.Node(node_).floor);
  corners_ = {{from + share * (to - from), height_m, WayKind::kCorridor}};
  AddCorner(Scattered(node_), height_m, WayKind::kCorridor);
  arrived_by_ = first_link;
}

int TourMaker::ChooseCorridor(const std::vector<int>& corridors) {
  if (corridors.empty()) return -1;
  const Eigen::Vector2d came =
      corners_.size() < 2
          ? Eigen::Vector2d(0.0, 0.0)
          : Eigen::Vector2d(corners_.back().position_m - corners_[corners_.size() - 2].position_m);
  const double lot = random_->Uniform();
  for (const int link : corridors) {
    const Eigen::Vector2d goes =
        plan_.Node(OtherEnd(plan_.Link(link), node_)).position_m - plan_.Node(node_).position_m;
    const double turn = std::atan2(came.x() * goes.y() - came.y() * goes.x(), came.dot(goes));
    const bool straight = came.norm() > 0.0 && std::abs(turn) < kStraightRad;
    if (straight && lot < settings_.walks.straight_share) return link;
  }
  return corridors[static_cast<std::size_t>(random_->Index(static_cast<int>(corridors.size())))];
}

int TourMaker::ChooseLink() {
  std::vector<int> corridors;
  std::vector<int> connectors;
  const bool in_cabin = IsCabin(plan_, node_);
  const bool rode = arrived_by_ >= 0 && plan_.Link(arrived_by_).kind == WayKind::kLift;
  for (int i = 0; i < static_cast<int>(plan_.links.size()); ++i) {
    const WayLink& link = plan_.Link(i);
    if (i == arrived_by_ || (link.from != node_ && link.to != node_)) continue;
    const bool corridor = link.kind == WayKind::kCorridor;
    if (corridor && (in_cabin || !LeadsToCabin(plan_, link))) {
      corridors.push_back(i);
    } else if (settings_.walks.change_floors && !(in_cabin && rode)) {
      connectors.push_back(i);
    }
  }
  const double lot = random_->Uniform();
  const bool connect = in_cabin ? !rode : lot < settings_.walks.connector_share;
  if (connect && !connectors.empty()) {
    return connectors[static_cast<std::size_t>(
        random_->Index(static_cast<int>(connectors.size())))];
  }
  return ChooseCorridor(corridors);
}

void TourMaker::Follow(int index) {
  const WayLink& link = plan_.Link(index);
  const int target = OtherEnd(link, node_);
  const double height_m = plan_.HeightOf(plan_.Node(target).floor);
  if (link.kind == WayKind::kLift) {
    const double rise_m = height_m - plan_.HeightOf(plan_.Node(node_).floor);
    CloseLeg(rise_m, false);
    corners_ = {{plan_.Node(target).position_m, height_m, WayKind::kCorridor}};
    elapsed_s_ += 2.0 * settings_.ride.door_s + LiftRide(rise_m, settings_.ride).duration_s();
  } else {
    std::vector<WayPoint> bends = link.bends;
    if (link.from != node_) std::reverse(bends.begin(), bends.end());
    for (std::size_t i = 0; i < bends.size(); ++i) {
      // Level from the node to the foot, and from the top to the node.
      AddCorner(bends[i].position_m, bends[i].height_m, i == 0 ? WayKind::kCorridor : link.kind);
    }
    AddCorner(Scattered(target), height_m, WayKind::kCorridor);
  }
  node_ = target;
  arrived_by_ = index;
}

void TourMaker::GoHalfWay(int index) {
  const WayLink& link = plan_.Link(index);
  const Eigen::Vector2d from = corners_.back().position_m;
  const Eigen::Vector2d to = plan_.Node(OtherEnd(link, node_)).position_m;
  const double share = random_->Uniform(kEndShare, 1.0 - kEndShare);
  AddCorner(from + share * (to - from), corners_.back().height_m, WayKind::kCorridor);
}

void TourMaker::CloseLeg(double lift_rise_m, bool last) {
  Leg leg = {.route = Route(corners_, {!legs_.empty(), !last}, random_),
             .lift_rise_m = lift_rise_m};
  for (const PlannedStop& stop : stops_) {
    const double before_m = leg.route.CornerAt(stop.corner - 1);
    const double after_m = leg.route.CornerAt(stop.corner);
    leg.stops.push_back({before_m + stop.share * (after_m - before_m), stop.duration_s});
  }
  stops_.clear();
  legs_.push_back(std::move(leg));
}

std::vector<Leg> TourMaker::Make(int first_link, double duration_s) {
  Begin(first_link);
  while (true) {
    const int link = ChooseLink();
    if (link < 0) {  // a dead end: about turn
      CloseLeg(0.0, false);
      corners_ = {corners_.back()};
      corners_.back().kind = WayKind::kCorridor;
      arrived_by_ = -1;
      continue;
    }
    const bool ends = elapsed_s_ >= duration_s && plan_.Link(link).kind == WayKind::kCorridor &&
                      !LeadsToCabin(plan_, plan_.Link(link));
    if (ends) {
      GoHalfWay(link);
      CloseLeg(0.0, true);
      return std::move(legs_);
    }
    Follow(link);
  }
}

}  // namespace

std::vector<int> CorridorLinks(const Plan& plan) {
  std::vector<int> links;
  for (int i = 0; i < static_cast<int>(plan.links.size()); ++i) {
    const WayLink& link = plan.Link(i);
    if (link.kind == WayKind::kCorridor && !LeadsToCabin(plan, link)) links.push_back(i);
  }
  return links;
}

std::vector<Leg> RandomTour(const Plan& plan, int first_link, const Gait& gait,
                            const SimulationSettings& settings, double duration_s, Random* random) {
  return TourMaker(plan, gait, settings, random).Make(first_link, duration_s);
}

}  // namespace walkgraph
