#pragma once
#include <optional>
#include <vector>

#include "modules/behavior/striker/ActionChoice.h"
#include "modules/behavior/striker/TimeToGoal.h"
#include "tactics/Arrival.h"

namespace plumbline {

/// How a ball is played: a kick, or a dribble, which takes the robot along.
struct BallPlay {
  KickEffect kick;
  bool dribbled = false;
};

/// The other robots at the moment when the ball is played.
struct Receivers {
  std::vector<MovingRobot> mates, opponents;
};

/// What becomes of a ball that goes in one direction [rad].
struct BallCourse {
  double way = 0;   ///< of a ball that goes as far as it means to [m]
  double over = 0;  ///< probability that it goes over a line of the field
  double out = 0;   ///< value of a ball that is out there
  double rest = 0;  ///< value of one that rests before it
  double goal = 0;  ///< probability that it crosses the opponents' line under the bar; not: between the posts
};

/// Works out courses in one situation. What is the same for all of them is worked out once.
class BallCourses {
public:
  BallCourses(const StrikerSituation& situation, const FieldValue& value, const TimeToBallParameters& time,
              const ActionChoiceParameters& parameters);

  /// The others when the ball is played in some seconds. Mates go to their places until then; opponents that
  /// come to the ball come as far as that.
  Receivers receivers(double seconds) const;
  BallCourse course(double direction, const BallPlay& play, const Receivers& receivers) const;
  /// Of a ball that the opponents have where it lies.
  double lost() const { return lost_; }
  /// When the first opponent is at the ball [s].
  double opponentSeconds() const { return opponentSeconds_; }
  /// Value of a second: without others the one measure is when the goal falls.
  double timePrice() const { return timeToGoal_ ? 1 / aloneSeconds : parameters_.timePrice; }

private:
  static constexpr double aloneSeconds = 60;  ///< from the own goal to a goal, about

  double worth(const Vec2& place, double advantage) const;
  double worthOfOut(const Vec2& end, bool overTheirLine) const;
  /// When the first opponent can play the ball [s].
  double opponentAtBall() const;
  /// How far the ball gets before a robot in its way; a high one goes over who lies.
  double freeWay(const Vec2& direction, double reach, bool high) const;

  const StrikerSituation& situation_;
  const FieldValue& value_;
  const TimeToBallParameters& time_;
  const ActionChoiceParameters& parameters_;
  std::optional<TimeToGoal> timeToGoal_{};  ///< of a robot that is alone
  double lost_ = 0, opponentSeconds_ = 0;
};

}  // namespace plumbline
