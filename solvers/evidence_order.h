#ifndef WALKGRAPH_SOLVERS_EVIDENCE_ORDER_H_
#define WALKGRAPH_SOLVERS_EVIDENCE_ORDER_H_

#include "data/time.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Readings and anchors in an order that depends on nothing but themselves: results cannot depend on
// the order of arrival.
Evidence InCanonicalOrder(const Evidence& evidence);

// What was there to be used by a time: readings printed, everything else measured by then.
Evidence EvidenceUntil(const Evidence& evidence, TimeNs time_ns);

// What happened from a time on: steps begun and readings heard since. Streams keep their samples
// from before, which nothing asks for.
Evidence EvidenceSince(const Evidence& evidence, TimeNs time_ns);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_EVIDENCE_ORDER_H_
