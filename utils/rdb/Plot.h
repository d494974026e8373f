#pragma once
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace plumbline::rdb {

/// The last values of a few series under one name.
class Plot {
public:
  static constexpr std::size_t standardCount = 200, maxCount = 100000;
  static constexpr double standardInterval = 0.1, minInterval = 0.02, maxInterval = 3600;

  explicit Plot(std::size_t count = standardCount) : count_(count) {}
  void add(const std::string& series, double value);
  /// A series that has no values yet.
  void open(const std::string& series) { series_[series]; }
  void setCount(std::size_t count) { count_ = count; }
  /// How often a window draws it anew [s].
  void setInterval(double seconds) { interval_ = seconds; }
  double interval() const { return interval_; }
  /// Every series has as many values as are kept.
  bool full() const;

  /// A line per series: its name, smallest and largest value, and its course in `width` characters of eight
  /// heights; all series have one scale.
  std::vector<std::string> sparklines(std::size_t width, bool unicode) const;
  /// What makes gnuplot draw it.
  std::string script(const std::string& title) const;
  /// Draws it by gnuplot to a file. Throws std::runtime_error if that is not there or fails.
  void writePng(const std::string& path, const std::string& title) const;

private:
  std::size_t count_;
  double interval_ = standardInterval;
  std::map<std::string, std::deque<double>> series_;
};

}  // namespace plumbline::rdb
