#pragma once
#include <cmath>
#include <numbers>

#include "simspark/AgentCommand.h"

namespace plumbline::bench {

/// Knees that bend and stretch twice a second, so that the robot never comes to rest and the physics has
/// work.
inline simspark::AgentCommand bending(int cycle) {
  simspark::AgentCommand command;
  const double speed = 1.2 * std::sin(0.02 * cycle * 2 * std::numbers::pi * 2);
  for (const int leg : {static_cast<int>(lHipYawPitch), static_cast<int>(rHipYawPitch)}) {
    command.velocity[static_cast<std::size_t>(leg + lHipPitch - lHipYawPitch)] = -speed / 2;
    command.velocity[static_cast<std::size_t>(leg + lKneePitch - lHipYawPitch)] = speed;
    command.velocity[static_cast<std::size_t>(leg + lAnklePitch - lHipYawPitch)] = -speed / 2;
  }
  command.velocity[headYaw] = std::sin(0.1 * cycle);
  command.syn = true;
  return command;
}

/// Types of a team that may play.
constexpr int teamTypes[] = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4};

}  // namespace plumbline::bench
