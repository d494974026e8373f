#include "web/Frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "robot/RobotModel.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::web {

static_assert(std::endian::native == std::endian::little, "frames are written as they lie in memory");

namespace {

constexpr double relativeUnit = 1e-4, orientationUnit = 1.0 / 32767;
/// Resolution of what is sent (0.5 mm, 0.06 degrees): invisible, and it halves recordings.
constexpr double relativeStep = 5, orientationStep = 16;

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

void putScaled(std::string& out, double value, double unit, double step) {
  const double units = std::isfinite(value) ? step * std::round(value / (unit * step)) : 0;
  put(out, static_cast<std::int16_t>(std::clamp(units, -32767.0, 32767.0)));
}

void putPosition(std::string& out, const Vec3& position) {
  for (int i = 0; i < 3; ++i) put(out, static_cast<float>(position[i]));
}

void putOrientation(std::string& out, const Mat3& axes) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(axes).normalized();
  for (int i = 0; i < 4; ++i) putScaled(out, q.coeffs()[i], orientationUnit, orientationStep);
}

using BodyCounts = std::vector<std::size_t>;

void putRobot(std::string& out, const simspark::SceneRobot& robot, const BodyCounts& bodiesOf) {
  const auto& bodies = robot.T_world_bodies;
  const auto type = static_cast<std::size_t>(robot.type);
  const bool known = type < bodiesOf.size() && bodies.size() == bodiesOf[type];
  const std::size_t parts = known ? bodies.size() : 0;
  put(out, static_cast<std::uint8_t>(robot.side));
  put(out, static_cast<std::uint8_t>(std::clamp(robot.unum, 0, 255)));
  put(out, static_cast<std::uint8_t>(known ? robot.type : 0));
  put(out, static_cast<std::uint8_t>(parts));
  const Vec3 torso = robot.T_world_torso.translation();
  putPosition(out, torso);
  for (std::size_t i = 0; i < parts; ++i) {
    const Vec3 fromTorso = bodies[i].translation() - torso;
    for (int axis = 0; axis < 3; ++axis) putScaled(out, fromTorso[axis], relativeUnit, relativeStep);
    putOrientation(out, bodies[i].linear());
  }
}

}  // namespace

std::string frameMessage(const simspark::SceneState& scene) {
  const std::size_t robots = std::min<std::size_t>(scene.robots.size(), 255);
  std::string out;
  out.reserve(frameHeaderBytes + robots * (frameRobotBytes + 25 * framePartBytes));
  put(out, std::uint8_t{1});
  put(out, static_cast<std::uint8_t>(robots));
  put(out, std::uint16_t{0});
  put(out, scene.time);
  putPosition(out, scene.ball);
  putOrientation(out, scene.ballAxes);
  BodyCounts bodiesOf;
  for (int type = 0; type < numSimsparkTypes(); ++type)
    bodiesOf.push_back(simspark::sceneBodies(type).size());
  for (std::size_t i = 0; i < robots; ++i) putRobot(out, scene.robots[i], bodiesOf);
  return out;
}

}  // namespace plumbline::web
