#include "main/gap/RobotOption.h"

#include "robot/MechanismFile.h"

namespace plumbline::gap {

Mechanism robotOf(const std::string& given, const std::string& named) {
  return given.empty() ? findMechanism(named) : namedMechanism(given);
}

}  // namespace plumbline::gap
