#include "simulation/Teams.h"

#include <algorithm>
#include <numeric>

#include "field/TeamSize.h"
#include "simspark/AgentCommand.h"

namespace plumbline::simulation {

std::string Teams::typeProblem(const Team& team, int type) const {
  if (!rules_.on) return {};
  const auto t = static_cast<std::size_t>(type);
  const std::string ofType = "robots of type " + std::to_string(type);
  if (team.types[t] >= rules_.maxOfOne)
    return "there are already " + std::to_string(rules_.maxOfOne) + ' ' + ofType;
  for (std::size_t other = 0; other < team.types.size(); ++other)
    if (other != t && team.types[t] + 1 + team.types[other] > rules_.maxOfTwo)
      return "robots of types " + std::to_string(type) + " and " + std::to_string(other) +
             " would be more than " + std::to_string(rules_.maxOfTwo);
  const int robots = std::accumulate(team.types.begin(), team.types.end(), 0);
  const auto differentTypes =
      static_cast<int>(std::count_if(team.types.begin(), team.types.end(), [](int n) { return n > 0; }));
  if (teamSize - robots <= rules_.minDifferent - differentTypes && team.types[t] > 0)
    return "a full team needs " + std::to_string(rules_.minDifferent) + " types of robots";
  return {};
}

Teams::Place Teams::request(const std::string& team, int unum, int type) {
  if (!simspark::isTeamName(team))
    return {TeamSide::none, 0, "a team's name is " + std::string(simspark::teamNameRule)};
  Team* found = nullptr;
  for (Team& candidate : teams_) {
    if (candidate.name.empty()) candidate.name = team;
    if (candidate.name == team) {
      found = &candidate;
      break;
    }
  }
  const auto refuse = [&](const std::string& why) {
    return Place{TeamSide::none, 0, "team " + team + ": " + why};
  };
  if (!found) return refuse("two other teams play already");
  if (unum == 0)
    for (unum = 1; found->unums.count(unum);) ++unum;
  if (found->unums.size() >= teamSize)
    return refuse("there are already " + std::to_string(teamSize) + " players");
  if (!isUniformNumber(unum))
    return refuse("number " + std::to_string(unum) + " is not 1 to " + std::to_string(teamSize));
  if (found->unums.count(unum)) return refuse("number " + std::to_string(unum) + " is taken");
  if (type < 0 || type >= numSimsparkTypes()) return refuse("there is no robot type " + std::to_string(type));
  if (const std::string problem = typeProblem(*found, type); !problem.empty()) return refuse(problem);
  found->unums.insert(unum);
  ++found->types[static_cast<std::size_t>(type)];
  return {found == &teams_[0] ? TeamSide::left : TeamSide::right, unum, {}};
}

void Teams::release(TeamSide side, int unum, int type) {
  if (side == TeamSide::none) return;
  Team& team = teams_[side == TeamSide::right ? 1 : 0];
  if (team.unums.erase(unum)) --team.types[static_cast<std::size_t>(type)];
}

const std::string& Teams::name(TeamSide side) const { return teams_[side == TeamSide::right ? 1 : 0].name; }

}  // namespace plumbline::simulation
