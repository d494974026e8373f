#include "robot/JointStream.h"

namespace plumbline {
namespace {

std::vector<JointId>& streamed() {
  static std::vector<JointId> joints = streamedJointsOf(RobotModel());  // which has none of its own
  return joints;
}

}  // namespace

std::vector<JointId> streamedJointsOf(const RobotModel& robot) {
  std::vector<JointId> joints;
  for (int j = 0; j < numHumanoidJoints; ++j) joints.push_back(static_cast<JointId>(j));
  for (const JointId joint : robot.joints())
    if (joint >= numHumanoidJoints) joints.push_back(joint);
  return joints;
}

const std::vector<JointId>& streamedJoints() { return streamed(); }
void streamJointsOf(const RobotModel& robot) { streamed() = streamedJointsOf(robot); }

}  // namespace plumbline
