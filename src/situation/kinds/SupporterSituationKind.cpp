#include "situation/kinds/SupporterSituationKind.h"

#include "representations/behavior/PlayerRole.h"
#include "representations/modeling/BallPos.h"
#include "situation/CycleOfLog.h"
#include "situation/Rounded.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"
#include "situation/kinds/SkillExpected.h"

namespace plumbline {
namespace {

std::shared_ptr<const SupporterKnowledge> withBallAge(double age) {
  auto known = std::make_shared<SupporterKnowledge>();
  known->ballAge = age;
  return known;
}

class SupporterSituationKind : public SituationKind {
public:
  SupporterSituationKind()
      : SituationKind({.name = "supporter", .order = 40, .heading = "A supporter: how it takes its place"}) {}

  void read(const ConfigSection& root, Situation& situation) const override {
    situation.place = readPose(root, "place");
    situation.known = withBallAge(root.find<double>("ballAge", SituationLimits::times()).value_or(0));
  }

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    return SkillExpected::read(section, true);
  }

  KindText text(const Situation& situation) const override {
    KindText text;
    if (situation.place) text.beforeBall = "place: " + poseText(*situation.place) + "\n";
    const double age = knownTo<SupporterKnowledge>(situation).ballAge;
    if (age > 0) text.afterBall = "ballAge: " + rounded(age) + "\n";
    return text;
  }

  void take(const CycleOfLog& cycle, Situation& situation) const override {
    situation.place = cycle.get<PlayerRole>().place;
    situation.known = withBallAge(cycle.get<BallPos>().age);
  }
};

MAKE_SITUATION_KIND(SupporterSituationKind)

}  // namespace
}  // namespace plumbline
