#include "simulation/sensors/Vision.h"

#include <array>
#include <cmath>
#include <limits>

#include "math/Angle.h"

namespace plumbline::simulation {

using simspark::Polar;

namespace {

constexpr double halfCone = fromDegrees(60);
constexpr double nearest = 0.1;    ///< [m]
constexpr double nearPlane = 0.1;  ///< [m]
const double imageEdge = std::tan(halfCone);

Polar toPolar(const Vec3& p) {
  return {p.norm(), std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y()))};
}

bool inCone(const Polar& p) { return std::fabs(p.azimuth) <= halfCone && std::fabs(p.elevation) <= halfCone; }

bool isVisible(const Vec3& p) {
  const Polar polar = toPolar(p);
  return polar.distance > nearest && inCone(polar);
}

/// Whether the league's server finds the crossing of a line and the upper or lower edge of its image. It
/// computes the point in single precision and asks whether it lies on the edge to the last bit; a quarter of
/// the lines miss it. A robot that stands still loses such a line for good.
bool hitsEdgeInSinglePrecision(const Vec2& p, const Vec2& q, double edge) {
  constexpr double focalLength = 0.1;
  const auto x1 = static_cast<float>(-p.x() * focalLength), y1 = static_cast<float>(p.y() * focalLength);
  const auto x2 = static_cast<float>(-q.x() * focalLength), y2 = static_cast<float>(q.y() * focalLength);
  const auto y = static_cast<float>(edge * focalLength);
  if (std::fabs(x2 - x1) < std::numeric_limits<float>::epsilon()) return true;  // upright: exact
  const float slope = (y2 - y1) / (x2 - x1), offset = y2 - slope * x2;
  const float x = (y - offset) / slope;
  return slope * x + offset == y;
}

/// Where along the segment from p to q, 0..1, it crosses one edge of the image; negative if it does not. axis
/// 0: left/right, 1: up/down.
double crossing(const Vec2& p, const Vec2& q, int axis, double edge) {
  const double span = q[axis] - p[axis];
  if (span == 0) return -1;
  const double s = (edge - p[axis]) / span;
  if (s < 0 || s > 1) return -1;
  const double across = p[1 - axis] + s * (q[1 - axis] - p[1 - axis]);
  if (std::fabs(across) > imageEdge) return -1;
  return axis == 0 || hitsEdgeInSinglePrecision(p, q, edge) ? s : -1;
}

}  // namespace

bool clipToView(Vec3& a, Vec3& b) {
  bool seesA = isVisible(a), seesB = isVisible(b);
  if (seesA && seesB) return true;

  Vec3 p = a, q = b;
  const auto cutAtPlane = [](Vec3& behind, const Vec3& before) {
    const double t = (nearPlane - before.x()) / (behind.x() - before.x());
    behind = before + t * (behind - before);
  };
  if (p.x() < nearPlane && q.x() >= nearPlane)
    cutAtPlane(p, q);
  else if (q.x() < nearPlane && p.x() >= nearPlane)
    cutAtPlane(q, p);
  if (p.x() <= 0 || q.x() <= 0) return false;

  const Vec2 imageP = p.tail<2>() / p.x(), imageQ = q.tail<2>() / q.x();
  constexpr std::array<std::pair<int, double>, 4> edges = {{{1, 1.0}, {1, -1.0}, {0, 1.0}, {0, -1.0}}};
  std::array<Vec3, 2> cuts;
  std::size_t numCuts = 0;
  for (const auto& [axis, sign] : edges) {
    if (numCuts == 2) break;
    const double s = crossing(imageP, imageQ, axis, sign * imageEdge);
    if (s < 0) continue;
    const double t = s * p.x() / (q.x() + s * (p.x() - q.x()));  // from the image back to the line in space
    cuts[numCuts++] = p + t * (q - p);
  }
  if (numCuts == 2) {
    a = cuts[0];
    b = cuts[1];
    return true;
  }
  if (numCuts == 0) return false;
  if (!seesA) {
    a = cuts[0];
    return seesB;
  }
  b = cuts[0];
  return true;
}

Vision::Vision(const CameraError& noise, RandomStream& random) : noise_(noise), random_(random) {
  for (int i = 0; i < 3; ++i) offset_[i] = random_.uniform(-noise_.offset, noise_.offset);
}

void Vision::addNoise(Polar& polar) {
  polar.distance *= 1 + noise_.distancePercent / 100 * random_.normal();
  polar.azimuth += noise_.azimuth * random_.normal();
  polar.elevation += noise_.elevation * random_.normal();
}

bool Vision::look(const Vec3& world, const Pose3& T_head_world, Polar& seen) {
  const Vec3 inHead = T_head_world * world;
  if (inHead.norm() <= nearest) return false;
  seen = toPolar(inHead + offset_);
  if (!inCone(seen)) return false;
  addNoise(seen);
  return true;
}

simspark::See Vision::see(const Pose3& T_world_head, const VisibleWorld& world) {
  simspark::See image;
  const Pose3 T_head_world = T_world_head.inverse();
  Polar seen;
  for (const FieldFlag& flag : world.marks.flags)
    if (look(flag.position, T_head_world, seen)) image.objects.push_back({std::string(flag.name), seen});
  if (look(world.ball, T_head_world, seen)) image.objects.push_back({"B", seen});
  for (const VisibleWorld::Player& player : world.players) {
    simspark::SeenPlayer seenPlayer{std::string(player.team), player.unum, {}};
    for (const VisibleWorld::Part& part : player.parts)
      if (look(part.position, T_head_world, seen)) seenPlayer.parts.push_back({std::string(part.name), seen});
    if (!seenPlayer.parts.empty()) image.players.push_back(std::move(seenPlayer));
  }
  for (const FieldLine& line : world.marks.lines) {
    Vec3 a = T_head_world * line.begin + offset_, b = T_head_world * line.end + offset_;
    if (!clipToView(a, b)) continue;
    simspark::SeenLine seenLine{toPolar(a), toPolar(b)};
    addNoise(seenLine.a);
    addNoise(seenLine.b);
    image.lines.push_back(seenLine);
  }
  return image;
}

}  // namespace plumbline::simulation
