// How a plant in motion gets its state: put on the ground, or where it was measured.
#include <algorithm>
#include <cmath>

#include "gap/replay/SolePlate.h"
#include "gap/replay/Stepper.h"

namespace plumbline::gap {

void Stepper::placeOnGround() {
  const Mat3 R_ground = rotationOfGround(plant.ground);
  T_world_base = rotationZ(trial.heading);
  // Which foot carries how much depends on how the robot was put down: friction keeps what is pressed apart.
  if (!plant.ground.putUpright) T_world_base.linear() = R_ground * T_world_base.linear();
  tree.update(T_world_base.linear(), q.data() + tree.baseSize(), v.data());
  T_world_base.translation() = heightOnGround() * R_ground.col(2);
}

/// Of the base's origin over the ground where the lowest corner of a sole all but touches it [m]. Hardly
/// above: a fall of half a millimetre shakes what sticks out of where it was seen.
double Stepper::heightOnGround() const {
  const Vec3 normal = rotationOfGround(plant.ground).col(2);
  double lowest = 0;
  for (const auto& foot : plant.mechanism.feet) {
    for (const Vec3& corner : soleCorners(foot))
      lowest = std::min(lowest, normal.dot(tree.origin(foot.link) + tree.rotation(foot.link) * corner));
  }
  return 2e-5 - lowest;
}

void Stepper::restart(const Restart& seen) {
  for (Drive& drive : drives) {
    const JointPlant& p = plant.joints[index(drive.joint)];
    const double position = seen.position[index(drive.joint)], speed = seen.speed[index(drive.joint)];
    if (!std::isfinite(position) || !std::isfinite(speed)) continue;
    double wanted = q[drive.sensed];
    for (int i = 0; i < 3; ++i) wanted += position - measuredAngle(p, wanted);
    const double moved = wanted - q[drive.sensed];
    q[drive.link] += moved;
    if (drive.motor != drive.link) q[drive.motor] += moved;
    v[drive.link] = v[drive.motor] = speed;
  }
  const auto most = std::ranges::max_element(seen.load);
  if (contacts && most != seen.load.end()) standOn(static_cast<int>(most - seen.load.begin()));
  hold();
}

void Stepper::standOn(int foot) {
  const int link = plant.mechanism.feet[index(foot)].link;
  const Mat3 R_ground = rotationOfGround(plant.ground);
  const auto heading = [](const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); };
  v.head<6>().setZero();
  tree.update(Mat3::Identity(), q.data() + tree.baseSize(), v.data());
  Mat3 R = R_ground * tree.rotation(link).transpose();
  R = rotation(R_ground.col(2), heading(T_world_base.linear()) - heading(R)).linear() * R;
  T_world_base.linear() = R;
  tree.update(R, q.data() + tree.baseSize(), v.data());
  const Vec3 turn = tree.angularVelocity(link);
  v.segment<3>(3) = -turn;
  v.head<3>() = -tree.velocityAt(link, tree.origin(link)) + turn.cross(tree.origin(link));
  const Vec3 normal = R_ground.col(2), place = T_world_base.translation();
  T_world_base.translation() = place + (heightOnGround() - normal.dot(place)) * normal;
}

void Stepper::hold() {
  for (Drive& drive : drives) {
    const JointPlant& p = plant.joints[index(drive.joint)];
    drive.shown = drive.shownBefore = measuredAngle(p, q[drive.sensed]);
    drive.rate = drive.rateBefore = v[drive.sensed];
  }
}

}  // namespace plumbline::gap
