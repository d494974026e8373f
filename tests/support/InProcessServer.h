#pragma once
#include <string>

#include "robot/JointVelocityControl.h"
#include "simspark/ServerMessage.h"
#include "simulation/league/LocalRobot.h"
#include "support/SyntheticImage.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::test {

/// The league's server with one robot on its physics, in this process: its messages as text with noise,
/// rounding and ground truth, the robot driven by the walk engine with a head that sweeps. For tests of what
/// an agent makes of the messages.
class InProcessServer {
public:
  struct Setup {
    int type = 0;
    std::uint64_t seed = 1;
    bool leftSide = true;
    Pose2 start{-5, 1, 0.2};  ///< on the server's field
  };
  explicit InProcessServer(const Setup& setup);

  /// The message of this cycle; the same until step().
  std::string message();
  /// One cycle in which the robot walks so; it turns away from the border by itself.
  void walk(Vec2 velocity, double turn);
  /// One cycle with these joint speeds instead of the walk [rad/s].
  void move(const JointArray& speeds);
  /// The referee carries the robot elsewhere (server's field), upright and in the posture it has.
  void carry(const Pose2& place);

  /// Puts the robot on its feet where it is, at once, as no referee would.
  void standUp();

  simulation::LocalRobot& robot() { return robot_; }
  Pose3 torso() const { return robot_.torso().pose; }                 ///< on the server's field
  double time() const { return 0.02 * static_cast<double>(cycle_); }  ///< since the start [s]

private:
  Pose3 headPose();
  void sense();

  Setup setup_;
  simulation::LocalRobot robot_;
  walking::WalkEngine engine_;
  JointVelocityControl control_;
  SyntheticImage vision_;
  simspark::ServerMessage message_;
  long cycle_ = 0;
};

}  // namespace plumbline::test
