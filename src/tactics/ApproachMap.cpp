#include "tactics/ApproachMap.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr double farTime = 60;                  ///< before anything is known [s]
constexpr double settled = 0.005;               ///< change of a pass after which the map is done [s]
constexpr int mostPasses = 60;                  ///< in each of four orders
constexpr std::array stepSeconds{0.1, 0.25};    ///< shorter and longer than a cell
constexpr int corners = 8;

/// Walks whose shares sum up to 1: each direction alone, and mixtures of two or three.
std::vector<Vec3> walksOf(const WalkSpeeds& s) {
  std::vector<Vec3> walks;
  const double half = std::sqrt(0.5);  // sideways and turn share an ellipse
  for (const double share : {1.0, 0.7, 0.35, 0.0}) {
    const double rest = 1 - share;
    for (const double ahead : {s.forward, -s.backward}) {
      if (share > 0 && rest <= 0) walks.emplace_back(ahead, 0, 0);
      if (rest <= 0 || (share <= 0 && ahead < 0)) continue;
      for (const double a : {-1.0, 1.0}) {
        walks.emplace_back(share * ahead, a * rest * s.sideways, 0);
        walks.emplace_back(share * ahead, 0, a * rest * s.turn);
        for (const double b : {-1.0, 1.0})
          walks.emplace_back(share * ahead, a * rest * half * s.sideways, b * rest * half * s.turn);
      }
    }
  }
  return walks;
}

}  // namespace

/// A walk for a short time: where it leads from a node, as neighbours with weights.
struct ApproachMap::Step {
  double seconds = 0;
  std::array<int, 3> low{};  ///< cells along x, y, heading to the lowest neighbour
  Vec3 share = Vec3::Zero();
};

ApproachMap::ApproachMap(const WalkSpeeds& speeds, const Vec2& ball, const ApproachMapParameters& parameters)
    : speeds_(speeds), ball_(ball), parameters_(parameters) {
  side_ = 2 * parameters.cells + 1;
  cell_ = parameters.reach / parameters.cells;
  turnCell_ = 2 * pi / parameters.headings;
  solve();
}

Pose2 ApproachMap::node(int ix, int iy, int heading) const {
  return {(ix - parameters_.cells) * cell_, (iy - parameters_.cells) * cell_, normalizeAngle(heading * turnCell_)};
}

std::size_t ApproachMap::index(int ix, int iy, int heading) const {
  return static_cast<std::size_t>((heading * side_ + iy) * side_ + ix);
}

bool ApproachMap::touches(const Pose2& pose) const {
  const Vec2 ball = pose.inverse() * ball_;
  return ball.x() < parameters_.front && ball.x() > -parameters_.back && std::abs(ball.y()) < parameters_.side;
}

std::vector<ApproachMap::Step> ApproachMap::stepsFrom(int heading) const {
  std::vector<Step> steps;
  for (const Vec3& walk : walksOf(speeds_))
    for (const double seconds : stepSeconds) {
      const double turn = walk.z() * seconds, middle = heading * turnCell_ + turn / 2;
      const Vec2 way = seconds * (Eigen::Rotation2Dd(middle) * Vec2(walk.head<2>()));
      const Vec3 cells(way.x() / cell_, way.y() / cell_, turn / turnCell_);
      Step step;
      step.seconds = seconds;
      for (int axis = 0; axis < 3; ++axis) {
        step.low[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(cells[axis]));
        step.share[axis] = cells[axis] - std::floor(cells[axis]);
      }
      steps.push_back(step);
    }
  return steps;
}

void ApproachMap::solve() {
  const int headings = parameters_.headings;
  seconds_.assign(static_cast<std::size_t>(side_ * side_ * headings), static_cast<float>(farTime));
  const std::size_t goal = index(parameters_.cells, parameters_.cells, 0);
  seconds_[goal] = 0;
  std::vector<std::vector<Step>> steps;
  for (int h = 0; h < headings; ++h) steps.push_back(stepsFrom(h));
  std::vector<float> price(seconds_.size());
  for (int h = 0; h < headings; ++h)
    for (int iy = 0; iy < side_; ++iy)
      for (int ix = 0; ix < side_; ++ix)
        price[index(ix, iy, h)] = static_cast<float>(this->price(node(ix, iy, h)));

  const auto best = [&](int ix, int iy, int h) {
    double least = farTime;
    for (const Step& step : steps[static_cast<std::size_t>(h)]) {
      double time = step.seconds * price[index(ix, iy, h)];
      for (int corner = 0; corner < corners && time < least; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dh = corner >> 2;
        const double weight = (dx ? step.share.x() : 1 - step.share.x()) *
                              (dy ? step.share.y() : 1 - step.share.y()) *
                              (dh ? step.share.z() : 1 - step.share.z());
        if (weight <= 0) continue;
        const int x = std::clamp(ix + step.low[0] + dx, 0, side_ - 1);
        const int y = std::clamp(iy + step.low[1] + dy, 0, side_ - 1);
        const int turned = (h + step.low[2] + dh + headings) % headings;
        time += weight * seconds_[index(x, y, turned)];
      }
      least = std::min(least, time);
    }
    return least;
  };
  // Gauss and Seidel's way, from all four corners in turn: each carries the news over the whole map.
  for (int pass = 0; pass < 4 * mostPasses; ++pass) {
    float change = 0;
    for (int a = 0; a < side_; ++a)
      for (int b = 0; b < side_; ++b)
        for (int h = 0; h < headings; ++h) {
          const int ix = pass & 1 ? side_ - 1 - b : b, iy = pass & 2 ? side_ - 1 - a : a;
          const std::size_t here = index(ix, iy, h);
          if (here == goal) continue;
          const auto now = static_cast<float>(best(ix, iy, h));
          if (now >= seconds_[here]) continue;
          change = std::max(change, seconds_[here] - now);
          seconds_[here] = now;
        }
    if (pass >= 3 && change < settled) break;
  }
}

double ApproachMap::inside(const Pose2& pose) const {
  const double most = side_ - 1;
  const double x = std::clamp(pose.x() / cell_ + parameters_.cells, 0.0, most);
  const double y = std::clamp(pose.y() / cell_ + parameters_.cells, 0.0, most);
  double h = normalizeAngle(pose.heading) / turnCell_;
  if (h < 0) h += parameters_.headings;
  const int ix = std::min(static_cast<int>(x), side_ - 2), iy = std::min(static_cast<int>(y), side_ - 2);
  const int ih = std::min(static_cast<int>(h), parameters_.headings - 1), next = (ih + 1) % parameters_.headings;
  const double fx = x - ix, fy = y - iy, fh = h - ih;
  const auto layer = [&](int heading) {
    const auto at = [&](int dx, int dy) { return static_cast<double>(seconds_[index(ix + dx, iy + dy, heading)]); };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), fx), std::lerp(at(0, 1), at(1, 1), fx), fy);
  };
  return std::lerp(layer(ih), layer(next), fh);
}

double ApproachMap::seconds(const Pose2& pose) const {
  if (covers(pose.position)) return inside(pose);
  // Turned to the place, straight to the border, and on.
  const double share = parameters_.reach / pose.position.cwiseAbs().maxCoeff();
  const Vec2 border = share * pose.position, way = border - pose.position;
  const double course = std::atan2(way.y(), way.x());
  return std::abs(normalizeAngle(course - pose.heading)) / speeds_.turn + way.norm() / parameters_.farSpeed +
         inside(Pose2(border, course));
}

}  // namespace plumbline
