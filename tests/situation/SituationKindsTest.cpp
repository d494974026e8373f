#include "situation/SituationKinds.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"

namespace plumbline {
namespace {

TEST(SituationKinds, areInTheirOrder) {
  EXPECT_EQ(situationKindNames(), (std::vector<std::string>{"striker", "goalie", "formation", "supporter",
                                                            "block", "setPiece", "passCall"}));
}

TEST(SituationKinds, areFoundByTheirNames) {
  for (const auto& kind : situationKinds()) EXPECT_EQ(&situationKind(kind->traits.name), kind.get());
  EXPECT_EQ(thrownBy([] { situationKind("keeper"); }), "there is no kind of situation \"keeper\"");
}

class SecondGoalie : public SituationKind {
public:
  SecondGoalie() : SituationKind({.name = "goalie", .order = 1, .heading = ""}) {}
  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection&) const override { return {}; }
};

TEST(SituationKindsDeathTest, aNameIsOneKind) {
  EXPECT_EXIT(SituationKindLoader(std::make_unique<SecondGoalie>()), testing::ExitedWithCode(2),
              "^two kinds of situations with the name goalie are linked into this program\n$");
}

TEST(Situation, ofWhichNothingIsKnownHasDefaults) {
  struct Knowledge : KindKnowledge {
    int number = 7;
  };
  EXPECT_EQ(knownTo<Knowledge>(Situation()).number, 7);
  EXPECT_EQ(expectedWords(Situation()), "");
}

}  // namespace
}  // namespace plumbline
