#pragma once
#include <string>
#include <vector>

#include "gap/run/Table.h"

namespace plumbline::gap {

/// Reads a recording by its ending: JSON (.jsonl, .ndjson, .json), a bag of ROS 2 (.db3, or a folder of
/// them), else a table of text. Throws RunError.
Table readRecording(const std::string& path, const TableForm& form);

/// One JSON object a line, or one list of objects. A number in it is a column named by its path,
/// `imu.gyro.0`; true is 1, null a lost sample. If an object names its parts, as in {"name": ["a", "b"],
/// "position": [1, 2]}, these names replace the numbers: `position.a`. A key that an object does not have is
/// a lost sample there.
Table readJsonLines(const std::string& path);

/// Messages of sensor_msgs/JointState and Imu, trajectory_msgs/JointTrajectory and
/// std_msgs/Float64MultiArray. One line for each message of the topic with the most joint states; t is when
/// it was recorded [s]. Columns are TOPIC.FIELD.JOINT, slashes of the topic as dots:
/// `joint_states.position.LKneePitch`. Each line has the last values of the other topics.
Table readRosBag(const std::string& path);

}  // namespace plumbline::gap
