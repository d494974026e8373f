#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

MODULE(Kicks)
  REQUIRES(RobotDescription)
  PROVIDES(SkillKickParameters)
END_MODULE

/// The kicks that a robot has: the motions of motions/ whose files say `kick`.
class Kicks : public KicksBase {
public:
  void init() override;
  void update(SkillKickParameters* theSkillKickParameters) override;

private:
  void read(const RobotModel& robot);

  SkillKickParameters kicks_;
  std::string robot_;
};

}  // namespace plumbline
