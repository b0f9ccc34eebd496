#include "eval/table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace walkgraph {
namespace {

Table Awkward() {
  Table table({"cell", "error, m"});
  table.AddRow({"a_b|c", "say \"2\" & 3%"});
  return table;
}

TEST(Table, CsvQuotesWhatWouldBreakARow) {
  EXPECT_EQ(Awkward().FormatCsv(), "cell,\"error, m\"\na_b|c,\"say \"\"2\"\" & 3%\"\n");
  Table table({"x\ny", "\"a,b\""});
  EXPECT_EQ(table.FormatCsv(), "\"x\ny\",\"\"\"a,b\"\"\"\n");
}

TEST(Table, MarkdownKeepsItsColumns) {
  EXPECT_EQ(Awkward().FormatMarkdown(),
            "| cell | error, m |\n|---|---:|\n| a_b\\|c | say \"2\" & 3% |\n");
}

TEST(Table, LatexEscapesWhatIsCode) {
  const std::string text = Awkward().FormatLatex();
  EXPECT_NE(text.find("\\begin{tabular}{lr}"), std::string::npos);
  EXPECT_NE(text.find("a\\_b|c & say \"2\" \\& 3\\% \\\\\n"), std::string::npos);
}

TEST(FixedDecimals, HasNoNumberForNaN) {
  EXPECT_EQ(FixedDecimals(NAN, 2), "-");
  EXPECT_EQ(FixedDecimals(2.345, 1), "2.3");
}

}  // namespace
}  // namespace walkgraph
