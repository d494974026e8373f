#include "tactics/approach/WalkToPlace.h"

namespace plumbline {

WalkCommand WalkToPlace::update(const Pose2& T_robot_place, const Vec3& speed, const WalkLimits& limits,
                                const std::optional<Vec2>& detour, const WalkToPoseParameters& walk,
                                const ApproachPlannerParameters& plan) {
  const bool plans =
      !detour && ApproachPlanner::plansFrom(T_robot_place.position.norm(), sprinting_, limits, plan);
  if (!plans) planner_.leave();
  const WalkCommand command = plans    ? planner_.update({T_robot_place.inverse(), speed}, limits, plan)
                              : detour ? walkPast(*detour, walk, sprinting_)
                                       : walkToPose(T_robot_place, walk, sprinting_);
  sprinting_ = command.sprint;
  return command;
}

void WalkToPlace::leave() {
  sprinting_ = false;
  planner_.leave();
}

}  // namespace plumbline
