#pragma once
#include <vector>

#include "framework/StreamTypes.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The joints whose values streams and logs of this process carry, in this order: the 24 of a humanoid, then
/// those the robot has of its own. A log therefore holds no number of a joint that no robot of its kind has.
const std::vector<JointId>& streamedJoints();
/// The joints that such streams carry for a robot.
std::vector<JointId> streamedJointsOf(const RobotModel& robot);
/// To be called once, before anything streams: by the program, with the robot that its platform gives.
void streamJointsOf(const RobotModel& robot);

template <typename T>
struct StreamType<PerJoint<T>> {
  static void write(OutStream& out, const PerJoint<T>& value) {
    out.beginList(streamedJoints().size(), false);
    for (const JointId joint : streamedJoints()) StreamType<T>::write(out, value[joint]);
    out.endList();
  }
  static void read(InStream& in, PerJoint<T>& value) {
    in.beginObject();
    for (const JointId joint : streamedJoints())
      if (in.ok()) StreamType<T>::read(in, value[joint]);
    in.endObject();
  }
};

}  // namespace plumbline
