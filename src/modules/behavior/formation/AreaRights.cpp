#include "modules/behavior/formation/AreaRights.h"

#include <algorithm>
#include <tuple>

namespace plumbline {

std::vector<bool> areaRights(const std::vector<TeamMember>& members, const OwnArea& area, int goalieNumber,
                             double strikerHysteresis, const AreaRightsParameters& parameters) {
  std::vector<bool> rights(members.size(), false);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (members[i].number == goalieNumber)
      rights[i] = true;
    else
      order.push_back(i);
  const auto isThere = [&](std::size_t i) {
    return area.distance(members[i].pose.position) < parameters.there;
  };
  const auto rank = [&](std::size_t i) {
    const TeamMember& member = members[i];
    const bool there = isThere(i);
    const double time = member.timeToBall - (there ? parameters.stays : 0) -
                        (member.role == PlayerRole::striker ? strikerHysteresis : 0);
    return std::tuple(!(there && member.fallen), time, member.number);
  };
  std::ranges::sort(order, {}, rank);
  const auto places = static_cast<std::size_t>(parameters.most - (goalieNumber > 0 ? 1 : 0));
  auto taken = static_cast<std::size_t>(std::ranges::count_if(order, isThere));
  for (std::size_t i = 0; i < std::min(places, order.size()); ++i) {
    if (!isThere(order[i])) {
      if (taken >= places) continue;
      ++taken;
    }
    rights[order[i]] = true;
  }
  return rights;
}

}  // namespace plumbline
