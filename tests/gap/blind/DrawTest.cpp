#include "gap/blind/Draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/blind/OutsideDrives.h"
#include "gap/effects/Effects.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

using Where = DrawRange::Where;
using Unit = DrawRange::Unit;

const DrawRange& rangeOf(const BlindEffect& drawn) {
  const Effect* effect = findEffect(drawn.effect);
  return effect ? effect->drawing : findOutsideEffect(drawn.effect)->drawing;
}

std::vector<BlindEffect> drawnOften(const Mechanism& robot) {
  DrawOptions options;
  options.battery = Battery::all;
  Random random(5);
  std::vector<BlindEffect> all;
  for (std::size_t turn = 0; turn < 6000; ++turn)
    for (const BlindKind kind : {BlindKind::single, turn < 500 ? BlindKind::outside : BlindKind::single})
      for (const BlindEffect& effect : drawEffects(robot, kind, turn, options, random)) all.push_back(effect);
  return all;
}

/// Share of those drawn of which something is true, among those that may be.
double share(const std::vector<BlindEffect>& drawn, const std::function<bool(const DrawRange&)>& may,
             const std::function<bool(const BlindEffect&)>& is) {
  double all = 0, hits = 0;
  for (const BlindEffect& effect : drawn)
    if (may(rangeOf(effect))) ++all, hits += is(effect);
  EXPECT_GT(all, 50);
  return hits / all;
}

TEST(Draw, halfAreNegativeOfAllJointsOrOfTheSecondKind) {
  const std::vector<BlindEffect> drawn = drawnOften(findMechanism("nao_v5"));
  EXPECT_NEAR(share(
                  drawn, [](const DrawRange& r) { return r.bothSigns; },
                  [](const BlindEffect& e) { return e.value < 0; }),
              0.5, 0.06);
  EXPECT_NEAR(share(
                  drawn, [](const DrawRange& r) { return r.where == Where::jointOrAll; },
                  [](const BlindEffect& e) { return e.at == "*"; }),
              0.5, 0.1);
  EXPECT_NEAR(share(
                  drawn, [](const DrawRange& r) { return r.high2 > 0 && r.unit == Unit::plain; },
                  [](const BlindEffect& e) { return std::abs(e.value) >= rangeOf(e).low2; }),
              0.5, 0.1);
  EXPECT_NEAR(share(
                  drawn, [](const DrawRange& r) { return !r.choice.name.empty(); },
                  [](const BlindEffect& e) {
                    const DrawRange::Choice& choice = rangeOf(e).choice;
                    return e.how.at(std::string(choice.name)) == choice.first;
                  }),
              0.5, 0.1);
}

TEST(Draw, aPlainSizeLiesInTheRangeOfItsEffect) {
  for (const BlindEffect& effect : drawnOften(findMechanism("nao_v5"))) {
    const DrawRange& range = rangeOf(effect);
    if (range.unit != Unit::plain) continue;
    const double size = std::abs(effect.value);
    EXPECT_TRUE((size >= range.low && size <= range.high) || (size >= range.low2 && size <= range.high2))
        << effect.effect << " " << effect.value;
  }
}

TEST(Draw, aFifthOfTheCasesHasNoEffectAndASeventhOfEachOtherKindButSingles) {
  DrawOptions options;
  options.cases = 70;
  const std::vector<BlindKind> kinds = drawKinds(options);
  const auto count = [&](BlindKind kind) { return std::ranges::count(kinds, kind); };
  EXPECT_EQ(count(BlindKind::none), 14);
  EXPECT_EQ(count(BlindKind::mixture), 10);
  EXPECT_EQ(count(BlindKind::outside), 10);
  EXPECT_EQ(count(BlindKind::hard), 10);
  EXPECT_EQ(count(BlindKind::single), 26);
}

}  // namespace
}  // namespace plumbline::gap
