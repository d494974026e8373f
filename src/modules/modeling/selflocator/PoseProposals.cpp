#include "modules/modeling/selflocator/PoseProposals.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr double shortestLine = 1.0;     ///< a shorter one gives no heading [m]
constexpr double lengthTolerance = 0.5;  ///< [m]
constexpr double outside = 3;            ///< so far may the robot be off the field [m]
/// What a line that fits no segment counts like [squared deviations].
constexpr double missedLine = 20;

/// Before the image is applied: as wide as the first guess may be off.
Mat3 broad() { return Vec3(0.25, 0.25, 0.02).asDiagonal(); }

}  // namespace

const std::vector<PoseBelief>& PoseProposals::find(const FieldView& view) {
  scored_.clear();
  found_.clear();
  if (view.landmarks.size() >= 2) {
    keep(PoseUpdate(map_, view), fromLandmarks(view), view.lines.size());
  } else if (view.landmarks.size() == 1) {
    const SeenFieldLine* longest = nullptr;
    double length = shortestLine;
    for (const SeenFieldLine& line : view.lines) {
      const double l = (line.b.position - line.a.position).norm();
      if (l > length) longest = &line, length = l;
    }
    if (longest) fromLandmarkAndLine(view, *longest);
  }
  std::stable_sort(scored_.begin(), scored_.end(),
                   [](const Scored& a, const Scored& b) { return a.score < b.score; });
  for (const Scored& s : scored_) {
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const PoseBelief& other) {
      return (other.pose.position - s.belief.pose.position).norm() < 0.3 &&
             std::abs(normalizeAngle(other.pose.heading - s.belief.pose.heading)) < 0.2;
    });
    if (!known && found_.size() < maxProposals) found_.push_back(s.belief);
  }
  return found_;
}

/// The rotation that brings the seen landmarks onto the map's, both about their means (Procrustes in the
/// plane); nearer ones count more.
Pose2 PoseProposals::fromLandmarks(const FieldView& view) const {
  Vec2 meanSeen = Vec2::Zero(), meanTrue = Vec2::Zero();
  double sum = 0;
  for (const SeenLandmark& seen : view.landmarks) {
    const double weight = 1 / seen.point.covariance.trace();
    meanSeen += weight * seen.point.position;
    meanTrue += weight * map_.landmark(seen.index);
    sum += weight;
  }
  meanSeen /= sum;
  meanTrue /= sum;
  double dot = 0, cross = 0;
  for (const SeenLandmark& seen : view.landmarks) {
    const double weight = 1 / seen.point.covariance.trace();
    const Vec2 s = seen.point.position - meanSeen, t = map_.landmark(seen.index) - meanTrue;
    dot += weight * s.dot(t);
    cross += weight * (s.x() * t.y() - s.y() * t.x());
  }
  Pose2 pose(0, 0, std::atan2(cross, dot));
  pose.position = meanTrue - pose.rotation() * meanSeen;
  return pose;
}

void PoseProposals::fromLandmarkAndLine(const FieldView& view, const SeenFieldLine& line) {
  const PoseUpdate update(map_, view);
  const SeenLandmark& seen = view.landmarks.front();
  const Vec2 d = line.b.position - line.a.position;
  const double length = d.norm(), direction = std::atan2(d.y(), d.x());
  for (const FieldSegment& segment : map_.segments()) {
    if (length > segment.length + lengthTolerance) continue;
    if (line.aIsEnd && line.bIsEnd && length < segment.length - lengthTolerance) continue;
    for (const double turn : {0.0, pi}) {
      const double heading = std::atan2(segment.direction.y(), segment.direction.x()) + turn - direction;
      Pose2 pose(0, 0, normalizeAngle(heading));
      pose.position = map_.landmark(seen.index) - pose.rotation() * seen.point.position;
      // The line itself must be where the segment is, not only parallel to it.
      const Vec2 middle = pose * Vec2(0.5 * (line.a.position + line.b.position));
      if (std::abs(segment.normal.dot(middle - segment.start)) > 1) continue;
      if (std::abs(pose.x()) > map_.size().length / 2 + outside ||
          std::abs(pose.y()) > map_.size().width / 2 + outside)
        continue;
      keep(update, pose, view.lines.size());
    }
  }
}

void PoseProposals::keep(const PoseUpdate& update, const Pose2& pose, std::size_t numLines) {
  PoseBelief belief{pose, broad()};
  const Fit fit = update.apply(belief);
  scored_.push_back({belief, fit.error + missedLine * (static_cast<double>(numLines) - fit.matchedLines)});
}

}  // namespace plumbline
