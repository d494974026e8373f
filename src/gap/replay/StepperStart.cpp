// How a plant in motion gets its state: put on the ground, or where it was measured.
#include <algorithm>
#include <cmath>

#include "gap/replay/SolePlate.h"
#include "gap/replay/Stepper.h"

namespace plumbline::gap {

void Stepper::placeOnGround() {
  const Mat3 R_ground = rotationOfGround(plant_.ground);
  T_world_base_ = rotationZ(trial_.heading);
  // Which foot carries how much depends on how the robot was put down: friction keeps what is pressed apart.
  if (!plant_.ground.putUpright) T_world_base_.linear() = R_ground * T_world_base_.linear();
  tree_.update(T_world_base_.linear(), q_.data() + tree_.baseSize(), v_.data());
  T_world_base_.translation() = heightOnGround() * R_ground.col(2);
}

/// Of the base's origin over the ground where the lowest corner of a sole all but touches it [m]. Hardly
/// above: a fall of half a millimetre shakes what sticks out of where it was seen.
double Stepper::heightOnGround() const {
  const Vec3 normal = rotationOfGround(plant_.ground).col(2);
  double lowest = 0;
  for (const auto& foot : plant_.mechanism.feet) {
    for (const Vec3& corner : soleCorners(foot))
      lowest = std::min(lowest, normal.dot(tree_.origin(foot.link) + tree_.rotation(foot.link) * corner));
  }
  return 2e-5 - lowest;
}

void Stepper::restart(const Restart& seen) {
  for (Drive& drive : drives_) {
    const JointPlant& p = plant_.joints[index(drive.joint)];
    const double position = seen.position[index(drive.joint)], speed = seen.speed[index(drive.joint)];
    if (!std::isfinite(position) || !std::isfinite(speed)) continue;
    double wanted = q_[drive.sensed];
    for (int i = 0; i < 3; ++i) wanted += position - measuredAngle(p, wanted);
    const double moved = wanted - q_[drive.sensed];
    q_[drive.link] += moved;
    if (drive.motor != drive.link) q_[drive.motor] += moved;
    v_[drive.link] = v_[drive.motor] = speed;
  }
  const auto most = std::ranges::max_element(seen.load);
  if (contacts_ && most != seen.load.end()) standOn(static_cast<int>(most - seen.load.begin()));
  hold();
}

void Stepper::standOn(int foot) {
  const int link = plant_.mechanism.feet[index(foot)].link;
  const Mat3 R_ground = rotationOfGround(plant_.ground);
  const auto heading = [](const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); };
  v_.head<6>().setZero();
  tree_.update(Mat3::Identity(), q_.data() + tree_.baseSize(), v_.data());
  Mat3 R = R_ground * tree_.rotation(link).transpose();
  R = rotation(R_ground.col(2), heading(T_world_base_.linear()) - heading(R)).linear() * R;
  T_world_base_.linear() = R;
  tree_.update(R, q_.data() + tree_.baseSize(), v_.data());
  const Vec3 turn = tree_.angularVelocity(link);
  v_.segment<3>(3) = -turn;
  v_.head<3>() = -tree_.velocityAt(link, tree_.origin(link)) + turn.cross(tree_.origin(link));
  const Vec3 normal = R_ground.col(2), place = T_world_base_.translation();
  T_world_base_.translation() = place + (heightOnGround() - normal.dot(place)) * normal;
}

void Stepper::hold() {
  for (Drive& drive : drives_) {
    const JointPlant& p = plant_.joints[index(drive.joint)];
    drive.shown = drive.shownBefore = measuredAngle(p, q_[drive.sensed]);
    drive.rate = drive.rateBefore = v_[drive.sensed];
  }
}

}  // namespace plumbline::gap
