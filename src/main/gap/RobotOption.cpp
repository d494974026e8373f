#include "main/gap/RobotOption.h"

#include "robot/MechanismFile.h"

namespace plumbline::gap {

Mechanism robotOf(const std::string& given, const std::string& named) {
  if (given.empty()) return findMechanism(named);
  if (given.find('/') == std::string::npos && given.find('.') == std::string::npos)
    return findMechanism(given);
  return readMechanism(given);
}

}  // namespace plumbline::gap
