#pragma once
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "simspark/LeagueRobots.h"
#include "simspark/TeamSide.h"
#include "simulation/referee/Rules.h"

namespace plumbline::simulation {

using simspark::TeamSide;

/// Who plays with which number and which robot, within the league's limits for a team of different robots.
class Teams {
public:
  explicit Teams(const Rules::Types& rules = {}) : rules_(rules) {}

  struct Place {
    TeamSide side = TeamSide::none;
    int unum = 0;
    std::string problem;  ///< why there is no place: one line, else empty
  };

  /// A place in the team of that name (the first name is the left team, the second the right) for a robot of
  /// a type; unum 0 asks for the next free number.
  Place request(const std::string& team, int unum, int type);
  void release(TeamSide side, int unum, int type);
  /// Empty for a side nobody plays on yet.
  const std::string& name(TeamSide side) const;
  /// The teams change ends.
  void swapSides() { std::swap(teams_[0], teams_[1]); }

private:
  struct Team {
    std::string name;
    std::set<int> unums;
    std::vector<int> types = std::vector<int>(simsparkRobots().size());  ///< robots of each
  };
  std::string typeProblem(const Team& team, int type) const;
  Rules::Types rules_;
  std::array<Team, 2> teams_;
};

}  // namespace plumbline::simulation
