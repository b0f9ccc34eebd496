#include "eval/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace walkgraph {
namespace {

std::string Escaped(const std::string& text, const std::string& special,
                    const std::string& escape) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) escaped += escape;
    escaped += c;
  }
  return escaped;
}

std::string QuotedField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  quoted.append(Escaped(text, "\"", "\"")).append("\"");
  return quoted;
}

}  // namespace

std::string Table::Format() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      line += i == 0 ? row[i] + padding : "  " + padding + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string Table::FormatCsv() const {
  std::string text;
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text.append(i == 0 ? "" : ",").append(QuotedField(row[i]));
    }
    text += "\n";
  }
  return text;
}

std::string Table::FormatMarkdown() const {
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    text += "|";
    for (const std::string& field : rows_[r]) {
      text.append(" ").append(Escaped(field, "|", "\\")).append(" |");
    }
    text += "\n";
    if (r > 0) continue;
    for (std::size_t i = 0; i < rows_[r].size(); ++i) text += i == 0 ? "|---|" : "---:|";
    text += "\n";
  }
  return text;
}

std::string Table::FormatLatex() const {
  std::string text = "\\begin{tabular}{l";
  text.append(rows_.front().size() - 1, 'r').append("}\n\\toprule\n");
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t i = 0; i < rows_[r].size(); ++i) {
      text.append(i == 0 ? "" : " & ").append(Escaped(rows_[r][i], "&%$#_{}", "\\"));
    }
    text += r == 0 ? " \\\\\n\\midrule\n" : " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string FixedDecimals(double value, int digits) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
  return buffer.data();
}

}  // namespace walkgraph
