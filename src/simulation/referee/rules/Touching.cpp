#include "simulation/referee/rules/Touching.h"

#include <algorithm>
#include <numeric>

#include "simulation/referee/Reposition.h"

namespace plumbline::simulation {

namespace {

using Group = std::vector<Participant*>;

/// The groups of this cycle, and the one each participant is in.
class Groups {
public:
  explicit Groups(Match& match) {
    std::vector<std::size_t> root(match.participants().size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](std::size_t i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    first_ = match.participants().data();
    for (const RobotContact& contact : match.contacts) {
      const Participant *a = match.find(contact.a), *b = match.find(contact.b);
      if (!a || !b) continue;
      const std::size_t ra = find(index(*a)), rb = find(index(*b));
      root[std::max(ra, rb)] = std::min(ra, rb);
    }
    groups_.resize(root.size());
    for (Participant& player : match.participants()) {
      const std::size_t group = find(index(player));
      groups_[group].push_back(&player);
      groupOf_.push_back(group);
    }
  }

  Group& of(const Participant& player) { return groups_[groupOf_[index(player)]]; }

private:
  std::size_t index(const Participant& player) const { return static_cast<std::size_t>(&player - first_); }
  const Participant* first_ = nullptr;
  std::vector<Group> groups_;
  std::vector<std::size_t> groupOf_;
};

void punish(Match& match, Participant& player, const Vec2& middle) {
  const bool outside = match.rules.of<Touching>().putOutside;
  player.commit(Foul::Kind::touching, !outside);
  if (outside) return;
  const Vec2 way = player.place() - middle;
  const Vec2 direction = way.norm() > 0 ? Vec2(way.normalized()) : Vec2(sign(player.side), 0);
  Vec3 place = player.torso.pose.translation();
  place.head<2>() += direction * match.rules.moves.agentRadius;
  moveSafely(match, player, place);
}

void shuffle(Match& match, Group& group) {
  for (std::size_t i = group.size(); i > 1; --i)
    std::swap(
        group[i - 1],
        group[std::min(i - 1, static_cast<std::size_t>(match.random.uniform(0, static_cast<double>(i))))]);
}

/// The player that must leave a group that `player` made, or found, too large; null: nobody.
Participant* culprit(Match& match, Participant& player, Group group, Vec2& middle) {
  shuffle(match, group);
  int mates = 0, innocent = 0;
  middle.setZero();
  Participant *mate = nullptr, *other = nullptr;
  for (Participant* member : group) {
    if (member->offends()) continue;
    ++innocent;
    middle += member->place();
    if (member->side == player.side) ++mates;
    if (!member->goalie() || match.rules.of<Touching>().maxGroup < 2)
      (member->side == player.side ? mate : other) = member;
  }
  if (innocent <= match.rules.of<Touching>().maxGroup) return nullptr;
  middle /= innocent;
  if (mates < static_cast<int>(group.size()) - mates) return other;
  return player.goalie() && match.rules.of<Touching>().maxGroup > 1 ? mate : &player;
}

void judge(Match& match, Groups& groups, TeamSide side, bool onlyNewcomers) {
  const auto tooLarge = [&](const Group& group) {
    return static_cast<int>(group.size()) > match.rules.of<Touching>().maxGroup;
  };
  for (Participant* player : match.inRandomOrder(side)) {
    Group& group = groups.of(*player);
    if (player->offends()) {
      if (group.size() > 1) std::erase(group, player);
      continue;
    }
    if ((onlyNewcomers && player->lastGroupSize > 1) || !tooLarge(group)) continue;
    Vec2 middle;
    if (Participant* guilty = culprit(match, *player, group, middle)) {
      punish(match, *guilty, middle);
      std::erase(group, guilty);
    }
  }
  if (!onlyNewcomers) return;
  const bool anyLeft = std::any_of(match.participants().begin(), match.participants().end(),
                                   [&](auto& p) { return p.side == side && tooLarge(groups.of(p)); });
  if (anyLeft) judge(match, groups, side, false);
}

}  // namespace

MAKE_RULE(Touching, "touching", 150)

void Touching::judgeGroups(Match& match) {
  if (!match.rules.of<Touching>().on) return;
  if (match.contacts.empty()) {
    for (Participant& player : match.participants()) player.lastGroupSize = 1;
    return;
  }
  Groups groups(match);
  for (const TeamSide side : match.sidesInRandomOrder()) judge(match, groups, side, true);
  for (Participant& player : match.participants())
    player.lastGroupSize = static_cast<int>(groups.of(player).size());
}

}  // namespace plumbline::simulation
