#include <cstdio>

#include "common_flags.h"
#include "data/simulator/sample.h"
#include "eval/evaluate.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_int32(seed, 1, "of the random numbers; the same seed gives the same bytes");

namespace walkgraph {
namespace {

int RunSimulate(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("out", FLAGS_out);
  if (FLAGS_seed < 0) throw UsageError("--seed: expected a number that is not negative");
  SimulateSample(FLAGS_out, static_cast<std::uint64_t>(FLAGS_seed));
  std::printf("%s: building.json, survey/ and test/\n", FLAGS_out.c_str());
  return kExitOk;
}

}  // namespace

Verb SimulateVerb() {
  return {"simulate",
          "--out=DIR",
          "make a building and walks with exact truth",
          {"out", "seed"},
          RunSimulate};
}

}  // namespace walkgraph
