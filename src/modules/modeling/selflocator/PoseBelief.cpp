#include "modules/modeling/selflocator/PoseBelief.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

constexpr double gateDeviations = 4;    ///< a line farther from a segment is not that segment
constexpr double lineTolerance = 0.02;  ///< added to the gate [m]
/// By so much must the second-best segment fit worse [squared deviations].
constexpr double ambiguity = 9;

Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

/// A segment of the map in the robot's frame.
struct LocalSegment {
  Vec2 start, direction, normal;
  double length;
};

/// What is known of one end of a seen line before it is matched.
struct SeenEnd {
  const GroundPoint& point;
  bool isEnd;
  double variance;  ///< of its position, the belief's own included [m^2]
  double gate;      ///< [m]
};

SeenEnd makeEnd(const GroundPoint& point, bool isEnd, const Mat3& covariance) {
  const double variance = point.covariance.trace() + covariance(0, 0) + covariance(1, 1) +
                          covariance(2, 2) * point.position.squaredNorm();
  return {point, isEnd, variance, gateDeviations * std::sqrt(variance) + lineTolerance};
}

struct Match {
  const LocalSegment* segment = nullptr;
  double endA = 0, endB = 0;  ///< where the ends lie along the segment, if they are ends
  double cost = 1e9;
};

/// Fits a seen line to a segment; false if it cannot be it. Nearly all segments are too far aside of the
/// first end, so that is asked first.
bool matchSegment(const LocalSegment& segment, const SeenEnd& a, const SeenEnd& b, Match& match) {
  const Vec2 fromStartA = a.point.position - segment.start;
  const double sideA = segment.normal.dot(fromStartA);
  if (std::abs(sideA) > a.gate) return false;
  const Vec2 fromStartB = b.point.position - segment.start;
  const double sideB = segment.normal.dot(fromStartB);
  if (std::abs(sideB) > b.gate) return false;
  const double alongA = segment.direction.dot(fromStartA), alongB = segment.direction.dot(fromStartB);
  match.segment = &segment;
  match.endA = alongA < alongB ? 0 : segment.length;
  match.endB = segment.length - match.endA;
  match.cost = sideA * sideA / a.variance + sideB * sideB / b.variance;
  const auto fitsAlong = [&](const SeenEnd& end, double along, double expected) {
    if (!end.isEnd) return along > -end.gate && along < segment.length + end.gate;
    const double off = along - expected;
    match.cost += off * off / end.variance;
    return std::abs(off) < end.gate;
  };
  return fitsAlong(a, alongA, match.endA) && fitsAlong(b, alongB, match.endB);
}

}  // namespace

PoseStep::PoseStep(const Pose2& step, const Vec3& noise) : step_(step), variance_(noise.cwiseAbs2()) {
  const Mat2 back = step.rotation().transpose();
  transition_.topLeftCorner<2, 2>() = back;
  transition_.topRightCorner<2, 1>() = back * perpendicular(step.position);
}

void PoseStep::apply(PoseBelief& belief) const {
  belief.covariance = transition_ * belief.covariance * transition_.transpose();
  belief.covariance.diagonal() += variance_;
  belief.pose = belief.pose * step_;
}

/// Normal equations of the step (forward, left, turn) in the robot's frame.
struct PoseUpdate::Normal {
  Mat3 matrix = Mat3::Zero();
  Vec3 vector = Vec3::Zero();
  double error = 0;
  int count = 0;

  /// residual = where it should be - where it is seen, robot's frame.
  void addPoint(const Vec2& residual, const GroundPoint& seen) {
    const Vec2 turn = perpendicular(seen.position);
    const Vec2 weighted = seen.information * residual, weightedTurn = seen.information * turn;
    matrix.topLeftCorner<2, 2>() += seen.information;
    matrix.topRightCorner<2, 1>() += weightedTurn;
    matrix(2, 2) += turn.dot(weightedTurn);
    vector.head<2>() += weighted;
    vector.z() += turn.dot(weighted);
    error += residual.dot(weighted);
    count += 2;
  }
  void addOffset(double residual, const Vec2& normal, const GroundPoint& seen) {
    const double weight = 1 / normal.dot(seen.covariance * normal);
    const Vec3 j(normal.x(), normal.y(), normal.dot(perpendicular(seen.position)));
    matrix.triangularView<Eigen::Upper>() += weight * j * j.transpose();
    vector += weight * residual * j;
    error += weight * residual * residual;
    ++count;
  }
};

void PoseUpdate::addLandmarks(const Pose2& pose, const Mat2& back, Normal& sum) const {
  for (const SeenLandmark& seen : view_.landmarks)
    sum.addPoint(back * (map_.landmark(seen.index) - pose.position) - seen.point.position, seen.point);
}

void PoseUpdate::addLines(const PoseBelief& belief, const Mat2& back, Normal& sum, Fit& fit) const {
  std::array<LocalSegment, FieldMap::numSegments> local;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const FieldSegment& segment = map_.segments()[i];
    local[i] = {back * (segment.start - belief.pose.position), back * segment.direction,
                back * segment.normal, segment.length};
  }
  for (const SeenFieldLine& line : view_.lines) {
    const SeenEnd a = makeEnd(line.a, line.aIsEnd, belief.covariance);
    const SeenEnd b = makeEnd(line.b, line.bIsEnd, belief.covariance);
    Match best;
    double second = 1e9;
    for (const LocalSegment& segment : local) {
      Match match;
      if (!matchSegment(segment, a, b, match)) continue;
      if (match.cost < best.cost) {
        second = best.cost;
        best = match;
      } else {
        second = std::min(second, match.cost);
      }
    }
    if (!best.segment || second < best.cost + ambiguity) continue;
    ++fit.matchedLines;
    const auto add = [&](const SeenEnd& end, double along) {
      const Vec2 toLine = best.segment->start + along * best.segment->direction - end.point.position;
      if (end.isEnd)
        sum.addPoint(toLine, end.point);
      else
        sum.addOffset(best.segment->normal.dot(toLine), best.segment->normal, end.point);
    };
    add(a, best.endA);
    add(b, best.endB);
  }
}

Fit PoseUpdate::apply(PoseBelief& belief) const {
  Fit fit;
  Mat2 rotation = belief.pose.rotation();
  const auto step = [&](const Normal& sum) {
    const Mat3 measured = sum.matrix.selfadjointView<Eigen::Upper>();
    const Mat3 information = belief.covariance.inverse() + measured;
    const Mat3 covariance = information.inverse();
    belief.covariance = 0.5 * (covariance + covariance.transpose());
    const Vec3 move = belief.covariance * sum.vector;
    // What remains of the squared errors after the step: the joint Mahalanobis distance.
    fit.error += std::max(0.0, sum.error - sum.vector.dot(move));
    fit.measurements += sum.count;
    belief.pose = Pose2(Vec2(belief.pose.position + rotation * Vec2(move.x(), move.y())),
                        normalizeAngle(belief.pose.heading + move.z()));
  };
  // Landmarks first: they cannot be mistaken, and narrow the search for the lines.
  if (!view_.landmarks.empty()) {
    Normal sum;
    addLandmarks(belief.pose, rotation.transpose(), sum);
    step(sum);
  }
  if (view_.lines.empty()) return fit;
  if (!view_.landmarks.empty()) rotation = belief.pose.rotation();
  Normal sum;
  addLines(belief, rotation.transpose(), sum, fit);
  if (sum.count > 0) step(sum);
  return fit;
}

}  // namespace plumbline
