#pragma once
#include <string>

#include "gap/run/Run.h"
#include "record/LogCopy.h"
#include "record/LogReader.h"

namespace plumbline::logtool {

/// What a log says of the robot's joints and body as a run of the diagnosis: t, cmd, stiffness and pos of
/// each joint that the robot has, gyro and acc. The log needs FrameInfo, RobotDescription, JointData and
/// JointRequest of one thread, and SensorData for the body. Throws std::runtime_error, one line.
gap::Run gapRun(record::LogReader& log, const record::LogReader::Thread& thread, const record::LogPart& part,
                const std::string& motion, const record::Progress& progress);

}  // namespace plumbline::logtool
