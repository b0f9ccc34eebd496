#ifndef WALKGRAPH_EVAL_REPORT_FIGURES_PLOT_H_
#define WALKGRAPH_EVAL_REPORT_FIGURES_PLOT_H_

#include <Eigen/Core>
#include <string>
#include <vector>

namespace walkgraph {

// One axis: what it shows and the values between which it runs.
struct Axis {
  std::string label;
  double low = 0;
  double high = 1;
  bool logarithmic = false;  // low and high positive
};

// Ticks at 1, 2 or 5 times a power of ten (powers of ten on a logarithmic axis), about `count`.
std::vector<double> AxisTicks(const Axis& axis, int count);

// How a series is told from others: one of eight colours that colour-blind readers can tell apart
// (Okabe and Ito 2008, Color universal design) with a dash pattern that changes when they repeat,
// and a marker.
struct SeriesStyle {
  std::string colour;
  std::string dashes;  // an SVG dash array, or empty
  int marker = 0;      // 0 to 3: circle, square, triangle, diamond
};
SeriesStyle StyleOf(std::size_t series);

// Text for SVG and HTML: the five characters that mean something there are replaced.
std::string EscapeXml(const std::string& text);

// A figure under construction, as SVG: axes, and drawing in their coordinates. Lines and text take
// the page's text colour. The same calls give the same bytes.
class Plot {
 public:
  // `width` and `height` of the area between the axes, in pixels; `left` is room for the labels of
  // the y axis.
  Plot(std::string title, int width, int height, int left = 60);

  void DrawAxes(const Axis& x, const Axis& y);
  // Only the x axis; y counts rows from the top, whose names stand on the left.
  void DrawRows(const Axis& x, const std::vector<std::string>& rows);
  // A line between the title and the area.
  void Heading(const std::string& text);

  void Line(const std::vector<Eigen::Vector2d>& points, const SeriesStyle& style);
  void Segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& colour,
               double width);
  void Box(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const std::string& colour);
  void Marker(const Eigen::Vector2d& at, const SeriesStyle& style);
  // Beside the point, in the text's colour.
  void Label(const Eigen::Vector2d& at, const std::string& text);
  void Legend(const std::vector<std::string>& names);

  // The x axis is the walk's time: the page may mark a moment on it.
  void MarkAsTime() { time_ = true; }

  std::string Svg() const;

 private:
  Eigen::Vector2d Pixel(const Eigen::Vector2d& value) const;
  void Text(double x, double y, const char* anchor, const std::string& text);
  void DrawXAxis();

  std::string title_;
  int width_, height_, left_;
  Axis x_, y_;
  int legend_rows_ = 0;
  bool time_ = false;
  std::string body_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_REPORT_FIGURES_PLOT_H_
