#pragma once
#include <array>
#include <bitset>
#include <cstdint>
#include <string>

#include "robot/RobotModel.h"
#include "simspark/ServerMessage.h"
#include "simulation/referee/Game.h"
#include "simulation/sensors/Hearing.h"
#include "simulation/sensors/Vision.h"
#include "simulation/world/RandomStream.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Number of a player in the order of coming; never used twice.
using PlayerId = int;

struct PlayerConfig {
  CameraError vision;
  int visionInterval = 3;                      ///< cycles from image to image
  double beamNoise = 0.05;                     ///< at most, per axis [m]
  double beamTurnNoise = 0.17453292519943295;  ///< at most [rad]
  bool groundTruth = false;                    ///< the true state in every message (thesis A.6.4)
  int groundTruthDecimals = 2;
};

/// One robot with its senses and its place in a team.
class Player {
public:
  Player(PlayerId id, int type, const PlayerConfig& config, std::uint64_t seed);

  PlayerId id() const { return id_; }
  int type() const { return type_; }
  const RobotModel& model() const { return model_; }

  RobotHandle robot = -1;
  TeamSide side = TeamSide::none;
  int unum = 0;
  bool selected = false;
  std::bitset<maxJoints> frozen;  ///< joints that take no speed for now, by the referee
  Hearing hearing;

  /// Turns commanded speeds into the world's motors; joints the robot lacks are ignored.
  void drive(World& world, const std::array<std::optional<double>, numHumanoidJoints>& velocity) const;
  /// The place with the beam's error.
  Pose2 disturbed(const Pose2& place);
  /// What others see of this robot.
  VisibleWorld::Player visibleParts(const World& world, std::string_view team) const;
  /// Makes the message of this cycle. truth: of all players, if it is sent.
  void sense(const World& world, const Game& game, double time, const VisibleWorld& visible,
             const simspark::GroundTruth* truth);
  const std::string& message() const { return text_; }

private:
  static constexpr std::array<std::pair<const char*, const char*>, 5> partLinks = {
      {{"head", "head"},
       {"rlowerarm", "rLowerArm"},
       {"llowerarm", "lLowerArm"},
       {"rfoot", "rFoot"},
       {"lfoot", "lFoot"}}};
  PlayerId id_;
  int type_;
  PlayerConfig config_;
  RobotModel model_;
  RandomStream random_;
  Vision vision_;
  std::array<int, partLinks.size()> parts_{};
  bool placeReported_ = false;  ///< number and side have been sent
  std::uint64_t cycle_ = 0;
  simspark::ServerMessage senses_;
  std::string text_;
};

}  // namespace plumbline::simulation
