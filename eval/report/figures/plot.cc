#include "eval/report/figures/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "eval/table.h"

namespace walkgraph {
namespace {

constexpr int kTop = 50, kBottom = 44, kRight = 24, kLegendRow = 16, kTickLength = 4;
constexpr double kMarkerRadius = 4;

std::string Px(double value) { return FixedDecimals(value, 1); }

// 12 and 0.25, not 12.0000 and 0.2500.
std::string TickText(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

double Fraction(const Axis& axis, double value) {
  if (axis.logarithmic) {
    return std::log(value / axis.low) / std::log(axis.high / axis.low);
  }
  return (value - axis.low) / (axis.high - axis.low);
}

std::string Attribute(const char* name, const std::string& value) {
  std::string text = " ";
  return text.append(name).append("=\"").append(value).append("\"");
}

}  // namespace

std::vector<double> AxisTicks(const Axis& axis, int count) {
  std::vector<double> ticks;
  if (axis.logarithmic) {
    const auto first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
    for (int e = first; std::pow(10.0, e) <= axis.high * (1 + 1e-9); ++e) {
      ticks.push_back(std::pow(10.0, e));
    }
    return ticks;
  }
  const double rough = (axis.high - axis.low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  const double step = power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
  const double first = std::ceil(axis.low / step - 1e-9);
  for (double i = first; i * step <= axis.high + 1e-9 * step; ++i) {
    ticks.push_back(i == 0 ? 0.0 : i * step);
  }
  return ticks;
}

SeriesStyle StyleOf(std::size_t series) {
  // Without black and yellow, which vanish on a dark and on a white page.
  constexpr std::array<const char*, 6> kColours = {"#0072B2", "#D55E00", "#009E73",
                                                   "#CC79A7", "#E69F00", "#56B4E9"};
  constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 2", "8 2 2 2"};
  return {kColours[series % kColours.size()], kDashes[series / kColours.size() % kDashes.size()],
          static_cast<int>(series % 4)};
}

std::string EscapeXml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

Plot::Plot(std::string title, int width, int height, int left)
    : title_(std::move(title)), width_(width), height_(height), left_(left) {}

Eigen::Vector2d Plot::Pixel(const Eigen::Vector2d& value) const {
  return {left_ + width_ * Fraction(x_, value.x()),
          kTop + height_ * (1.0 - Fraction(y_, value.y()))};
}

void Plot::Text(double x, double y, const char* anchor, const std::string& text) {
  body_.append("<text").append(Attribute("x", Px(x))).append(Attribute("y", Px(y)));
  body_.append(Attribute("text-anchor", anchor)).append(">").append(EscapeXml(text));
  body_.append("</text>\n");
}

void Plot::DrawXAxis() {
  for (const double tick : AxisTicks(x_, 6)) {
    const double x = left_ + width_ * Fraction(x_, tick);
    body_.append("<path class=\"grid\" d=\"M").append(Px(x)).append(" ").append(Px(kTop));
    body_.append("V").append(Px(kTop + height_ + kTickLength)).append("\"/>\n");
    Text(x, kTop + height_ + 16, "middle", TickText(tick));
  }
  Text(left_ + width_ / 2.0, kTop + height_ + 34, "middle", x_.label);
}

void Plot::DrawAxes(const Axis& x, const Axis& y) {
  x_ = x;
  y_ = y;
  DrawXAxis();
  for (const double tick : AxisTicks(y_, 5)) {
    const double at = kTop + height_ * (1.0 - Fraction(y_, tick));
    body_.append("<path class=\"grid\" d=\"M").append(Px(left_ - kTickLength)).append(" ");
    body_.append(Px(at)).append("H").append(Px(left_ + width_)).append("\"/>\n");
    Text(left_ - 7, at + 4, "end", TickText(tick));
  }
  Heading(y_.label);
}

void Plot::Heading(const std::string& text) { Text(6, kTop - 8, "start", text); }

void Plot::DrawRows(const Axis& x, const std::vector<std::string>& rows) {
  x_ = x;
  y_ = {"", static_cast<double>(rows.size()) - 0.5, -0.5, false};
  DrawXAxis();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double at =
        kTop + height_ * (static_cast<double>(i) + 0.5) / static_cast<double>(rows.size());
    Text(left_ - 7, at + 4, "end", rows[i]);
  }
}

void Plot::Line(const std::vector<Eigen::Vector2d>& points, const SeriesStyle& style) {
  if (points.empty()) return;
  body_.append("<path fill=\"none\" stroke-width=\"1.8\"")
      .append(Attribute("stroke", style.colour));
  if (!style.dashes.empty()) body_.append(Attribute("stroke-dasharray", style.dashes));
  body_.append(" d=\"");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d at = Pixel(points[i]);
    body_.append(i == 0 ? "M" : "L").append(Px(at.x())).append(" ").append(Px(at.y()));
  }
  body_.append("\"/>\n");
}

void Plot::Segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& colour,
                   double width) {
  const Eigen::Vector2d from = Pixel(a), to = Pixel(b);
  body_.append("<path").append(Attribute("stroke", colour));
  body_.append(Attribute("stroke-width", TickText(width))).append(" d=\"M").append(Px(from.x()));
  body_.append(" ").append(Px(from.y())).append("L").append(Px(to.x())).append(" ");
  body_.append(Px(to.y())).append("\"/>\n");
}

void Plot::Box(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const std::string& colour) {
  const Eigen::Vector2d a = Pixel(low), b = Pixel(high);
  body_.append("<rect fill-opacity=\"0.35\"").append(Attribute("fill", colour));
  body_.append(Attribute("stroke", colour)).append(Attribute("x", Px(std::min(a.x(), b.x()))));
  body_.append(Attribute("y", Px(std::min(a.y(), b.y()))));
  body_.append(Attribute("width", Px(std::abs(a.x() - b.x()))));
  body_.append(Attribute("height", Px(std::abs(a.y() - b.y())))).append("/>\n");
}

void Plot::Marker(const Eigen::Vector2d& at, const SeriesStyle& style) {
  // Circle, square, triangle, diamond.
  constexpr std::array<const char*, 4> kShapes = {"m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0",
                                                  "m-3.5 -3.5h7v7h-7z", "m0 -4.5l4.5 8h-9z",
                                                  "m0 -5l5 5l-5 5l-5 -5z"};
  const Eigen::Vector2d p = Pixel(at);
  body_.append("<path").append(Attribute("fill", style.colour)).append(" d=\"M").append(Px(p.x()));
  body_.append(" ").append(Px(p.y())).append(kShapes[static_cast<std::size_t>(style.marker)]);
  body_.append("\"/>\n");
}

void Plot::Label(const Eigen::Vector2d& at, const std::string& text) {
  const Eigen::Vector2d p = Pixel(at);
  // Where the text would leave the figure it stands on the other side.
  const bool right = p.x() > left_ + 0.8 * width_;
  Text(p.x() + (right ? -1 : 1) * (kMarkerRadius + 4), p.y() + 4, right ? "end" : "start", text);
}

void Plot::Legend(const std::vector<std::string>& names) {
  constexpr double kCharacter = 6.4, kSample = 30;
  double x = left_;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double need = kSample + kCharacter * static_cast<double>(names[i].size()) + 14;
    if (legend_rows_ == 0 || x + need > left_ + width_ + kRight) {
      ++legend_rows_;
      x = 8;
    }
    const double y = kTop + height_ + kBottom + kLegendRow * (legend_rows_ - 0.5);
    const SeriesStyle style = StyleOf(i);
    body_.append("<path stroke-width=\"2.5\"").append(Attribute("stroke", style.colour));
    if (!style.dashes.empty()) body_.append(Attribute("stroke-dasharray", style.dashes));
    body_.append(" d=\"M").append(Px(x)).append(" ").append(Px(y)).append("h24\"/>\n");
    Text(x + kSample, y + 4, "start", names[i]);
    x += need;
  }
}

std::string Plot::Svg() const {
  const int width = left_ + width_ + kRight;
  const int height = kTop + height_ + kBottom + kLegendRow * legend_rows_;
  const std::string w = std::to_string(width), h = std::to_string(height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"";
  svg.append(Attribute("width", w)).append(Attribute("height", h));
  svg.append(Attribute("viewBox", "0 0 " + w + " " + h));
  if (time_) {
    // Begin and end of the axis in its unit, then the area in pixels.
    svg.append(Attribute("data-time", TickText(x_.low) + " " + TickText(x_.high) + " " + Px(left_) +
                                          " " + Px(width_) + " " + Px(kTop) + " " + Px(height_)));
  }
  svg.append(" font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\">\n");
  svg.append("<title>").append(EscapeXml(title_)).append("</title>\n");
  svg.append("<style>.grid{stroke:currentColor;stroke-opacity:.18;fill:none}</style>\n");
  svg.append("<text x=\"6\" y=\"15\" font-weight=\"bold\">").append(EscapeXml(title_));
  return svg.append("</text>\n").append(body_).append("</svg>\n");
}

}  // namespace walkgraph
