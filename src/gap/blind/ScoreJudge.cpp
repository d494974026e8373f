#include "gap/blind/ScoreJudge.h"

#include <algorithm>
#include <functional>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

bool names(const BlindAnswer& a) { return a.verdict == "effect" && !a.effects.empty(); }

/// A link may have a joint's name; only joints share motors.
bool sitsAtJoints(const std::string& id) {
  const Effect* effect = findEffect(id);
  return !effect || gap::sitsAtJoints(*effect);
}

bool sameCause(const NamedCause& a, const NamedCause& b) {
  return a.effect == b.effect && a.at == b.at && a.axis == b.axis;
}

}  // namespace

bool BlindJudge::same(const BlindEffect& truth, const NamedCause& named) const {
  if (sameName({truth.effect, truth.at, truth.axis}, named)) return true;
  return std::ranges::any_of(truth.alike, [&](const NamedPlace& other) { return sameName(other, named); });
}

bool BlindJudge::sameName(const NamedPlace& truth, const NamedCause& named) const {
  if (truth.effect != named.effect || truth.axis != named.axis) return false;
  return truth.at == named.at ||
         (sitsAtJoints(truth.effect) && motorOf(robot_, truth.at) == motorOf(robot_, named.at));
}

bool BlindJudge::named(const BlindEffect& truth, const BlindAnswer& a) const {
  return names(a) && std::ranges::any_of(a.effects, [&](const NamedCause& n) { return same(truth, n); });
}

bool BlindJudge::first(const BlindCase& c, const BlindAnswer& a) const {
  return names(a) && same(c.effects.front(), a.effects.front());
}

bool BlindJudge::placeFirst(const BlindCase& c, const BlindAnswer& a) const {
  return names(a) && motorOf(robot_, c.effects.front().at) == motorOf(robot_, a.effects.front().at);
}

bool BlindJudge::amongThree(const BlindCase& c, const BlindAnswer& a) const {
  if (!names(a)) return false;
  std::vector<NamedCause> others;
  for (std::size_t i = 0; i < a.effects.size(); ++i) {
    if (i > 0) others.push_back(a.effects[i]);
    others.insert(others.end(), a.effects[i].rivals.begin(), a.effects[i].rivals.end());
  }
  std::ranges::stable_sort(others, std::greater(), &NamedCause::probability);
  std::vector<NamedCause> three = {a.effects.front()};
  for (const NamedCause& other : others)
    if (three.size() < 3 &&
        std::ranges::none_of(three, [&](const NamedCause& n) { return sameCause(n, other); }))
      three.push_back(other);
  return std::ranges::any_of(three, [&](const NamedCause& n) { return same(c.effects.front(), n); });
}

std::size_t BlindJudge::both(const BlindCase& c, const BlindAnswer& a) const {
  if (!names(a)) return 0;
  std::vector<bool> taken(a.effects.size(), false);
  std::size_t found = 0;
  for (const BlindEffect& e : c.effects)
    for (std::size_t i = 0; i < a.effects.size(); ++i)
      if (!taken[i] && same(e, a.effects[i])) {
        taken[i] = true;
        ++found;
        break;
      }
  return found;
}

double BlindJudge::setF1(const BlindCase& c, const BlindAnswer& a) const {
  if (!names(a)) return 0;
  return 2.0 * static_cast<double>(both(c, a)) / static_cast<double>(c.effects.size() + a.effects.size());
}

bool BlindJudge::right(const BlindCase& c, const BlindAnswer& a) const {
  switch (c.kind) {
    case BlindKind::none:
      return a.verdict == "none";
    case BlindKind::outside:
      return a.verdict == "unknown";
    case BlindKind::mixture:
      return both(c, a) == c.effects.size() && a.effects.size() == c.effects.size();
    default:
      return first(c, a);
  }
}

}  // namespace plumbline::gap
