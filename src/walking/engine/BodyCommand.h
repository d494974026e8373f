#pragma once
#include "walking/engine/BodyPosture.h"
#include "walking/estimation/TorsoTilt.h"
#include "walking/planning/SwingTrajectory.h"

namespace plumbline::walking {

/// Joint targets that realise a walk state: legs by the posture, arms, and the feedback of the torso's tilt
/// to hips and ankles.
class BodyCommand {
public:
  explicit BodyCommand(const RobotModel& robot) : posture_(robot) {}

  void reset() { posture_.reset(); }
  /// lean: the torso's planned pitch [rad]; swing, phase: of the foot in the air while one is (stepping);
  /// measured: joint angles, of which the head's move the mass.
  void update(const WalkState& state, bool stepping, const SwingTrajectory& swing, double phase, double lean,
              const TorsoTilt& tilt, const WalkParameters& p, const JointArray& measured);

  const JointArray& angles() const { return angles_; }
  /// The torso's ground frame in the frame of the centre of mass.
  Pose2 torsoOnGround() const { return Pose2(Vec2(posture_.torso().translation().head<2>())); }
  const LegKinematics& leg(Side side) const { return posture_.leg(side); }

private:
  void placeArms(const WalkState& state, const WalkParameters& p);
  TorsoPlacement carriage(const WalkState& state, bool stepping, double phase, double lean,
                          const TorsoTilt& tilt, const WalkParameters& p) const;

  BodyPosture posture_;
  JointArray angles_{};
};

}  // namespace plumbline::walking
