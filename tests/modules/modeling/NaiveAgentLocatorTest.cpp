#include "modules/modeling/NaiveAgentLocator.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

constexpr double cameraHeight = 0.54;

/// A robot at a place of the field as another one at `own` with its head turned sees it. Only parts within 60
/// degrees to each side are seen, with SimSpark's noise if there is a random.
PolarPlayer playerAt(const std::string& team, int number, const Vec2& place, const Pose2& own, double headYaw,
                     bool fallen = false, Random* random = nullptr) {
  PolarPlayer player;
  player.team = team;
  player.number = number;
  const double head = fallen ? 0.1 : 0.54, arm = fallen ? 0.06 : 0.3;
  const std::vector<std::pair<std::string, Vec3>> parts = {{"head", {0, 0, head}},
                                                           {"rlowerarm", {0.05, -0.1, arm}},
                                                           {"llowerarm", {0.05, 0.1, arm}},
                                                           {"rfoot", {0, -0.05, 0.04}},
                                                           {"lfoot", {0, 0.05, 0.04}}};
  const Pose3 T_ground_head = translation(0, 0, cameraHeight) * rotationZ(headYaw);
  for (const auto& [name, offset] : parts) {
    const Vec2 relative = own.inverse() * Vec2(place + offset.head<2>());
    const Vec3 p = T_ground_head.inverse() * Vec3(relative.x(), relative.y(), offset.z());
    PolarBodyPart part;
    part.name = name;
    part.position.distance = p.norm();
    part.position.azimuth = std::atan2(p.y(), p.x());
    part.position.elevation = std::asin(p.z() / p.norm());
    if (std::abs(part.position.azimuth) > fromDegrees(60)) continue;
    if (random) {
      part.position.distance *= 1 + 0.000965 * random->gaussian();
      part.position.azimuth += fromDegrees(0.148) * random->gaussian();
      part.position.elevation += fromDegrees(0.1225) * random->gaussian();
    }
    player.parts.push_back(part);
  }
  return player;
}

struct NaiveAgentLocatorTest : testing::Test {
  NaiveAgentLocatorTest() {
    harness.input<PlayerInfo>().team = "Ours";
    harness.input<PlayerInfo>().number = 2;
    harness.input<TorsoPose>().valid = true;
    harness.input<RobotPose>().valid = true;
    harness.input<RobotPose>().pose = own = Pose2(-3, 1, 0.4);
    harness.input<FKModel>().T_torso_head = translation(0, 0, cameraHeight);
    harness.input<VisionInfo>();
    harness.input<PolarPlayerPercept>();
    harness.input<FrameInfo>().time = 5;
  }
  /// Three cycles, of which the first one has an image with these players.
  const std::vector<OtherRobot>& see(const std::vector<PolarPlayer>& players) {
    for (int cycle = 0; cycle < 3; ++cycle) {
      harness.input<VisionInfo>().newImage = cycle == 0;
      harness.input<PolarPlayerPercept>().players = cycle == 0 ? players : std::vector<PolarPlayer>();
      harness.cycle();
      harness.input<FrameInfo>().time += 0.02;
    }
    return robots();
  }
  const std::vector<OtherRobot>& robots() { return harness.output<LocalOtherRobots>().robots; }
  PolarPlayer theirs(int number, const Vec2& place, bool fallen = false, Random* random = nullptr) {
    return playerAt("Theirs", number, place, own, 0, fallen, random);
  }

  Pose2 own;
  test::ModuleHarness<NaiveAgentLocator> harness;
};

TEST_F(NaiveAgentLocatorTest, placesARobotOnTheFieldAndKnowsWhoItIs) {
  see({theirs(4, {2, 3}), playerAt("Ours", 9, {0, 1}, own, 0)});
  ASSERT_EQ(robots().size(), 2u);
  EXPECT_FALSE(robots()[0].mate);
  EXPECT_EQ(robots()[0].number, 4);
  EXPECT_LT((robots()[0].position - Vec2(2, 3)).norm(), 0.01);
  EXPECT_FALSE(robots()[0].fallen);
  EXPECT_TRUE(robots()[1].mate);
  EXPECT_EQ(robots()[1].number, 9);
}

TEST_F(NaiveAgentLocatorTest, theOwnArmsAreNobody) {
  see({playerAt("Ours", 2, own * Vec2(0.3, 0), own, 0)});
  EXPECT_TRUE(robots().empty());
}

TEST_F(NaiveAgentLocatorTest, seesWhoLies) {
  see({theirs(4, {2, 3}, true)});
  ASSERT_EQ(robots().size(), 1u);
  EXPECT_TRUE(robots()[0].fallen);
  EXPECT_LT((robots()[0].position - Vec2(2, 3)).norm(), 0.1);
  see({theirs(4, {2, 3}, false)});
  EXPECT_FALSE(robots()[0].fallen);
}

TEST_F(NaiveAgentLocatorTest, itsErrorIsAsLargeAsItsCovarianceSays) {
  Random random(7);
  double squares = 0;
  int count = 0;
  Vec2 place(4, -1);
  const Vec2 velocity(-0.4, 0.5);
  for (int image = 0; image < 100; ++image) {
    see({theirs(4, place, false, &random)});
    const OtherRobot& robot = robots()[0];
    const Vec2 error = robot.position - (place + 0.04 * velocity);  // two cycles after the image
    place += 0.06 * velocity;
    if (image < 20) continue;
    squares += error.dot(robot.covariance.inverse() * error);
    ++count;
    EXPECT_LT(error.norm(), 0.15);
    EXPECT_LT((robot.velocity - velocity).norm(), 0.35);
  }
  // Two degrees of freedom; part of the noise (how far a part is from the middle) is not in this test.
  EXPECT_LT(squares / count, 2.5);
  EXPECT_GT(squares / count, 0.02);
}

TEST_F(NaiveAgentLocatorTest, keepsAHiddenRobotWithGrowingCovarianceAndDropsOneThatVanished) {
  for (int i = 0; i < 10; ++i) see({theirs(4, {2, 3.2}), theirs(5, {-1, 1.85})});
  const double before = robots()[0].deviation();
  // Number 5 stands between; 4 is not seen for two seconds.
  for (int i = 0; i < 33; ++i) see({theirs(5, {-1, 1.85})});
  ASSERT_EQ(robots().size(), 2u);
  EXPECT_GT(robots()[0].deviation(), 3 * before);
  EXPECT_LT((robots()[0].position - Vec2(2, 3.2)).norm(), 0.1);
  // 5 goes, too: both should be seen now.
  for (int i = 0; i < 13; ++i) see({});
  EXPECT_TRUE(robots().empty());
}

TEST_F(NaiveAgentLocatorTest, oneBehindTheBackIsKeptForAWhile) {
  see({theirs(4, {2, 3})});
  harness.input<RobotPose>().pose.heading += pi;
  for (int i = 0; i < 33; ++i) see({});
  EXPECT_EQ(robots().size(), 1u);
  for (int i = 0; i < 200; ++i) see({});
  EXPECT_TRUE(robots().empty());
}

TEST_F(NaiveAgentLocatorTest, oneThatWasPutElsewhereIsThereAtOnce) {
  for (int i = 0; i < 10; ++i) see({theirs(4, {2, 3})});
  see({theirs(4, {5, -1})});
  ASSERT_EQ(robots().size(), 1u);
  EXPECT_LT((robots()[0].position - Vec2(5, -1)).norm(), 0.05);
}

TEST_F(NaiveAgentLocatorTest, whoseNumberCannotBeReadIsTheNearestOfItsTeam) {
  see({theirs(4, {2, 3}), theirs(6, {5, 3})});
  see({theirs(0, {5.1, 3})});
  ASSERT_EQ(robots().size(), 2u);
  EXPECT_NEAR(robots()[1].position.x(), 5.1, 0.08);
  see({theirs(0, {8, -3})});  // nobody is near there
  EXPECT_EQ(robots().size(), 2u);
}

TEST_F(NaiveAgentLocatorTest, nonsenseIsLeftOut) {
  PolarPlayer player = theirs(4, {2, 3});
  for (PolarBodyPart& part : player.parts) part.position.distance = 1e9;
  see({player});
  EXPECT_TRUE(robots().empty());
  PolarPlayer empty;
  empty.team = "Theirs";
  empty.number = 3;
  see({empty});
  EXPECT_TRUE(robots().empty());
}

TEST_F(NaiveAgentLocatorTest, withoutAPlaceOfItsOwnItAddsNobody) {
  harness.input<RobotPose>().valid = false;
  see({theirs(4, {2, 3})});
  EXPECT_TRUE(robots().empty());
}

TEST_F(NaiveAgentLocatorTest, whatIsSeenIsDrawn) {
  const Drawing drawing = test::drawnBy("draw:belief:sight", [&] {
    see({playerAt("Theirs", 4, {1, 2}, own, 0)});
  });
  EXPECT_LT((test::placeOf(drawing, "opp 4") - Vec3(1, 2, 0)).norm(), 0.2);
  EXPECT_EQ(test::countOf<shapes::Circle>(drawing) + test::countOf<shapes::Line>(drawing) / 16, 1u)
      << "how sure that is";
}

}  // namespace
