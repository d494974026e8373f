#pragma once
#include <vector>

#include "field/TeamSize.h"
#include "parameters/Parameter.h"
#include "simulation/referee/RuleRegistry.h"

namespace plumbline::simulation {

/// The numbers of all rules, in seconds, metres and radians. The values here, and in the rules' own files,
/// are the league's (rcssserver3d 0.7.3, naosoccersim.rb). Here are the sections of doc/reference/rules.yaml
/// that more than one rule needs; a rule's own parameters are declared in its file, see of().
struct Rules {
  PARAMETERS(Rules)

  struct Time {
    PARAMETERS(Time)
    PARAMETER(double, half, 300, "s", Range(0.02, 1e6), "length of a half")
    PARAMETER(double, goalPause, 3, "s", Range::atLeast(0), "after a goal, until the kick-off")
    PARAMETER(double, kickPause, 1, "s", Range::atLeast(0), "after the ball went out, until it is laid down")
    PARAMETER(double, dropBall, 15, "s", Range::atLeast(0),
              "a restart that no player takes; 0: it waits for ever")
    PARAMETER(bool, singleHalf, false, "", {}, "the game is over after the first half")
    PARAMETER(bool, changeSides, false, "", {}, "teams change ends for the second half")
    PARAMETER(bool, quitAfterGame, false, "", {}, "the simulator ends ten seconds after the game")
    PARAMETER(double, waitForKickOff, 30, "s", Range::atLeast(0), "sent to monitors only")
    bool operator==(const Time&) const = default;
  };
  PARAMETER_GROUP(Time, time, "the clock")

  struct KickOff {
    PARAMETERS(KickOff)
    PARAMETER(double, after, -1, "s", Range::atLeast(-1),
              "by itself so long after BeforeKickOff began; below 0: a trainer does it")
    PARAMETER(bool, byLot, false, "", {}, "the team that begins the game is random; otherwise the left team")
    PARAMETER(bool, ownHalf, true, "", {}, "players in the other half are put back")
    PARAMETER(bool, noDirectGoal, true, "", {},
              "none before another player, or the taker's team outside the ring, touched the ball")
    bool operator==(const KickOff&) const = default;
  };
  PARAMETER_GROUP(KickOff, kickOff, "the start of a half, and after a goal")

  struct Restarts {
    PARAMETERS(Restarts)
    PARAMETER(bool, keepDistance, true, "", {}, "opponents too near are moved away")
    PARAMETER(double, distance, 2, "m", Range::atLeast(0), "that they must keep; also the ring at kick-off")
    PARAMETER(double, moveDistance, 2.5, "m", Range::atLeast(0), "at which they are put")
    PARAMETER(double, repel, 0.5, "m", Range::atLeast(0),
              "own players are moved so far from the ball as it is laid down")
    PARAMETER(double, goalKick, 1, "m", Range(0.05, 10), "of the ball from the goal line")
    PARAMETER(bool, doubleTouch, true, "", {}, "a player that took it must not be the next to touch the ball")
    PARAMETER(bool, noIndirectGoal, true, "", {},
              "nor may an indirect kick, or an own goal of a direct one, count")
    bool operator==(const Restarts&) const = default;
  };
  PARAMETER_GROUP(Restarts, restarts, "kick-in, corner kick, goal kick, free kick")

  struct Pass {
    PARAMETERS(Pass)
    PARAMETER(bool, on, true, "", {}, "players may ask for pass mode")
    PARAMETER(double, maxBallSpeed, 0.05, "m/s", Range::atLeast(0), "fastest ball for which it is given")
    PARAMETER(double, maxBallDistance, 0.5, "m", Range::atLeast(0), "of the player who asks")
    PARAMETER(double, minOpponentDistance, 1, "m", Range::atLeast(0), "of opponents from the ball")
    PARAMETER(double, duration, 4, "s", Range::atLeast(0), "until play is on for all")
    PARAMETER(double, scoreWait, 10, "s", Range::atLeast(0),
              "no goal so long after it, unless a team mate touched the ball outside its circle")
    PARAMETER(double, retryWait, 3, "s", Range::atLeast(0), "until the team may ask again")
    bool operator==(const Pass&) const = default;
  };
  PARAMETER_GROUP(Pass, pass, "pass mode")

  struct IllegalDefence {
    PARAMETERS(IllegalDefence)
    PARAMETER(bool, on, true, "", {}, "whether it is a foul")
    PARAMETER(int, maxInOwnArea, 3, "", Range(0, teamSize), "players of a team in their penalty area")
    PARAMETER(bool, putOutside, false, "", {}, "of the field, instead of the area")
    bool operator==(const IllegalDefence&) const = default;
  };
  PARAMETER_GROUP(IllegalDefence, illegalDefence, "too many players in their own penalty area")

  struct Moves {
    PARAMETERS(Moves)
    PARAMETER(double, foulHold, 0.5, "s", Range::atLeast(0),
              "an offender is held in the air before it is put outside the field")
    PARAMETER(double, agentRadius, 0.4, "m", Range::atLeast(0), "kept free around a player that is moved")
    PARAMETER(int, attempts, 100, "", Range(0, 10000),
              "number of places tried to put a player to a free place; 0: any place")
    PARAMETER(bool, startAnywhere, false, "", {}, "beams may go into the other half")
    bool operator==(const Moves&) const = default;
  };
  PARAMETER_GROUP(Moves, moves, "where the referee puts players")

  struct Types {
    PARAMETERS(Types)
    PARAMETER(bool, on, true, "", {}, "whether a team must have robots of several types")
    PARAMETER(int, maxOfOne, 7, "", Range(0, teamSize), "robots of one type")
    PARAMETER(int, minDifferent, 3, "", Range(1, 5), "types in a full team")
    PARAMETER(int, maxOfTwo, 9, "", Range(0, teamSize), "of any two types together")
    bool operator==(const Types&) const = default;
  };
  PARAMETER_GROUP(Types, types, "robots of a team")

  /// The league's numbers.
  Rules();

  /// The parameters of the rule of that class: rules.of<Charging>().on = false.
  template <typename R>
  typename R::Parameters& of() {
    return *static_cast<typename R::Parameters*>(find(R::Parameters::parameterList()).owner());
  }
  template <typename R>
  const typename R::Parameters& of() const {
    return const_cast<Rules*>(this)->of<R>();
  }
  /// Of all rules that are linked, in the order of registeredRules().
  std::vector<RuleParameters> ofRules;

  bool operator==(const Rules&) const = default;

private:
  RuleParameters& find(const ParameterList& list);
};

}  // namespace plumbline::simulation
