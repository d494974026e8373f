#include "modules/behavior/formation/TeamPlan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modules/behavior/formation/Assignment.h"
#include "representations/behavior/PlayerRole.h"

namespace plumbline {
namespace {

constexpr double farTime = 1e3;  ///< for members beyond the table's places [s]

/// Who goes to the ball, as an index; negative: nobody. may: of each member, whether it can be this one.
int chooseStriker(const std::vector<TeamMember>& members, const std::vector<bool>& may, bool atGoal,
                  const TeamPlanParameters& parameters) {
  int striker = -1;
  double best = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const TeamMember& member = members[i];
    const bool isGoalie = member.number == parameters.goalieNumber && members.size() > 1;
    if ((isGoalie && !atGoal) || !may[i]) continue;
    double time = member.timeToBall;
    if (member.role == PlayerRole::striker)
      time -= parameters.strikerHysteresis;
    else if (isGoalie)
      time += parameters.goalieWaits;
    if (striker >= 0 && time >= best) continue;
    striker = static_cast<int>(i);
    best = time;
  }
  return striker;
}

double timeToPlace(const TeamMember& member, const Vec2& place, const TimeToBallParameters& time,
                   const TeamPlanParameters& parameters) {
  return (member.pose.position - place).norm() / parameters.supporterSpeed + (member.fallen ? time.getUp : 0);
}

void placeSupporters(const std::vector<TeamMember>& members, const std::vector<std::size_t>& supporters,
                     const std::vector<Vec2>& places, const TimeToBallParameters& time,
                     const TeamPlanParameters& parameters, std::vector<int>& roles) {
  const std::size_t taken = std::min(places.size(), supporters.size());
  std::vector<std::vector<double>> cost(supporters.size(), std::vector<double>(supporters.size(), farTime));
  for (std::size_t i = 0; i < supporters.size(); ++i)
    for (std::size_t j = 0; j < taken; ++j) {
      const TeamMember& member = members[supporters[i]];
      const bool stays = member.role == PlayerRole::supporter + static_cast<int>(j);
      cost[i][j] =
          timeToPlace(member, places[j], time, parameters) - (stays ? parameters.placeHysteresis : 0.0);
    }
  const std::vector<int> jobs = assign(cost);
  for (std::size_t i = 0; i < supporters.size(); ++i)
    roles[supporters[i]] =
        jobs[i] < static_cast<int>(taken) ? PlayerRole::supporter + jobs[i] : PlayerRole::none;
}

}  // namespace

TeamPlan planTeam(std::vector<TeamMember> members, const Vec2& ball, const FieldSize& field,
                  const std::vector<Vec2>& places, const TimeToBallParameters& time,
                  const TeamPlanParameters& parameters) {
  // In the order of their numbers, whatever order they were heard in.
  std::vector<std::size_t> order(members.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return members[i].number; });
  std::vector<TeamMember> sorted;
  for (const std::size_t i : order) sorted.push_back(members[i]);

  TeamPlan plan;
  std::vector<int> roles(sorted.size(), PlayerRole::none);
  const OwnArea area(field);
  const std::vector<bool> rights =
      areaRights(sorted, area, parameters.goalieNumber, parameters.strikerHysteresis, parameters.area);
  const std::vector<bool> anybody(sorted.size(), true);
  const bool atGoal = (ball - Vec2(-field.length / 2, 0)).norm() < parameters.goalieReach;
  int striker = -1;
  if (area.distance(ball) < parameters.areaReach) striker = chooseStriker(sorted, rights, atGoal, parameters);
  if (striker < 0) striker = chooseStriker(sorted, anybody, atGoal, parameters);
  std::vector<std::size_t> supporters;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (static_cast<int>(i) == striker) {
      roles[i] = PlayerRole::striker;
      plan.strikerNumber = sorted[i].number;
    } else if (sorted[i].number == parameters.goalieNumber) {
      roles[i] = PlayerRole::goalie;
    } else {
      supporters.push_back(i);
    }
  }
  placeSupporters(sorted, supporters, places, time, parameters, roles);
  plan.roles.resize(members.size());
  plan.rights.resize(members.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    plan.roles[order[i]] = roles[i];
    plan.rights[order[i]] = rights[i];
  }
  return plan;
}

}  // namespace plumbline
