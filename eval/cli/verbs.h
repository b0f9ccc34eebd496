#ifndef WALKGRAPH_EVAL_CLI_VERBS_H_
#define WALKGRAPH_EVAL_CLI_VERBS_H_

#include "command_line.h"

namespace walkgraph {

// One per file; each reads the gflags that it names in its Verb.
Verb InspectVerb();
Verb SurveyVerb();
Verb CalibrateVerb();
Verb SmoothVerb();
Verb EvaluateVerb();
Verb AblateVerb();
Verb HonestyVerb();
Verb ReportVerb();
Verb SimulateVerb();
Verb ConfigVerb();
Verb MethodsVerb();
Verb VersionVerb();

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CLI_VERBS_H_
