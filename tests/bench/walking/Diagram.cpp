#include "bench/walking/Diagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::bench {
namespace {

constexpr double width = 560, height = 340, left = 64, right = 12, top = 30, bottom = 46;
constexpr const char* colours[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd",
                                   "#ff7f0e", "#17becf", "#7f7f7f"};

struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void hold(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen() {
    if (!(low < high)) {
      low = std::isfinite(low) ? low - 0.5 : 0;
      high = low + 1;
    }
    const double margin = 0.04 * (high - low);
    low -= margin;
    high += margin;
  }
  double tick() const {
    const double raw = (high - low) / 6, ten = std::pow(10, std::floor(std::log10(raw)));
    for (const double step : {1.0, 2.0, 5.0})
      if (raw <= step * ten) return step * ten;
    return 10 * ten;
  }
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

}  // namespace

std::string Plot::svg() const {
  Axis x, y;
  for (const Series& s : series)
    for (const Vec2& p : s.points) {
      x.hold(p.x());
      y.hold(p.y());
    }
  x.widen();
  y.widen();
  const double w = width - left - right, h = height - top - bottom;
  if (equalScales) {
    const double unit = std::max((x.high - x.low) / w, (y.high - y.low) / h);
    const double cx = (x.low + x.high) / 2, cy = (y.low + y.high) / 2;
    x = {cx - unit * w / 2, cx + unit * w / 2};
    y = {cy - unit * h / 2, cy + unit * h / 2};
  }
  const auto px = [&](double v) { return left + w * (v - x.low) / (x.high - x.low); };
  const auto py = [&](double v) { return top + h * (y.high - v) / (y.high - y.low); };
  std::string out = fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" font-family=\"sans-serif\" "
      "font-size=\"11\">\n"
      "<text x=\"{2}\" y=\"16\" font-size=\"13\">{3}</text>\n",
      width, height, left, escaped(title));
  const double dx = x.tick(), dy = y.tick();
  for (double v = std::ceil(x.low / dx) * dx; v <= x.high; v += dx)
    out += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4:.4g}</text>\n",
        px(v), top, height - bottom, height - bottom + 14, std::abs(v) < dx / 1e6 ? 0 : v);
  for (double v = std::ceil(y.low / dy) * dy; v <= y.high; v += dy)
    out += fmt::format(
        "<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:.4g}</text>\n",
        left, py(v), width - right, left - 5, py(v) + 4, std::abs(v) < dy / 1e6 ? 0 : v);
  out += fmt::format("<text x=\"{:.0f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", left + w / 2,
                     height - 14, escaped(xLabel));
  out +=
      fmt::format("<text transform=\"translate(14 {:.0f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                  top + h / 2, escaped(yLabel));
  double legend = left + 8;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& s = series[i];
    const char* colour = colours[i % std::size(colours)];
    if (s.style == Series::Style::points) {
      for (const Vec2& p : s.points)
        out +=
            fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\" fill-opacity=\".7\"/>\n",
                        px(p.x()), py(p.y()), colour);
    } else {
      std::string path;
      bool pen = false;
      for (const Vec2& p : s.points) {
        if (!p.allFinite()) {
          pen = false;  // a gap
          continue;
        }
        path += fmt::format("{}{:.1f} {:.1f}", pen ? "L" : "M", px(p.x()), py(p.y()));
        pen = true;
      }
      out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"{}/>\n", path,
                         colour, s.style == Series::Style::dashed ? " stroke-dasharray=\"5 3\"" : "");
    }
    out += fmt::format("<text x=\"{:.0f}\" y=\"{}\" fill=\"{}\">{}</text>\n", legend, height - 2, colour,
                       escaped(s.name));
    legend += 7.0 * static_cast<double>(s.name.size()) + 16;
  }
  return out + "</svg>\n";
}

std::string Page::html() const {
  std::string out = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title><style>body{{font-family:"
      "sans-serif;max-width:1180px;margin:2em auto;padding:0 1em}}figure{{margin:0 0 "
      "2.5em}}svg{{max-width:100%;"
      "height:auto}}</style><h1>{0}</h1><p>{1}</p>\n",
      escaped(title), escaped(introduction));
  for (const Figure& figure : figures) {
    out += "<figure>\n";
    for (const Plot& plot : figure.plots) out += plot.svg();
    out += fmt::format("<figcaption>{}</figcaption></figure>\n", escaped(figure.caption));
  }
  return out + "</html>\n";
}

}  // namespace plumbline::bench
