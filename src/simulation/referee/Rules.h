#pragma once
#include <optional>

namespace plumbline::simulation {

/// The numbers of all rules, in seconds, metres and radians. What stands here, and in config/rules.yaml, is
/// the league's (rcssserver3d 0.7.3, naosoccersim.rb); a rule whose `on` is false is not applied.
struct Rules {
  struct Time {
    double half = 300;
    double goalPause = 3;
    double kickPause = 1;        ///< after the ball went out, until it is laid down
    double dropBall = 15;        ///< of a restart nobody takes; 0: it waits for ever
    bool singleHalf = false;     ///< the game is over after the first half
    bool changeSides = false;    ///< teams change ends for the second half
    bool quitAfterGame = false;  ///< the simulator ends ten seconds after the game
    double waitForKickOff = 30;  ///< told to monitors only
    bool operator==(const Time&) const = default;
  } time;

  struct KickOff {
    std::optional<double>
        after;            ///< by itself so long after coming to BeforeKickOff; nothing: a trainer does it
    bool byLot = false;   ///< who begins the game; otherwise the left team
    bool ownHalf = true;  ///< players who stand in the other half are put back
    bool noDirectGoal = true;  ///< none before another player, or the taker's team outside the ring, touched
    bool operator==(const KickOff&) const = default;
  } kickOff;

  struct Restarts {
    bool keepDistance = true;   ///< opponents too near to a restart are moved away
    double distance = 2;        ///< that they must keep; also the ring at kick-off
    double moveDistance = 2.5;  ///< at which they are put
    double repel = 0.5;       ///< own players nearer to the ball are moved so far from it as it is laid down
    double goalKick = 1;      ///< of the ball from the goal line
    bool doubleTouch = true;  ///< who took it must not be the next to touch the ball
    bool noIndirectGoal = true;  ///< nor may an indirect kick, or an own goal of a direct one, count
    bool operator==(const Restarts&) const = default;
  } restarts;

  struct Goals {
    bool on = true;
    bool operator==(const Goals&) const = default;
  } goals;

  struct BallOut {
    bool on = true;  ///< kick-in, corner kick, goal kick
    bool operator==(const BallOut&) const = default;
  } ballOut;

  struct Pass {
    bool on = true;
    double maxBallSpeed = 0.05;
    double maxBallDistance = 0.5;  ///< of the player who asks
    double minOpponentDistance = 1;
    double duration = 4;
    double scoreWait =
        10;  ///< no goal so long after it, unless a team mate touched the ball outside its circle
    double retryWait = 3;
    bool operator==(const Pass&) const = default;
  } pass;

  struct Incapable {
    bool on = true;
    double notStanding = 30, onGround = 15;
    double goalieNotStanding = 60, goalieOnGround = 30;
    bool operator==(const Incapable&) const = default;
  } incapable;

  struct IllegalDefence {
    bool on = true;
    int maxInOwnArea = 3;
    bool putOutside = false;  ///< of the field, instead of the area
    bool operator==(const IllegalDefence&) const = default;
  } illegalDefence;

  /// Off in the league since 2017, by distances of 0.
  struct Crowding {
    bool on = false;
    double minOpponent = 0.8;  ///< of the nearest opponent from the ball, for the rule to hold
    double minSecond = 0.4, minThird = 1;
    bool operator==(const Crowding&) const = default;
  } crowding;

  struct Touching {
    bool on = true;
    int maxGroup = 2;
    bool putOutside = false;
    bool operator==(const Touching&) const = default;
  } touching;

  struct Charging {
    bool on = true;
    double minSpeed = 0.4;
    double minBallAngle = 0.5235987755982988;        ///< of the speed from the ball: 30 degrees
    double minDistanceDifference = 0.05;             ///< from the ball, of the two players
    double minAngleDifference = 0.2617993877991494;  ///< of their speeds from each other: 15 degrees
    double immunity = 1;                             ///< after a touch of the ball
    double minInterval = 0.2;                        ///< between two collisions that are judged
    double maxBallDistance = 1;  ///< of one of the two, for their way to the ball to matter
    double minCollisionBallDistance = 0.1;
    double minCollisionSpeed = 0.2;
    bool operator==(const Charging&) const = default;
  } charging;

  struct SelfCollision {
    bool on = true;
    double tolerance = 0.04;  ///< how far the boxes of two limbs may sink into each other
    double frozen = 1;        ///< joints of such limbs take no speed
    double thaw = 2;          ///< and cannot be frozen again
    bool putOutside = false;  ///< instead of freezing
    double cooldown = 10;     ///< between two such
    bool operator==(const SelfCollision&) const = default;
  } selfCollision;

  struct Moves {
    double foulHold = 0.5;  ///< an offender hangs in the air before being put beside the field
    double agentRadius = 0.4;
    int attempts = 100;          ///< places tried to put a player where nobody stands; 0: any will do
    bool startAnywhere = false;  ///< beams may go into the other half
    bool operator==(const Moves&) const = default;
  } moves;

  /// Robots of one team.
  struct Types {
    bool on = true;
    int maxOfOne = 7;
    int minDifferent = 3;  ///< in a full team
    int maxOfTwo = 9;      ///< of any two types together
    bool operator==(const Types&) const = default;
  } types;

  bool operator==(const Rules&) const = default;
};

}  // namespace plumbline::simulation
