#pragma once
#include <cstdint>
#include <vector>

#include "math/Random.h"
#include "modules/modeling/selflocator/PoseBelief.h"
#include "modules/modeling/selflocator/PoseProposals.h"

namespace plumbline {

/// Where the robot is on the field: an augmented Monte Carlo localisation (Thrun, Burgard and Fox,
/// "Probabilistic Robotics", table 8.3) whose particles are Gaussian beliefs that each take the image in
/// closed form, and whose random particles are drawn from the image itself (sensor resetting).
class PoseFilter {
public:
  struct Parameters {
    int particles = 30;
    std::uint64_t seed = 1;
    double slowRate = 0.02;              ///< of the long-term mean of the image's likelihood, per image
    double fastRate = 0.3;               ///< of the short-term mean
    double stepShare = 0.05;             ///< odometry's error as a share of the way [-]
    double stepNoise = 0.0015;           ///< and per cycle [m]
    double turnShare = 0.01;             ///< error of the turn [-]
    double turnNoise = 0.0003;           ///< and per cycle [rad]
    double validDeviation = 0.3;         ///< of the position, for an estimate to be valid [m]
    double validHeadingDeviation = 0.2;  ///< [rad]
  };

  struct Estimate {
    Pose2 pose;                     ///< T_field_robot
    double positionDeviation = 10;  ///< [m]
    double headingDeviation = 3;    ///< [rad]
    bool valid = false;
  };

  PoseFilter(const FieldMap& map, const Parameters& parameters);
  PoseFilter(const PoseFilter&) = delete;  // its parts refer to its map
  PoseFilter& operator=(const PoseFilter&) = delete;

  /// Forgets the pose; the generator goes on.
  void reset();
  /// The ground frame moved by step (T_before_now). uncertain: the odometry may be off by much more than
  /// usual (a robot that falls or lies).
  void predict(const Pose2& step, bool uncertain = false);
  /// An image.
  void update(const FieldView& view);
  const Estimate& estimate() const { return estimate_; }
  /// Particles replaced by poses from images since the start.
  int resets() const { return resets_; }

private:
  struct Particle {
    PoseBelief belief;
    double weight;
  };
  void start(const FieldView& view);
  void resample();
  void resetFromImage(const FieldView& view, double share);
  void estimatePose();

  const FieldMap map;
  Parameters parameters;
  Random random;
  PoseProposals proposals;
  std::vector<Particle> particles, resampled;
  double slow = 0, fast = 0;
  int resets_ = 0;
  Estimate estimate_;
};

}  // namespace plumbline
