#ifndef WALKGRAPH_FRONTENDS_BUILD_EVIDENCE_H_
#define WALKGRAPH_FRONTENDS_BUILD_EVIDENCE_H_

#include "data/recording.h"
#include "frontends/evidence/evidence.h"
#include "frontends/settings.h"

namespace walkgraph {

// All that the sensors say about a walk. What a missing sensor would have said is empty; anchors
// and floor are for the caller to add. Time linear in the samples (radio rows are sorted).
Evidence BuildEvidence(const Recording& recording, const FrontendSettings& settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_BUILD_EVIDENCE_H_
