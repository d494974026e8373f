#pragma once
#include <cstdint>
#include <vector>

#include "math/Random.h"
#include "modules/modeling/selflocator/PoseBelief.h"
#include "modules/modeling/selflocator/PoseProposals.h"
#include "parameters/Parameter.h"
#include "representations/modeling/Odometry.h"

namespace plumbline {

/// Estimates the robot's pose on the field by augmented Monte Carlo localisation (Thrun, Burgard and Fox,
/// "Probabilistic Robotics", table 8.3). Each particle is a Gaussian belief that an image updates in closed
/// form. Random particles are drawn from the image itself (sensor resetting).
class PoseFilter {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(int, particles, 30, "", Range(1, 10000), "number of particles, each a Gaussian")
    PARAMETER(unsigned, seed, 1, "", Range(), "of the random numbers")
    PARAMETER(double, slowRate, 0.02, "", Range(0, 1),
              "rate per image of the long-term mean of the likelihood of an image")
    PARAMETER(double, fastRate, 0.3, "", Range(0, 1),
              "rate per image of the short-term mean; if it is below the long-term mean, particles are drawn "
              "from the image")
    PARAMETER(double, stepShare, odometryErrorShare, "", Range(0, 1),
              "error of the odometry, share of the distance walked")
    PARAMETER(double, stepNoise, 0.0015, "m", Range(1e-6, 1), "error of the odometry in each cycle")
    PARAMETER(double, turnShare, 0.01, "", Range(0, 1), "error of the turn, share of the turn")
    PARAMETER(double, turnNoise, 0.0003, "rad", Range(1e-6, 1), "error of the turn in each cycle")
    PARAMETER(double, validDeviation, 0.3, "m", Range(0, 100),
              "largest standard deviation of the position of a valid pose")
    PARAMETER(double, validHeadingDeviation, 0.2, "rad", Range(0, 10),
              "largest standard deviation of the heading of a valid pose")
  };

  struct Estimate {
    Pose2 pose;                     ///< T_field_robot
    double positionDeviation = 10;  ///< [m]
    double headingDeviation = 3;    ///< [rad]
    bool valid = false;
  };

  struct Particle {
    PoseBelief belief;
    double weight;
  };

  PoseFilter(const FieldMap& map, const Parameters& parameters);
  PoseFilter(const PoseFilter&) = delete;  // its parts refer to its map
  PoseFilter& operator=(const PoseFilter&) = delete;

  /// The state stays; the number of particles changes with the next reset.
  void setParameters(const Parameters& changed);
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
  std::size_t particleCount() const { return particles_.size(); }
  /// What is believed; for drawings.
  const std::vector<Particle>& believed() const { return particles_; }

private:
  void start(const FieldView& view);
  void resample();
  void resetFromImage(const FieldView& view, double share);
  void estimatePose();

  const FieldMap map_;
  Parameters parameters_;
  Random random_;
  PoseProposals proposals_;
  std::vector<Particle> particles_, resampled_;
  double slow_ = 0, fast_ = 0;
  int resets_ = 0;
  Estimate estimate_;
};

}  // namespace plumbline
