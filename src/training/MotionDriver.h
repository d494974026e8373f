#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "motion/KeyframePlayer.h"
#include "motion/MotionDefaults.h"
#include "motion/StandUpChoice.h"
#include "motion/Stillness.h"
#include "robot/RobotModel.h"
#include "simulation/world/World.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::training {

/// Moves a robot of a league type by the motions and the walk of config/, as the agent does, a cycle at a
/// time. In which world the robot is, a derived class knows.
class MotionDriver {
public:
  static constexpr double dt = 0.02;  ///< cycle [s]

  virtual ~MotionDriver() = default;
  MotionDriver(const MotionDriver&) = delete;
  MotionDriver& operator=(const MotionDriver&) = delete;

  /// Where a type's configuration is: config/ and the type's own folder.
  static std::vector<std::string> directories(int type);

  /// Throws std::out_of_range for a name that is not there.
  const motion::KeyframeMotion& motion(const std::string& name) const;

  /// Uniform in [low, high]; the same on every machine.
  double random(double low, double high) { return low + (high - low) * (generator_() / 4294967296.0); }
  void seed(unsigned value) { generator_.seed(value); }
  /// Begins the numbers that draw the start of the run with this seed; draw: how many were not as wanted.
  void seedStart(std::uint64_t run, int draw = 0);
  /// Begins those of the run itself.
  void seedRun(std::uint64_t run);

  virtual const simulation::RobotReadings& readings() const = 0;  ///< of this cycle
  virtual Pose3 torsoPose() const = 0;                            ///< the true one
  /// The world's vertical in the torso frame, unit.
  Vec3 up() const { return torsoPose().linear().row(2).transpose(); }
  double tilt() const;  ///< of the torso [rad]
  bool upright() const { return tilt() < motion::uprightTilt; }
  double height() const { return torsoPose().translation().z(); }

  /// One cycle in which the joints go to these targets [rad].
  void step(const JointArray& targets);
  bool lying() const { return tiltedCycles_ * dt >= motion::lyingSeconds; }
  /// The torso does not turn: what a wait to settle waits for.
  bool still() const { return stillness_.still(); }

  /// Plays the motion; false if the robot lay down meanwhile and stopAtFall is set.
  bool play(const motion::KeyframeMotion& motion, bool stopAtFall = false);
  /// Fades from the last motion into the stand and holds it for `seconds` [s]. How long until the torso was
  /// upright for good [s]; `seconds` if it was not.
  double standStill(double seconds);
  /// Walks; false as soon as the robot lies.
  bool walkFor(double seconds, const Vec2& velocity, double turn);
  void beginWalk() { walk.reset(); }
  /// One cycle of the walk, whether it stands or lies; go: false comes to a stop. What the walk wanted.
  walking::WalkOutput walkStep(const Vec2& velocity, double turn, bool go = true);
  /// The same, but the caller moves the robot.
  walking::WalkOutput walkOutput(const Vec2& velocity, double turn, bool go = true);
  /// The motion that the agent's MotionSelector would choose for how the robot lies now; again: the last one
  /// did not keep it on its feet.
  const motion::KeyframeMotion& nextStandUp(bool again = false);

  RobotModel model;
  walking::WalkGaits gaits;
  walking::WalkEngine walk;
  JointArray stand;
  std::vector<motion::KeyframeMotion> motions;
  motion::StandUpParameters standUp;    ///< as config/MotionSelector.yaml and the type's own file have them
  motion::StandUpChoice standUpChoice;  ///< of the motions in `standUp`
  motion::KeyframePlayer player;
  double elapsed = 0;  ///< in motions since it was set to 0 [s]

protected:
  explicit MotionDriver(int type);

  virtual void move(const JointArray& targets) = 0;
  /// The vertical that the walk gets.
  virtual Vec3 feltUp() const { return up(); }
  /// After the robot was put somewhere: nothing of what was before has an effect from now on.
  void forget();
  /// The stand with each joint anywhere within `size` of it [rad], inside the stops.
  JointArray jitter(double size);

private:
  std::mt19937 generator_{1};
  int tiltedCycles_ = 0;
  motion::Stillness stillness_;
};

}  // namespace plumbline::training
