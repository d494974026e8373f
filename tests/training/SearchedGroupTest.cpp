#include "training/SearchedGroup.h"

#include <gtest/gtest.h>

#include "framework/ConfigFile.h"
#include "support/Thrown.h"
#include "tactics/approach/BallPositioning.h"

namespace plumbline::training {
namespace {

TEST(SearchedGroup, namesNumbersWithoutDotsAndWritesThemByGroups) {
  const std::vector<FirstStep> numbers{{"leaveTolerances", 0.2, ""}, {"walk.maxTurn", 0.3, ""}};
  const ConfigFile file("SkillGetBall", {"config"});
  const SearchedGroup<BallPositioningParameters> searched(file.root().section("positioning"), numbers);
  ASSERT_EQ(searched.parameters().size(), 2U);
  EXPECT_EQ(searched.parameters()[0].name, "walk_maxTurn") << "in the group's order";
  EXPECT_EQ(searched.parameters()[1].name, "leaveTolerances");
  const BallPositioningParameters changed = searched.with(Eigen::Vector2d(2.123456, 1.5));
  EXPECT_DOUBLE_EQ(changed.walk.maxTurn, 2.123);
  EXPECT_DOUBLE_EQ(changed.leaveTolerances, 1.5);
  const GroupedLines lines = searched.lines(Eigen::Vector2d(2.123456, 1.5));
  EXPECT_EQ(lines.text, "  walk:\n    maxTurn: 2.123\n  leaveTolerances: 1.5\n");
  EXPECT_EQ(lines.count, 2U);
}

TEST(SearchedGroup, whatIsNotAmongTheSearchedKeepsItsValueAndIsWritten) {
  const std::vector<FirstStep> numbers{{"leaveTolerances", 0.2, ""}, {"walk.maxTurn", 0.3, ""}};
  const ConfigFile file("SkillGetBall", {"config"});
  const SearchedGroup<BallPositioningParameters> searched(
      file.root().section("positioning"), numbers,
      [](const std::string& path) { return path == "leaveTolerances"; });
  ASSERT_EQ(searched.parameters().size(), 1U);
  EXPECT_EQ(searched.parameters()[0].name, "leaveTolerances");
  const Eigen::VectorXd keeps = Eigen::VectorXd::Constant(1, 1.5);
  const double turn = searched.with(keeps).walk.maxTurn;
  EXPECT_EQ(searched.lines(keeps).text,
            fmt::format("  walk:\n    maxTurn: {:.4g}\n  leaveTolerances: 1.5\n", turn));
  EXPECT_EQ(searched.lines(keeps).count, 2U);
}

TEST(SearchedGroup, aStepOfNoNumberIsAnErrorWithTheNearestName) {
  const std::vector<FirstStep> numbers{{"walk.maxTrun", 0.3, "steps.yaml:3: positioning.walk.maxTrun"}};
  const ConfigFile file("SkillGetBall", {"config"});
  EXPECT_EQ(thrownBy([&] {
              const SearchedGroup<BallPositioningParameters> searched(file.root().section("positioning"),
                                                                      numbers);
            }),
            "steps.yaml:3: positioning.walk.maxTrun: no parameter \"walk.maxTrun\"; did you mean "
            "\"walk.maxTurn\"?");
}

}  // namespace
}  // namespace plumbline::training
