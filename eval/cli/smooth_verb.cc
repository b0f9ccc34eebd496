#include <charconv>

#include "common_flags.h"
#include "eval/methods.h"
#include "eval/smooth.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_string(site, "", "site file that `walkgraph survey` made");
DEFINE_string(method, "batch", "method, or several with commas; `walkgraph methods` lists them");
DEFINE_string(use_waypoints, "",
              "every:K tells the method waypoints 0, K, 2K, ... as surveyed tags; the others are "
              "scored");

namespace walkgraph {
namespace {

// K of every:K, 0 where the flag is not given.
int AnchorEvery() {
  constexpr std::string_view kPrefix = "every:";
  const std::string& text = FLAGS_use_waypoints;
  if (text.empty()) return 0;
  int every = 0;
  const char* end = text.data() + text.size();
  if (text.compare(0, kPrefix.size(), kPrefix) != 0 ||
      std::from_chars(text.data() + kPrefix.size(), end, every).ptr != end || every < 1) {
    throw UsageError("--use_waypoints=" + text + ": expected every:K with K of at least 1");
  }
  return every;
}

int RunSmooth(const CommandLine& line) {
  RequireFlag("site", FLAGS_site);
  RequireFlag("out", FLAGS_out);
  if (line.arguments.empty()) throw UsageError("smooth: expected at least one RECORDING");
  const SmoothOptions options = {.site = FLAGS_site,
                                 .out = FLAGS_out,
                                 .recordings = line.arguments,
                                 .methods = ParseMethods(FLAGS_method),
                                 .anchor_every = AnchorEvery(),
                                 .floor_given = FloorGiven(),
                                 .tum = FLAGS_tum,
                                 .workers = Workers(),
                                 .overrides = ReadOverrides(line),
                                 .command_line = line.text,
                                 .stopped = Interrupted};
  HandleInterrupt();
  return SmoothRecordings(options);
}

}  // namespace

Verb SmoothVerb() {
  return {
      "smooth",
      "--site=SITE --out=DIR RECORDING...",
      "estimate recordings on a trained site",
      {"site", "out", "method", "use_waypoints", "floor", "tum", "lag", "workers", "config", "set"},
      RunSmooth};
}

}  // namespace walkgraph
