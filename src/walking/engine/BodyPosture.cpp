#include "walking/engine/BodyPosture.h"

namespace plumbline::walking {

BodyPosture::BodyPosture(const RobotModel& robot)
    : robot_(robot),
      kinematics_(robot_),
      legs_{LegKinematics(robot_, Side::left), LegKinematics(robot_, Side::right)} {}

bool BodyPosture::solve(const std::array<FootPlacement, 2>& feet, const TorsoPlacement& torso,
                        JointArray& angles) {
  // Moving the torso moves the legs' masses only by a part, so the fixed point is reached quickly: the error
  // shrinks to about a third each time.
  constexpr int iterations = 4;
  constexpr double closeEnough = 1e-5;  // [m]
  T_com_torso_.linear() = (rotationY(torso.pitch) * rotationX(torso.roll)).linear();
  const Vec3 hips = T_com_torso_.linear() * ((legs_[0].hip() + legs_[1].hip()) / 2);
  std::array<Pose3, 2> soles;
  for (std::size_t i = 0; i < 2; ++i) {
    const FootPlacement& foot = feet[i];
    soles[i] = translation(foot.ground.x(), foot.ground.y(), foot.height) * rotationZ(foot.ground.heading) *
               rotationY(foot.pitch) * rotationX(foot.roll);
  }
  bool reachable = true;
  for (int i = 0; i < iterations; ++i) {
    T_com_torso_.translation() = Vec3(offset_.x(), offset_.y(), torso.hipHeight - hips.z());
    reachable = true;
    std::array<LegSolution, 2> solution;
    for (std::size_t l = 0; l < 2; ++l) solution[l] = legs_[l].solve(T_com_torso_.inverse() * soles[l]);
    if (robot_.sharedHipYawPitch) {
      const double shared = (solution[0].angles[0] + solution[1].angles[0]) / 2;
      for (std::size_t l = 0; l < 2; ++l)
        solution[l] = legs_[l].solve(T_com_torso_.inverse() * soles[l], shared);
    }
    for (const Side side : {Side::left, Side::right}) {
      const LegSolution& leg = solution[index(side)];
      reachable = reachable && leg.reachable;
      std::copy(leg.angles.begin(), leg.angles.end(), angles.begin() + firstLegJoint(side));
    }
    kinematics_.update(angles);
    const Vec2 error = (T_com_torso_ * kinematics_.com()).head<2>();
    if (error.norm() < closeEnough) break;
    offset_ -= error;
  }
  return reachable;
}

}  // namespace plumbline::walking
