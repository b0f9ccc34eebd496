#include "eval/report/explain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>

#include "data/input_error.h"
#include "eval/report/figures/plot.h"
#include "eval/table.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;
using Points = std::vector<Eigen::Vector2d>;

constexpr int kWidth = 640, kHeight = 160;
constexpr double kLongSilenceS = 10;  // two or three scans missed

class WalkExplainer {
 public:
  WalkExplainer(const std::string& dir, const Json& walk)
      : dir_(dir),
        walk_(walk),
        id_(walk.at("walk").get<std::string>()),
        begin_ns_(walk.at("begin_ns").get<std::int64_t>()) {}

  Explanation Run() {
    FindSpan();
    ErrorFigure();
    for (const auto& [method, entry] : walk_.at("methods").items()) Explain(method, entry);
    return std::move(result_);
  }

 private:
  double Seconds(const Json& time_ns) const {
    return static_cast<double>(time_ns.get<std::int64_t>() - begin_ns_) * 1e-9;
  }

  void FindSpan() {
    for (const auto& [method, entry] : walk_.at("methods").items()) {
      if (!entry.contains("track")) continue;
      for (const Json& t : entry.at("track").at("t")) Widen(t.get<double>());
    }
    for (const Json& point : walk_.at("waypoints")) Widen(point.at(0).get<double>());
    if (!(low_s_ < high_s_)) high_s_ = low_s_ + 1;
  }

  void Widen(double seconds) {
    if (std::isnan(low_s_)) low_s_ = high_s_ = seconds;
    low_s_ = std::min(low_s_, seconds);
    high_s_ = std::max(high_s_, seconds);
  }

  void Note(const std::string& text) { result_.notes.push_back(text); }

  // A plot of lines over the walk's time, which the page's slider marks.
  void TimeFigure(const std::string& name, const std::string& title, const std::string& unit,
                  const std::vector<std::string>& names, const std::vector<Points>& lines) {
    double low = 0, high = 0;
    bool any = false;
    for (const Points& line : lines) {
      for (const Eigen::Vector2d& point : line) {
        low = any ? std::min(low, point.y()) : point.y();
        high = any ? std::max(high, point.y()) : point.y();
        any = true;
      }
    }
    if (!any) return;
    const double margin = high > low ? 0.05 * (high - low) : std::max(1e-3, 0.05 * std::abs(high));
    Plot plot(title, kWidth, kHeight);
    plot.DrawAxes({"time, s", low_s_, high_s_, false},
                  {unit, std::min(low, low - margin), high + margin, false});
    plot.MarkAsTime();
    for (std::size_t i = 0; i < lines.size(); ++i) plot.Line(lines[i], StyleOf(i));
    if (!names.empty()) plot.Legend(names);
    result_.figures.push_back({name, plot.Svg()});
  }

  void ErrorFigure() {
    std::vector<std::string> names;
    std::vector<Points> lines;
    for (const auto& [method, entry] : walk_.at("methods").items()) {
      if (entry.at("errors_m").empty()) continue;
      names.push_back(method);
      lines.emplace_back();
      for (std::size_t i = 0; i < entry.at("errors_m").size(); ++i) {
        lines.back().emplace_back(walk_.at("waypoints").at(i).at(0).get<double>(),
                                  entry.at("errors_m").at(i).get<double>());
      }
    }
    TimeFigure("errors", "Error at the waypoints", "m", names, lines);
  }

  void Explain(const std::string& method, const Json& entry) {
    if (entry.at("status").is_string()) {
      Note(method + ": status " + entry.at("status").get<std::string>());
    }
    const std::string path = dir_ + "/explain/" + id_ + "." + method + ".json";
    std::ifstream in(path, std::ios::binary);
    if (!in) return;  // not a graph: it has no factors to tell of
    const Json json = Json::parse(in, nullptr, false);
    if (json.is_discarded()) throw InputError(path, 0, "not JSON", "a result file");
    FactorNotes(method, json);
    HypothesisNotes(method, json.at("hypotheses"));
    SilenceNotes(json.at("readings_ns"));
    RejectedFigure(method, json.at("residuals"));
  }

  void FactorNotes(const std::string& method, const Json& json) {
    for (const Json& factor : json.at("factors")) {
      std::string text = method + ": " + factor.at("factor").get<std::string>() + ", " +
                         std::to_string(factor.at("count").get<int>()) +
                         " measurements, mean squared whitened residual " +
                         FixedDecimals(factor.at("mean_squared_whitened").get<double>(), 2) +
                         " (1 where the noise is as modelled)";
      const int rejected = factor.at("downweighted").get<int>();
      if (rejected > 0) text += ", " + std::to_string(rejected) + " down-weighted to under a half";
      Note(text);
    }
  }

  void HypothesisNotes(const std::string& method, const Json& hypotheses) {
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
      const Json& h = hypotheses[i];
      const Json& nats = h.at("negative_log_posterior");
      if (nats.is_null() || hypotheses[0].at("negative_log_posterior").is_null()) continue;
      const double worse =
          nats.get<double>() - hypotheses[0].at("negative_log_posterior").get<double>();
      const std::string source = h.at("source").get<std::string>();
      std::string text = method;
      text.append(": hypothesis from ").append(source);
      if (i == 0) {
        text.append(", the answer");
      } else {
        text.append(", ").append(FixedDecimals(worse, 1)).append(" nats worse, ");
        text.append(h.at("kept").get<bool>() ? "kept in the covariance" : "dropped");
      }
      Note(text);
    }
  }

  // The same for every method of the walk: told once.
  void SilenceNotes(const Json& readings_ns) {
    if (silence_told_) return;
    silence_told_ = true;
    double last = low_s_;
    const auto gap = [&](double from, double until) {
      if (until - from < kLongSilenceS) return;
      Note("nothing heard from " + FixedDecimals(from, 0) + " s to " + FixedDecimals(until, 0) +
           " s: no position known there but by dead reckoning");
    };
    for (const Json& time : readings_ns) {
      const double now = Seconds(time);
      gap(last, now);
      last = std::max(last, now);
    }
    gap(last, high_s_);
  }

  // What the robust loss set aside of each scan. Residuals and slow states stand below the plan.
  void RejectedFigure(const std::string& method, const Json& residuals) {
    const auto scans = residuals.find("fingerprint");
    if (scans == residuals.end()) return;
    Points rejected;
    for (const Json& row : *scans) {
      rejected.emplace_back(std::clamp(Seconds(row.at(0)), low_s_, high_s_),
                            row.at(3).get<double>() / row.at(2).get<double>());
    }
    std::stable_sort(rejected.begin(), rejected.end(),
                     [](const auto& a, const auto& b) { return a.x() < b.x(); });
    TimeFigure(method + "_rejected", method + ": share of a scan's readings down-weighted", "share",
               {}, {rejected});
  }

  const std::string dir_;
  const Json& walk_;
  const std::string id_;
  const std::int64_t begin_ns_;
  double low_s_ = NAN, high_s_ = NAN;
  bool silence_told_ = false;
  Explanation result_;
};

}  // namespace

Explanation ExplainWalk(const std::string& dir, const Json& walk) {
  try {
    return WalkExplainer(dir, walk).Run();
  } catch (const Json::exception& error) {
    throw InputError(dir, 0, error.what(), "result files of this version");
  }
}

}  // namespace walkgraph
