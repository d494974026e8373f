#include "robot/RobotModel.h"

namespace plumbline {

int RobotModel::linkIndex(std::string_view linkName) const {
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].name == linkName) return static_cast<int>(i);
  return -1;
}

double RobotModel::totalMass() const {
  double sum = 0;
  for (const Link& link : links) sum += link.mass;
  return sum;
}

}  // namespace plumbline
