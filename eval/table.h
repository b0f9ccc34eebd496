#ifndef WALKGRAPH_EVAL_TABLE_H_
#define WALKGRAPH_EVAL_TABLE_H_

#include <string>
#include <vector>

namespace walkgraph {

// A table of text; the first row is its header.
class Table {
 public:
  explicit Table(std::vector<std::string> header) { rows_.push_back(std::move(header)); }
  void AddRow(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  // For the terminal: the first column flush left, the others flush right.
  std::string Format() const;
  std::string FormatCsv() const;       // RFC 4180, with line feeds
  std::string FormatMarkdown() const;  // a pipe table
  std::string FormatLatex() const;     // a tabular with the rules of the package booktabs

 private:
  std::vector<std::vector<std::string>> rows_;
};

// `value` with `digits` decimals; "-" for NaN.
std::string FixedDecimals(double value, int digits);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_TABLE_H_
