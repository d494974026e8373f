#include "modules/skills/Kicks.h"

#include <algorithm>

#include "framework/ConfigurationError.h"
#include "modules/motion/Motions.h"

namespace plumbline {

MAKE_MODULE(Kicks)

void Kicks::init() {
  // Where main knows the robot, a broken file is reported before anything else starts.
  if (const RobotModel* robot = findObject<RobotModel>()) read(*robot);
}

void Kicks::read(const RobotModel& robot) {
  robot_ = robot.name;
  kicks_.kicks.clear();
  for (const motion::KeyframeMotion& found : readMotions(config, robot)) {
    if (!found.kick) continue;
    const motion::KeyframeMotion right = found.ball.y() > 0 ? mirrored(found) : found;
    Kick kick;
    kick.motion = right.name;
    kick.ballPosition = right.ball;
    static_cast<KickEffect&>(kick) = *right.kick;
    kicks_.kicks.push_back(kick);
  }
  if (kicks_.kicks.empty())
    throw ConfigurationError("no motion in motions/ of robot " + robot.name +
                             " is a kick: give one the key kick (doc/how-to/add-a-motion.md)");
  std::ranges::stable_sort(kicks_.kicks, {}, &Kick::distance);
}

void Kicks::update(SkillKickParameters* theSkillKickParameters) {
  if (theRobotDescription->known() && theRobotDescription->name != robot_) {
    read(theRobotDescription->model);
    robot_ = theRobotDescription->name;
  }
  *theSkillKickParameters = kicks_;
}

}  // namespace plumbline
