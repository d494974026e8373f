#include "training/ServerTrial.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"

namespace plumbline::training {
namespace {

constexpr int mostCycles = 200;  // until it lies
constexpr double tips = 0.3;     // it falls for good from this lean on [rad]

}  // namespace

void ServerTrial::standAt(const Pose2& place) {
  robot.put(place, stand);
  forget();
}

bool ServerTrial::fall(int direction) {
  JointArray from = jitter(0.25);
  const JointArray to = jitter(0.4);
  const double lean = -direction * random(0.3, 0.7), heading = random(-pi, pi);
  for (const JointId joint : {lAnklePitch, rAnklePitch}) {
    const Link& link = model.linkMovedBy(joint);
    from[joint] = std::clamp(from[joint] + lean, link.lower + 0.02, link.upper - 0.02);
  }
  robot.drop(Pose2(Vec2::Zero(), heading), from, random(0, 0.1));
  forget();
  int rest = static_cast<int>(random(1, 11));
  bool free = true;
  for (int i = 0; i < mostCycles && free && rest > 0; ++i) {
    step(tilt() > tips ? to : from);
    free = !overlaps();
    if (lying()) --rest;
  }
  const Vec3 vertical = up();
  return free && lying() && std::abs(vertical.x()) >= std::abs(vertical.y()) &&
         (vertical.x() < 0) == (direction > 0);
}

bool ServerTrial::overlaps() {
  twin_.restart(torsoPose(), readings().angle);
  return twin_.overlaps();
}

}  // namespace plumbline::training
