#pragma once
#include <vector>

#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// 0 before 0, 1 after 1, between them the minimum-jerk curve (Flash and Hogan 1985, equation 6).
double smoothStep(double share);

/// A segment's wave for one joint: within -1..1, 0 at both ends.
class Wave {
public:
  /// maxSpeed, maxAcceleration: limits of the joint, in amplitudes per second and per second squared.
  Wave(const Segment& segment, int joint, double maxSpeed, double maxAcceleration);
  double operator()(double t) const;

private:
  struct Tone {
    double hz, phase;
  };
  struct Leg {
    double start, arrival, end, from, to, step;
  };
  void planMultisine();
  void planFast(double maxSpeed, double maxAcceleration);
  double fast(double t) const;

  const Segment& segment_;
  std::uint64_t seed_;
  std::vector<Tone> tones_;
  double scale_ = 1;
  std::vector<Leg> legs_;
};

}  // namespace plumbline::gap
