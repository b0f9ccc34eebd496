#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "common_flags.h"
#include "eval/honesty/measure_honesty.h"
#include "eval/usage_error.h"
#include "verbs.h"

DECLARE_string(train);
DECLARE_string(test);
DECLARE_string(methods);
DECLARE_int32(seed);
DECLARE_string(duration_s);
DEFINE_int32(walks, 200, "number of walks drawn from the graph's own model");

namespace walkgraph {
namespace {

double DrawnDuration() {
  constexpr double kDefaultS = 180, kShortestS = 60, kLongestS = 3600;
  if (FLAGS_duration_s.empty()) return kDefaultS;
  char* end = nullptr;
  const double seconds = std::strtod(FLAGS_duration_s.c_str(), &end);
  if (*end != '\0' || !(seconds >= kShortestS && seconds <= kLongestS)) {
    throw UsageError("--duration_s=" + FLAGS_duration_s + ": expected 60 to 3600");
  }
  return seconds;
}

int RunHonesty(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("out", FLAGS_out);
  if (FLAGS_train.empty() != FLAGS_test.empty()) {
    throw UsageError("expected both --train=DIR and --test=DIR, or neither");
  }
  if (FLAGS_walks < 2) throw UsageError("--walks: expected at least 2");
  const HonestyOptions options = {
      .train = FLAGS_train,
      .test = FLAGS_test,
      .walks = FLAGS_walks,
      .duration_s = DrawnDuration(),
      .seed = static_cast<std::uint64_t>(FLAGS_seed),
      .out = FLAGS_out,
      .methods = ParseMethods(FLAGS_methods.empty() ? "batch,window" : FLAGS_methods),
      .floor_given = FloorGiven(),
      .workers = Workers(),
      .overrides = ReadOverrides(line),
      .command_line = line.text,
      .stopped = Interrupted};
  HandleInterrupt();
  return MeasureHonesty(options);
}

}  // namespace

Verb HonestyVerb() {
  return {"honesty",
          "--out=DIR [--walks=N] | --train=DIR --test=DIR --out=DIR",
          "measure covariances against errors, on walks drawn from the graph's model or on a "
          "data set's",
          {"out", "walks", "duration_s", "seed", "train", "test", "methods", "floor", "lag",
           "workers", "config", "set"},
          RunHonesty};
}

}  // namespace walkgraph
