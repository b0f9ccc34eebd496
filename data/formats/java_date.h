#ifndef WALKGRAPH_DATA_FORMATS_JAVA_DATE_H_
#define WALKGRAPH_DATA_FORMATS_JAVA_DATE_H_

#include <optional>
#include <string_view>

#include "data/time.h"

namespace walkgraph {

// The Unix time of a date as java.util.Date prints it, "Wed Jun 14 10:00:58 GMT+02:00 2023". None
// where it is written in another way. A zone that is no offset from GMT counts as GMT: such dates
// can be compared with one another.
std::optional<TimeNs> ParseJavaDate(std::string_view text);

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_FORMATS_JAVA_DATE_H_
