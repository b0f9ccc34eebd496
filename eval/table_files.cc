#include "eval/table_files.h"

#include "eval/files.h"

namespace walkgraph {

void TableFiles::Add(const Table& table, const Table& precise) {
  const char* gap = empty() ? "" : "\n";
  csv_.append(gap).append(precise.FormatCsv());
  markdown_.append(gap).append(table.FormatMarkdown());
  latex_.append(gap).append(table.FormatLatex());
}

void TableFiles::Write(const std::string& stem, const std::string& scratch) const {
  WriteFileWholeVia(scratch, stem + ".csv", csv_);
  WriteFileWholeVia(scratch, stem + ".md", markdown_);
  WriteFileWholeVia(scratch, stem + ".tex", latex_);
}

}  // namespace walkgraph
