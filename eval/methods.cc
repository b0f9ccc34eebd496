#include "eval/methods.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "eval/suggest.h"
#include "eval/usage_error.h"
#include "solvers/baselines/ahf/ahf.h"
#include "solvers/baselines/dsff/dsff.h"
#include "solvers/baselines/mufaf/mufaf.h"
#include "solvers/baselines/tcpf/tcpf.h"
#include "solvers/baselines/viterbi.h"
#include "solvers/batch_smoother.h"
#include "solvers/floor_by_floor.h"
#include "solvers/lagged_batch.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

const Method* FindMethod(const std::string& name) {
  std::vector<std::string> names;
  for (const Method& method : Methods()) {
    if (method.name == name) return &method;
    names.push_back(method.name);
  }
  throw UsageError("unknown method \"" + name + "\"" + DidYouMean(name, names) +
                   ", expected one that `walkgraph methods` lists");
}

Method Describe(const MethodDescription& description, decltype(Method::make) make) {
  return {std::string(description.name), description, std::move(make), false};
}

// A method that knows one floor only.
Method DescribeFloorwise(const MethodDescription& description, decltype(Method::make) make) {
  return {std::string(description.name), description,
          [make = std::move(make)](const Settings& s) {
            return std::make_unique<FloorByFloor>(make(s), s.factors);
          },
          true};
}

template <typename Method>
std::unique_ptr<Estimator> Own(Method method) {
  return std::make_unique<Method>(std::move(method));
}

constexpr MethodDescription kViterbiDescription{
    "viterbi", "the graph's motion, radio map and noise on a lattice; its proposal too",
    "Viterbi, IEEE Trans. Information Theory 13, 1967",
    "cell and heading offset are the hidden state; cells off the plan cost what they cost the "
    "graph (factors.area); no covariance"};

constexpr MethodDescription kWindowDescription{
    "window", "the factor graph over the last seconds, as a phone could run it",
    "Sibley, Matthies and Sukhatme, J. Field Robotics 27, 2010 (sliding window filter)",
    "reports a node when it leaves the window (--lag=0: when it arrives); grows until the walk is "
    "located; follows several hypotheses until the evidence tells them apart"};

constexpr MethodDescription kBatchDescription{
    "batch", "the factor graph over the whole walk, with the covariance of every node",
    "Dellaert and Kaess, Factor Graphs for Robot Perception, 2017",
    "modes compared by the posterior mass about each; the covariance mixes those that are kept"};

constexpr MethodDescription kLaggedBatchDescription{
    "lagged_batch", "what a lag can know at most: a batch every 2 s on what was seen until then",
    "our choice: the bound that `window` is measured against",
    "slow: a solve of everything for every two seconds of the walk"};

// Position by position, dead reckoning, and HIPE.
std::vector<Method> SimpleMethods() {
  return {
      Describe(kNearestNeighbourDescription,
               [](const Settings& s) {
                 return Own(WknnEstimator::NearestNeighbour(s.baselines.wknn, s.factors));
               }),
      Describe(
          kWknnDescription,
          [](const Settings& s) { return Own(WknnEstimator::Wknn(s.baselines.wknn, s.factors)); }),
      Describe(kDeadReckoningDescription,
               [](const Settings& s) {
                 return Own(DeadReckoningEstimator(s.baselines.pdr, s.baselines.wknn, s.factors));
               }),
      DescribeFloorwise(kMleDescription,
                        [](const Settings& s) {
                          return Own(MleEstimator(s.baselines.mle, s.baselines.wknn, s.factors));
                        }),
      DescribeFloorwise(kHipeFilterDescription,
                        [](const Settings& s) {
                          return Own(HipeEstimator(HipeSolver::kFilter, s.baselines.hipe,
                                                   s.baselines.wknn, s.factors));
                        }),
      DescribeFloorwise(kHipeViterbiDescription,
                        [](const Settings& s) {
                          return Own(HipeEstimator(HipeSolver::kViterbi, s.baselines.hipe,
                                                   s.baselines.wknn, s.factors));
                        }),
  };
}

std::vector<Method> TcpfMethods() {
  std::vector<Method> methods;
  for (const TcpfMethod& method : kTcpfMethods) {
    methods.push_back(DescribeFloorwise(method.description, [&method](const Settings& s) {
      const BaselineSettings& b = s.baselines;
      return Own(TcpfEstimator(method, b.tcpf, b.pdr, b.wknn, s.factors));
    }));
  }
  return methods;
}

std::vector<Method> AhfMethods() {
  std::vector<Method> methods;
  for (const AhfMethod& method : kAhfMethods) {
    methods.push_back(DescribeFloorwise(method.description, [&method](const Settings& s) {
      return Own(AhfEstimator(method, s.baselines.ahf, s.baselines.wknn, s.factors));
    }));
  }
  return methods;
}

std::vector<Method> DsffMethods() {
  std::vector<Method> methods;
  for (const DsffMethod& method : kDsffMethods) {
    methods.push_back(Describe(method.description, [&method](const Settings& s) {
      return Own(DsffEstimator(method, s.baselines.dsff, s.baselines.wknn, s.factors));
    }));
  }
  return methods;
}

std::vector<Method> MufafMethods() {
  std::vector<Method> methods;
  for (const MufafMethod& method : kMufafMethods) {
    methods.push_back(DescribeFloorwise(method.description, [&method](const Settings& s) {
      return Own(MufafEstimator(method, s.baselines.mufaf, s.baselines.wknn, s.factors));
    }));
  }
  return methods;
}

// Our own: the lattice, the window, the whole walk.
std::vector<Method> GraphMethods() {
  return {
      Describe(kViterbiDescription,
               [](const Settings& s) { return Own(Viterbi(s.factors, s.baselines.viterbi)); }),
      Describe(
          kWindowDescription,
          [](const Settings& s) { return Own(WindowSmoother(s.factors, s.solver, s.window)); }),
      Describe(kLaggedBatchDescription,
               [](const Settings& s) { return Own(LaggedBatch(s.factors, s.solver, s.window)); }),
      Describe(kBatchDescription,
               [](const Settings& s) { return Own(BatchSmoother(s.factors, s.solver)); }),
  };
}

}  // namespace

const std::vector<Method>& Methods() {
  static const std::vector<Method>* const kMethods = [] {
    auto* methods = new std::vector<Method>;
    for (const auto& group : {SimpleMethods(), TcpfMethods(), AhfMethods(), DsffMethods(),
                              MufafMethods(), GraphMethods()}) {
      methods->insert(methods->end(), group.begin(), group.end());
    }
    return methods;
  }();
  return *kMethods;
}

std::vector<std::unique_ptr<Estimator>> MakeEstimators(const std::vector<const Method*>& methods,
                                                       const Settings& settings) {
  std::vector<std::unique_ptr<Estimator>> estimators;
  estimators.reserve(methods.size());
  for (const Method* method : methods) estimators.push_back(method->make(settings));
  return estimators;
}

std::vector<const Method*> ParseMethods(std::string_view list) {
  std::vector<const Method*> methods;
  while (true) {
    const std::size_t comma = list.find(',');
    const Method* method = FindMethod(std::string(list.substr(0, comma)));
    if (std::find(methods.begin(), methods.end(), method) != methods.end()) {
      throw UsageError("method \"" + method->name + "\" is given twice");
    }
    methods.push_back(method);
    if (comma == std::string_view::npos) return methods;
    list.remove_prefix(comma + 1);
  }
}

}  // namespace walkgraph
