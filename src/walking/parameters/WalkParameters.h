#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "walking/parameters/FeedbackParameters.h"
#include "walking/parameters/PostureParameters.h"
#include "walking/parameters/SpeedParameters.h"
#include "walking/parameters/StepParameters.h"

namespace plumbline::walking {

/// Everything about the walk that a user may set. The defaults make every robot of the league walk slowly;
/// config/robots/*/walking.yaml holds the values found for each.
struct WalkParameters {
  PARAMETERS(WalkParameters)
  PARAMETER_GROUP(PostureParameters, posture, "how the robot carries itself")
  PARAMETER_GROUP(SpeedParameters, speed, "limits of speed and acceleration")
  PARAMETER_GROUP(SprintParameters, sprint, "beyond the omnidirectional limits")
  PARAMETER_GROUP(StepParameters, step, "one step")
  PARAMETER_GROUP(PendulumParameters, model, "pendulum that steps are planned with")
  PARAMETER_GROUP(StartStopParameters, startStop, "from standing to walking and back")
  PARAMETER_GROUP(KickParameters, kick, "kick in a step")
  PARAMETER_GROUP(FeedbackParameters, feedback, "feedback from the torso's angle and turn rate")
  PARAMETER_GROUP(ObservationParameters, observation, "observation of the walk state")
  PARAMETER_GROUP(RecoveryParameters, recovery, "recovery from pushes")
  PARAMETER_GROUP(ContactParameters, contact, "when a step ends by the soles' forces")
  PARAMETER_GROUP(ServoParameters, servo, "position servos, if the platform has them")
  PARAMETER_GROUP(FallParameters, fall, "falls that can no longer be stopped")
  PARAMETER_GROUP(ArmParameters, arms, "how the arms are held")
  PARAMETER_GROUP(OdometryParameters, odometry, "the way walked")

  /// Throws std::invalid_argument "walking parameter PATH must be within [A, B], not V" for the first one out
  /// of its range.
  void check() const;
};

/// One of the walk's parameters, found by its path once for quick access.
struct WalkParameter {
  std::string path;  ///< "step.duration"
  const Parameter* declared;
  std::size_t offset;  ///< in WalkParameters
  bool blends;         ///< may differ between the gaits

  double& of(WalkParameters& p) const;
  double of(const WalkParameters& p) const;
};

/// Every parameter of the walk, in the order of their declaration.
const std::vector<WalkParameter>& walkParameters();
/// Null if there is none of that path.
const WalkParameter* findWalkParameter(const std::string& path);
/// Throws std::invalid_argument "no walking parameter PATH".
const WalkParameter& walkParameter(const std::string& path);

}  // namespace plumbline::walking
