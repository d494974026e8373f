#pragma once
#include <array>
#include <set>
#include <string>

#include "robot/RobotModel.h"
#include "simspark/TeamSide.h"

namespace plumbline::simulation {

using simspark::TeamSide;

/// Who plays with which number and which robot: the league's limits for a team.
class Teams {
public:
  static constexpr int maxPlayers = 11;
  static constexpr int maxOfOneType = 7;
  static constexpr int minTypes = 3;       ///< different types in a full team
  static constexpr int maxOfTwoTypes = 9;  ///< robots of any two types together

  struct Place {
    TeamSide side = TeamSide::none;
    int unum = 0;
    std::string problem;  ///< why there is no place: one line, else empty
  };

  /// A place in the team of that name (the first name is the left team, the second the right) for a robot of
  /// a type 0..4; unum 0 asks for the next free number.
  Place request(const std::string& team, int unum, int type);
  void release(TeamSide side, int unum, int type);
  /// Empty for a side nobody plays on yet.
  const std::string& name(TeamSide side) const;

private:
  struct Team {
    std::string name;
    std::set<int> unums;
    std::array<int, numSimsparkTypes> types{};
  };
  static std::string typeProblem(const Team& team, int type);
  std::array<Team, 2> teams;
};

}  // namespace plumbline::simulation
