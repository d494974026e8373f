#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// What is said of a joint that a robot lacks: the robot and, of the names it has, the nearest. Throws
/// std::invalid_argument.
[[noreturn]] void failNoSuchJoint(const std::string& robot, std::string_view joint,
                                  const std::vector<std::string>& names);

}  // namespace plumbline
