#pragma once
#include <string>
#include <vector>

#include "math/Types.h"

namespace plumbline::bench {

/// One drawn row of points.
struct Series {
  enum class Style { line, points, dashed };
  std::string name;
  std::vector<Vec2> points;
  Style style = Style::line;
};

/// A diagram as SVG with axes, ticks and a legend.
struct Plot {
  std::string title, xLabel, yLabel;
  std::vector<Series> series;
  bool equalScales = false;  ///< one unit is as long on both axes

  Series& add(const std::string& name, Series::Style style = Series::Style::line) {
    series.push_back({name, {}, style});
    return series.back();
  }
  std::string svg() const;
};

/// A page of plots, each with a line that says what it shows.
struct Page {
  std::string title, introduction;
  struct Figure {
    std::string caption;
    std::vector<Plot> plots;
  };
  std::vector<Figure> figures;

  std::string html() const;
};

}  // namespace plumbline::bench
