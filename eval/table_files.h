#ifndef WALKGRAPH_EVAL_TABLE_FILES_H_
#define WALKGRAPH_EVAL_TABLE_FILES_H_

#include <string>

#include "eval/table.h"

namespace walkgraph {

// Tables that follow each other, as CSV, Markdown and LaTeX.
class TableFiles {
 public:
  // The text formats take `table`, CSV takes `precise`, the same with more decimals.
  void Add(const Table& table, const Table& precise);
  bool empty() const { return csv_.empty(); }
  // Writes stem.csv, stem.md and stem.tex; unfinished files go to the folder `scratch`.
  void Write(const std::string& stem, const std::string& scratch) const;

 private:
  std::string csv_, markdown_, latex_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_TABLE_FILES_H_
