#include "robot/NoSuchJoint.h"

#include <stdexcept>

#include "framework/NearestName.h"

namespace plumbline {

void failNoSuchJoint(const std::string& robot, std::string_view joint,
                     const std::vector<std::string>& names) {
  throw std::invalid_argument("robot " + robot + " has no joint " + std::string(joint) +
                              suggestion(joint, names));
}

}  // namespace plumbline
