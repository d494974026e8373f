#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Puts the ball and number 1 of the left team to given places at a half's kick-off; the robot keeps its
/// orientation, the ball may have a speed. For fixed starts that are tried repeatedly. Off in the league.
class StartPlace : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, false, "", {}, "not in the league: the ball lies in the middle")
    PARAMETER(double, x, 0, "m", Range(-100, 100), "of the ball, towards the right goal")
    PARAMETER(double, y, 0, "m", Range(-100, 100), "of the ball, to the left as the left team looks")
    PARAMETER(double, speedX, 0, "m/s", Range(-100, 100), "of the ball, as a shot, towards the right goal")
    PARAMETER(double, speedY, 0, "m/s", Range(-100, 100), "of it, to the left")
    PARAMETER(double, speedZ, 0, "m/s", Range(0, 100), "of it, up")
    PARAMETER(double, robotX, 0, "m", Range(-100, 100), "of the left team's number 1, likewise")
    PARAMETER(double, robotY, 0, "m", Range(-100, 100), "of it")
  };
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
