#include "gap/blind/Draw.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "gap/blind/OutsideDrives.h"
#include "gap/effects/Effects.h"
#include "gap/record/ExcitationFile.h"

namespace plumbline::gap {

namespace {

using Where = DrawRange::Where;
using Unit = DrawRange::Unit;

/// An effect as it is drawn.
struct Range {
  std::string_view id;
  DrawRange drawing;
};

/// What the library has to be drawn, in its order.
std::vector<Range> libraryRanges() {
  std::vector<Range> ranges;
  for (const Effect* effect : effects())
    if (effect->drawing.where != Where::nowhere) ranges.push_back({effect->id, effect->drawing});
  return ranges;
}

/// What has a look-alike in the library: each has been taken for the other.
std::vector<Range> hardRanges() {
  std::vector<const Effect*> list = effects();
  std::erase_if(list, [](const Effect* effect) {
    return !findEffect(effect->alike.id) || effect->drawing.where == Where::nowhere;
  });
  std::ranges::stable_sort(list, {}, [](const Effect* effect) { return effect->alike.turn; });
  std::vector<Range> ranges;
  for (const Effect* effect : list) ranges.push_back({effect->id, effect->drawing});
  return ranges;
}

template <class List>
auto pick(const List& list, Random& random) {
  return list[std::min(list.size() - 1,
                       static_cast<std::size_t>(random.uniform() * static_cast<double>(list.size())))];
}

/// How it is drawn; null where nobody draws it.
const DrawRange* drawingOf(std::string_view id) {
  if (const Effect* effect = findEffect(id))
    return effect->drawing.where == Where::nowhere ? nullptr : &effect->drawing;
  const OutsideEffect* outside = findOutsideEffect(id);
  return outside ? &outside->drawing : nullptr;
}

std::vector<std::string> placesFor(const Mechanism& robot, Where where) {
  std::vector<std::string> places;
  if (where == Where::joint || where == Where::jointOrAll) {
    for (const Mechanism::Joint& joint : robot.joints)
      if (joint.driver < 0) places.push_back(joint.name);
  } else if (where == Where::link) {
    const double lightest = std::min(0.07, robot.totalMass() / 60);  // [kg]; below that a link is a bracket
    for (std::size_t l = 1; l < robot.links.size(); ++l)
      if (robot.links[l].mass > lightest) places.push_back(robot.links[l].name);
  } else if (where == Where::foot) {
    for (const Mechanism::Foot& foot : robot.feet) places.push_back(foot.name);
  } else {
    places.emplace_back(where == Where::imu ? "imu" : where == Where::ground ? "ground" : "*");
  }
  if (places.empty())
    throw std::invalid_argument(robot.name + " has no place for some effects of a blind set");
  return places;
}

BlindEffect drawOne(const Mechanism& robot, const Range& what, Random& random) {
  const DrawRange& range = what.drawing;
  BlindEffect e;
  e.effect = what.id;
  const std::vector<std::string> places = placesFor(robot, range.where);
  e.at = range.where == Where::jointOrAll && random.uniform() < 0.5 ? "*" : pick(places, random);
  if (!range.axes.empty()) e.axis = std::string(1, pick(range.axes, random));
  const bool second = range.high2 > 0 && random.uniform() < 0.5;
  e.value = second ? random.uniform(range.low2, range.high2) : random.uniform(range.low, range.high);
  if (const int joint = robot.jointIndex(e.at); joint >= 0) {
    const Mechanism::Joint& j = robot.joints[static_cast<std::size_t>(joint)];
    if (range.unit == Unit::torque) e.value *= j.maxTorque;
    if (range.unit == Unit::perTorque) e.value /= j.maxTorque;
    if (range.unit == Unit::damping) e.value *= j.servo.kd + j.damping;
  }
  if (range.bothSigns && random.uniform() < 0.5) e.value = -e.value;
  if (const DrawRange::Choice& choice = range.choice; !choice.name.empty())
    e.how[std::string(choice.name)] = random.uniform() < 0.5 ? choice.first : choice.second;
  return e;
}

void shuffle(auto& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i)
    std::swap(list[i - 1], list[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
}

}  // namespace

std::vector<BlindKind> drawKinds(const DrawOptions& options) {
  const std::size_t n = options.cases;
  std::vector<BlindKind> kinds;
  kinds.insert(kinds.end(), (n + 2) / 5, BlindKind::none);
  kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::mixture);
  if (options.outside) kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::outside);
  kinds.insert(kinds.end(), (n + 3) / 7, BlindKind::hard);
  kinds.resize(std::max(n, kinds.size()), BlindKind::single);
  Random random(options.seed ^ 0x6b1d);
  shuffle(kinds, random);
  kinds.resize(n);
  return kinds;
}

std::vector<BlindEffect> drawEffects(const Mechanism& robot, BlindKind kind, std::size_t turn,
                                     const DrawOptions& options, Random& random) {
  std::vector<Range> list;
  const auto fits = [&](const DrawRange& r) {
    return (!r.floatingBase || options.battery == Battery::all) && !placesFor(robot, r.where).empty() &&
           (r.where != Where::imu || robot.hasImu);
  };
  if (kind == BlindKind::outside) {
    for (const OutsideEffect& effect : outsideEffects())
      if (!findEffect(effect.id) && fits(effect.drawing)) list.push_back({effect.id, effect.drawing});
  } else {
    for (const Range& r : kind == BlindKind::hard ? hardRanges() : libraryRanges())
      if (fits(r.drawing)) list.push_back(r);
  }
  // The same order throughout a set, another in another set.
  Random order(options.seed ^ (0x0d3 + static_cast<std::uint64_t>(kind)));
  shuffle(list, order);
  if (kind == BlindKind::none || list.empty()) return {};
  if (kind != BlindKind::mixture) {
    BlindEffect e = drawOne(robot, list[turn % list.size()], random);
    if (kind == BlindKind::hard) e = strengthened(robot, e, 0.5);
    return {e};
  }
  std::vector<BlindEffect> two = {drawOne(robot, list[2 * turn % list.size()], random)};
  for (;;) {
    BlindEffect other = drawOne(robot, pick(list, random), random);
    if (other.effect == two[0].effect || (other.at == two[0].at && other.axis == two[0].axis)) continue;
    two.push_back(std::move(other));
    return two;
  }
}

BlindEffect strengthened(const Mechanism& robot, BlindEffect e, double factor) {
  const DrawRange* range = drawingOf(e.effect);
  if (!range) return e;
  if (range->growth == DrawRange::Growth::distance) e.value *= factor;
  if (range->growth == DrawRange::Growth::factor) e.value = std::pow(e.value, factor);
  if (range->growth == DrawRange::Growth::limit) e.value /= factor;
  if (const Effect* known = findEffect(e.effect)) {
    const Place place = findPlace(*known, robot, e.at, e.axis);
    const Bounds bounds = known->boundsAt(robot, place);
    e.value = std::clamp(e.value, bounds.lower, bounds.upper);
  }
  return e;
}

std::vector<std::string> programsOf(Battery battery) {
  std::vector<std::string> programs = hangingBattery();
  const std::string again = programs.back();
  if (battery == Battery::all)
    for (const std::string& program : floatingBaseBattery()) programs.push_back(program);
  programs.push_back(again);
  return programs;
}

}  // namespace plumbline::gap
