#include "watch/TrackReader.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "field/TeamSize.h"
#include "framework/FileLines.h"
#include "framework/StopSignal.h"

namespace plumbline::watch {
namespace {

constexpr std::size_t columns = 7;
constexpr std::size_t longestLine = 200, mostMoments = 1000000;
constexpr double farthest = 1000;  ///< [m]

/// The columns of one line.
class Line {
public:
  Line(const std::string& file, int number, std::string_view text) : file_(file), number_(number) {
    if (text.size() > longestLine) fail("longer than 200 bytes");
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t end = text.find(',');
      if ((end == std::string_view::npos) != (i + 1 == columns)) fail("must have 7 columns");
      cells_[i] = text.substr(0, end);
      if (i + 1 < columns) text.remove_prefix(end + 1);
    }
  }
  std::string_view operator[](std::size_t i) const { return cells_[i]; }
  double number(std::size_t i, double most) const {
    double value = 0;
    const char* last = cells_[i].data() + cells_[i].size();
    const auto [end, error] = std::from_chars(cells_[i].data(), last, value);
    if (error != std::errc() || end != last || !(std::abs(value) <= most))
      fail(fmt::format("'{}' is no number within {:g}", cells_[i], most));
    return value;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", file_, number_, what));
  }

private:
  const std::string& file_;
  int number_;
  std::array<std::string_view, columns> cells_{};
};

}  // namespace

std::vector<TrackMoment> readTrack(const std::string& file) {
  FileLines lines(file);
  std::vector<TrackMoment> moments;
  std::string text;
  for (int number = 1; lines.next(text); ++number) {
    StopSignal::throwIfCaught();
    const Line line(file, number, text);
    if (number == 1) {
      if (text != "time,side,number,x,y,up,mode") line.fail("is no track of a game: its first line differs");
      continue;
    }
    const double time = line.number(0, 1e7);
    const Vec2 place(line.number(3, farthest), line.number(4, farthest));
    if (line[1] == "ball") {
      if (moments.size() == mostMoments) line.fail("has more than a million moments");
      if (!moments.empty() && time <= moments.back().time) line.fail("the time does not rise");
      moments.push_back({time, std::string(line[6]), place});
      continue;
    }
    if (line[1] != "left" && line[1] != "right") line.fail("the side must be ball, left or right");
    if (moments.empty()) line.fail("a player before the first ball");
    moments.back().players.push_back(
        {line[1] == "left", static_cast<int>(line.number(2, teamSize)), place, line.number(5, 1.1) > 0.5});
  }
  return moments;
}

}  // namespace plumbline::watch
