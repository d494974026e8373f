#pragma once
#include <string>

#include "record/Schema.h"

namespace plumbline::record {

/// The package that the messages of representations have in ROS 2's tools.
inline constexpr const char* messagePackage = "plumbline_msgs";

/// `plumbline_msgs/msg/BallPos`
std::string messageType(const std::string& representation);

/// The definition of a representation's message and of all messages in it, as `ros2 interface show` and bags
/// have it. Names of fields are the labels in lower case with underscores, as ROS 2 wants them.
std::string messageDefinition(const std::string& representation, const Schema& schema);

}  // namespace plumbline::record
