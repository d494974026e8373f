#pragma once
#include "robot/RobotModel.h"
#include "simulation/physics/Physics.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// What things are made of, as far as contacts go.
namespace material {
constexpr Material robot = 0, ball = 1, ground = 2, obstacle = 3;
}

/// The league server's settings of the whole world and of its contacts (rcssserver3d 0.7.3).
PhysicsConfig leaguePhysics(const WorldConfig& config);

/// A robot as bodies and hinges: body i is link i, hinge i moves link i+1. The root body's frame is link 0's
/// centre of mass.
Assembly leagueRobot(const RobotModel& model, const WorldConfig& config);

/// The ball as a single body, of a field with its radius.
Assembly leagueBall(const FieldSize& field);

}  // namespace plumbline::simulation
