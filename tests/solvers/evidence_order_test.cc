#include "solvers/evidence_order.h"

#include <gtest/gtest.h>

#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

// A walk cut in two has every step and reading once, but for the step under the cut.
TEST(EvidenceOrderTest, SinceAndUntilShareAWalkOut) {
  SyntheticSite synthetic(4);
  const Evidence whole = synthetic.Walk({{6, 6}, {40, 6}}, 0.1, 3.0);
  const TimeNs cut = SyntheticSite::At(15.3);
  const Evidence before = EvidenceUntil(whole, cut), after = EvidenceSince(whole, cut);
  EXPECT_EQ(before.end_ns, cut);
  EXPECT_EQ(after.begin_ns, cut);
  EXPECT_EQ(before.readings.size() + after.readings.size(), whole.readings.size());
  EXPECT_EQ(before.steps.size() + after.steps.size() + 1, whole.steps.size());
  EXPECT_EQ(after.motion.front().begin_ns, cut);
  EXPECT_EQ(after.end_ns, whole.end_ns);
}

}  // namespace
}  // namespace walkgraph
