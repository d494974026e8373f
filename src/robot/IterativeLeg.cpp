#include "robot/IterativeLeg.h"

#include <algorithm>
#include <cmath>

#include "math/SolvePositive.h"
#include "math/TurnBetween.h"

namespace plumbline {
namespace {

// The error of a pose is one number: place [m] and direction [rad] together.
constexpr double converged = 1e-10;  // [m, rad] no further step is taken
constexpr double reached = 1e-8;     // [m, rad] the pose counts as reached
constexpr double stepLimit = 0.5;    // [rad] of the largest change of a joint in one step
constexpr int maxSteps = 80;
constexpr double leastGain = 1e-6;  // share of the error; a step that takes off less is the last
constexpr double leastDamping = 1e-16, mostDamping = 1e8;  // the latter in parts of the error's square

enum LegAngle : std::size_t { hipYawPitch, hipRoll, hipPitch, kneePitch, anklePitch, ankleRoll };

/// Where the search begins: first a leg that is bent by this share of the knee's range, then postures spread
/// evenly over the joints' ranges (the additive recurrence of Roberts, 2018, in six dimensions).
constexpr double bends[] = {0.35, 0.7};
constexpr std::size_t numStarts = 12;

LegAngles startAngles(const LegChain& chain, std::size_t start) {
  constexpr double root = 1.1127756842787055;  // x^7 = x + 1
  LegAngles q{};
  double knee = 0;
  for (const LegChain::Joint& joint : chain.joints())
    if (joint.angle == kneePitch && start < std::size(bends))
      knee = joint.lower + bends[start] * (joint.upper - joint.lower);
  for (const LegChain::Joint& joint : chain.joints()) {
    double& angle = q[joint.angle];
    if (start < std::size(bends)) {
      if (joint.angle == kneePitch) angle = knee;
      if (joint.angle == hipPitch || joint.angle == anklePitch) angle = -knee / 2;
    } else {
      const double share = 0.5 + static_cast<double>(start - std::size(bends)) *
                                     std::pow(root, -1.0 - static_cast<double>(joint.angle));
      angle = joint.lower + (share - std::floor(share)) * (joint.upper - joint.lower);
    }
    angle = std::clamp(angle, joint.lower, joint.upper);
  }
  return q;
}

}  // namespace

IterativeLeg::IterativeLeg(const RobotModel& model, Side side) : chain_(model, side) {
  const std::array<Pose3, 6> zero = chain_.poses({});
  std::array<Vec3, 6> place;
  Mat3 across = Mat3::Zero();
  Vec3 sum = Vec3::Zero(), kneeAxis = Vec3::UnitY();
  double lower = 0, upper = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const LegChain::Joint& joint = chain_.joints()[i];
    place[joint.angle] = zero[i].translation();
    if (joint.angle <= hipPitch) {
      const Mat3 off = Mat3::Identity() - joint.axis * joint.axis.transpose();
      across += off;
      sum += off * zero[i].translation();
    }
    if (joint.angle == kneePitch) {
      kneeAxis = joint.axis;
      lower = joint.lower;
      upper = joint.upper;
    }
  }
  // Hip axes that are all parallel leave the place along them open: there it is zero.
  hip_ = sum;
  solvePositive<3>(across + 1e-12 * Mat3::Identity(), hip_);
  ankleHeight_ = (place[anklePitch] - zero.back().translation()).z();
  // The shank turns about the knee: its square distance from the hip is a constant and one cosine.
  const Vec3 thigh = place[kneePitch] - hip_, shank = place[anklePitch] - place[kneePitch];
  const Vec3 along = kneeAxis * kneeAxis.dot(shank);
  const double straight =
      std::clamp(std::atan2(thigh.dot(kneeAxis.cross(shank)), thigh.dot(shank - along)), lower, upper);
  for (const double knee : {lower, straight, upper})
    maxReach_ = std::max(maxReach_, (thigh + rotation(kneeAxis, knee) * shank).norm());
}

LegSolution IterativeLeg::solve(const Pose3& T_torso_foot) const {
  return solve(Target{T_torso_foot, std::nullopt});
}

LegSolution IterativeLeg::solve(const Pose3& T_torso_foot, double given) const {
  return solve(Target{T_torso_foot, given});
}

LegSolution IterativeLeg::solve(const Target& target) const {
  LegSolution solution;
  double best = -1;
  bool outside = false;
  for (std::size_t start = 0; start < numStarts; ++start) {
    LegAngles angles = startAngles(chain_, start);
    if (target.hipYawPitch) angles[hipYawPitch] = *target.hipYawPitch;
    chain_.clip(angles, outside);
    const double error = descend(target, angles);
    if (best >= 0 && error >= best) continue;
    best = error;
    solution.angles = angles;
    if (best < reached) break;
  }
  solution.reachable = best < reached && !outside;
  return solution;
}

IterativeLeg::Vec6 IterativeLeg::errorOf(const Target& target, const std::array<Pose3, 6>& poses) const {
  const Pose3& foot = poses.back();
  Vec6 error;
  error.head<3>() = target.foot.translation() - foot.translation();
  if (target.hipYawPitch) {
    // The turn that brings the sole's normal to the wanted one; the heading is free.
    error.tail<3>() = turnBetween(foot.linear().col(2), target.foot.linear().col(2));
  } else {
    const Eigen::AngleAxisd turn(Mat3(target.foot.linear() * foot.linear().transpose()));
    error.tail<3>() = turn.angle() * turn.axis();
  }
  return error;
}

IterativeLeg::Mat6 IterativeLeg::jacobian(const Target& target, const std::array<Pose3, 6>& poses) const {
  Mat6 J;
  const Vec3 foot = poses.back().translation(), normal = poses.back().linear().col(2);
  for (std::size_t i = 0; i < 6; ++i) {
    const LegChain::Joint& joint = chain_.joints()[i];
    const auto column = static_cast<Eigen::Index>(joint.angle);
    const Vec3 axis = poses[i].linear() * joint.axis;
    J.block<3, 1>(0, column) = axis.cross(foot - poses[i].translation());
    J.block<3, 1>(3, column) = target.hipYawPitch ? Vec3(axis - normal.dot(axis) * normal) : axis;
  }
  return J;
}

/// Moves the angles to where the error is smallest near them; returns the remaining error.
double IterativeLeg::descend(const Target& target, LegAngles& angles) const {
  std::array<Pose3, 6> poses = chain_.poses(angles);
  Vec6 error = errorOf(target, poses);
  double size = error.norm(), damping = 0.1;
  for (int step = 0; step < maxSteps && size > converged; ++step) {
    Mat6 J = jacobian(target, poses);
    Vec6 downhill = J.transpose() * error;
    Mat6 normal = J.transpose() * J;
    // An angle that is given or would leave its limits stays.
    for (const LegChain::Joint& joint : chain_.joints()) {
      const auto k = static_cast<Eigen::Index>(joint.angle);
      const double q = angles[joint.angle];
      const bool given = target.hipYawPitch && joint.angle == hipYawPitch;
      if (!given && !(q <= joint.lower && downhill[k] < 0) && !(q >= joint.upper && downhill[k] > 0))
        continue;
      downhill[k] = 0;
      normal.row(k).setZero();
      normal.col(k).setZero();
    }
    const double before = size;
    while (size == before && damping < mostDamping) {
      const Mat6 damped = normal + (damping * size * size + leastDamping) * Mat6::Identity();
      Vec6 change = downhill;
      if (!solvePositive(damped, change)) {
        damping *= 10;
        continue;
      }
      change *= std::min(1.0, stepLimit / std::max(stepLimit, change.cwiseAbs().maxCoeff()));
      LegAngles next = angles;
      for (std::size_t k = 0; k < 6; ++k) next[k] += change[static_cast<Eigen::Index>(k)];
      bool clipped = false;
      chain_.clip(next, clipped);
      const std::array<Pose3, 6> there = chain_.poses(next);
      const Vec6 left = errorOf(target, there);
      if (left.norm() < size) {
        angles = next;
        poses = there;
        error = left;
        size = left.norm();
        damping = std::max(damping / 4, 1e-3);
      } else {
        damping *= 10;
      }
    }
    if (before - size < leastGain * before) break;
  }
  return size;
}

}  // namespace plumbline
