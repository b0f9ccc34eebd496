#ifndef WALKGRAPH_EVAL_TABLE_H_
#define WALKGRAPH_EVAL_TABLE_H_

#include <string>
#include <vector>

namespace walkgraph {

// A table of text for the terminal: the first column flush left, the others flush right.
class Table {
 public:
  explicit Table(std::vector<std::string> header) { rows_.push_back(std::move(header)); }
  void AddRow(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string Format() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

// `value` with `digits` decimals; "-" for NaN.
std::string FixedDecimals(double value, int digits);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_TABLE_H_
