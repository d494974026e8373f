#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OppInfo.h"
#include "representations/modeling/OtherRobots.h"
#include "robot/ExpectedRobot.h"

namespace plumbline {

MODULE(OppAnalyzer)
  REQUIRES(FrameInfo)
  REQUIRES(BallPos)
  REQUIRES(OtherRobots)
  PROVIDES(OppInfo)
  PARAMETER(double, expectedSpeed, expectedWalkSpeed, "m/s", Range(0.05, 3),
            "walk of opponents of whom nothing was seen")
  PARAMETER(double, expectedSeconds, 20, "s", Range(0.1, 1e4), "of walking that this expectation counts for")
  PARAMETER(double, walks, 0.3, "m/s", Range(0, 3), "a slower opponent does not walk to a place")
  PARAMETER(double, seenSeconds, 0.3, "s", Range(0.01, 10), "speeds count of opponents seen within this time")
  PARAMETER(double, getUp, expectedGetUpSeconds, "s", Range(0, 60), "of a fallen opponent")
  PARAMETER(double, reach, 0.4, "m", Range(0.05, 2), "a robot this near to the ball may have kicked it")
  PARAMETER(double, kickSpeed, 1.5, "m/s", Range(0.1, 20), "a ball that is faster was kicked")
END_MODULE

/// Learns how fast the opponents walk and how far they kick, and says when the first of them is at the ball
/// (Seekircher 2015, A.3).
class OppAnalyzer : public OppAnalyzerBase {
public:
  void update(OppInfo* theOppInfo) override;

private:
  void learnSpeed(OppInfo& info);
  void findFirst(OppInfo& info) const;
  void watchKick(OppInfo& info);
  void draw(const OppInfo& info) const;

  double walkedWay_ = 0, walkedSeconds_ = 0;  ///< of opponents, as seen [m, s]
  double touchedByThem_ = -1;                 ///< when only opponents were at the ball last [s]
};

}  // namespace plumbline
