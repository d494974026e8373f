#include "modules/behavior/Formation.h"

#include <gtest/gtest.h>

#include <set>

#include "situation/kinds/FormationSituationKind.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

/// One player of a team whose members have all spoken.
struct FormationTest : testing::Test {
  FormationTest() { setUp(harness, 3); }
  static void setUp(test::ModuleHarness<Formation>& one, int number) {
    one.input<PlayerInfo>().number = number;
    one.input<GameState>().playMode = TeamPlayMode::playOn;
    one.input<RobotPose>().valid = true;
    one.input<BallPos>().valid = true;
    one.input<FrameInfo>().time = 30;
    one.input<FieldDimensions>();
    one.input<FallState>();
    one.input<OtherRobots>();
    one.input<TeamRobotPose>();
  }
  static TeamReport reportOf(int number, const Pose2& pose, double timeToBall) {
    TeamReport report;
    report.belief.number = number;
    report.belief.localised = true;
    report.belief.pose = pose;
    report.belief.timeToBall = timeToBall;
    report.time = 29.8;
    return report;
  }
  void ballAt(const Vec2& ball) {
    harness.input<BallPos>().field = ball;
    harness.input<BallPos>().relative = harness.input<RobotPose>().pose.inverse() * ball;
  }
  const PlayerRole& role() {
    harness.cycle();
    harness.input<FrameInfo>().time += 0.02;
    return harness.output<PlayerRole>();
  }
  test::ModuleHarness<Formation> harness;
};

TEST_F(FormationTest, alwaysOneStrikerAndAllThePlacesDifferentInTheMindsOfAllPlayers) {
  std::vector<TeamReport> reports;
  for (int number = 1; number <= 11; ++number)
    reports.push_back(reportOf(number, Pose2(-14 + 2 * number, number % 3, 0), number == 7 ? 1 : 5 + number));
  std::set<int> roles;
  for (int number = 1; number <= 11; ++number) {
    test::ModuleHarness<Formation> one;
    setUp(one, number);
    // What the player sees itself of its own pose differs from what it said.
    one.input<RobotPose>().pose = Pose2(-13.7 + 2 * number, 0, 1);
    one.input<BallPos>().field = {3, 2};
    std::vector<TeamReport> heard = reports;
    std::rotate(heard.begin(), heard.begin() + number % 5, heard.end());
    one.input<TeamRobotPose>().reports = heard;
    one.cycle();
    const PlayerRole& role = one.output<PlayerRole>();
    EXPECT_EQ(role.strikerNumber, 7);
    EXPECT_EQ(role.members, 11);
    roles.insert(role.role);
  }
  EXPECT_EQ(roles.size(), 11u);
}

TEST_F(FormationTest, aloneItIsTheStriker) {
  harness.input<PlayerInfo>().number = 1;
  EXPECT_EQ(role().role, PlayerRole::striker);
  EXPECT_EQ(role().members, 1);
}

TEST_F(FormationTest, aMateThatIsOnlySeenTakesPart) {
  ballAt({0, 0});
  harness.input<RobotPose>().pose = Pose2(-6, 0, 0);
  OtherRobot& mate = harness.input<OtherRobots>().robots.emplace_back();
  mate.mate = true;
  mate.number = 8;
  mate.position = {-0.5, 0};
  mate.lastSeen = 29.9;
  EXPECT_EQ(role().members, 2);
  EXPECT_EQ(role().strikerNumber, 8);
  EXPECT_TRUE(role().supports());
}

TEST_F(FormationTest, goesByWhereARollingBallWillRest) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(0, 0, 0), 0.5)};
  harness.input<RobotPose>().pose = Pose2(-3, 0, 0);
  ballAt({5, 2});
  const Vec2 place = role().place.position;
  const double time = role().timeToBall;
  ballAt({0, 2});
  harness.input<BallPos>().relativeVelocity = Vec2(5, 0) / 0.92;
  EXPECT_LT((role().place.position - place).norm(), 0.01);
  EXPECT_NEAR(role().timeToBall, time, 0.2) << "it cannot be met before";
}

TEST_F(FormationTest, wordsFromBeforeAKickAreOld) {
  TeamReport near = reportOf(7, Pose2(0, 0, 0), 0.5);
  near.belief.ballKnown = true;
  near.belief.ball = {0.3, 0};
  harness.input<TeamRobotPose>().reports = {near, reportOf(3, Pose2(6, 0, 0), 6)};
  harness.input<RobotPose>().pose = Pose2(6, 0, 0);
  ballAt({0.3, 0});
  EXPECT_EQ(role().strikerNumber, 7);
  // It was kicked to 8 m: number 7 did not know that yet.
  ballAt({7, 0});
  harness.input<TeamRobotPose>().reports[1].belief.timeToBall = 2;
  EXPECT_EQ(role().strikerNumber, 3);
  harness.input<TeamRobotPose>().reports[0].belief.ballKnown = false;
  EXPECT_EQ(role().strikerNumber, 7) << "who tells of no ball is believed its time";
}

TEST_F(FormationTest, supportersKeepOffTheBallAndFartherAtTheOpponentsRestarts) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(0, 0, 0), 0.5)};
  harness.input<RobotPose>().pose = Pose2(-3, 0, 0);
  for (double x = -14.9; x < 15; x += 1.3)
    for (double y = -9.9; y < 10; y += 1.7) {
      ballAt({x, y});
      harness.input<GameState>().playMode = TeamPlayMode::playOn;
      EXPECT_GT((role().place.position - Vec2(x, y)).norm(), 1) << x << " " << y;
      harness.input<GameState>().playMode = TeamPlayMode::kickInOpponent;
      EXPECT_GT((role().place.position - Vec2(x, y)).norm(), 1.9) << x << " " << y;
    }
}

TEST_F(FormationTest, allStayInTheirHalfUntilAKickOffIsTaken) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(0, 0, 0), 0.5),
                                            reportOf(8, Pose2(-5, 0, 0), 9)};
  harness.input<RobotPose>().pose = Pose2(1, 3, 0);
  ballAt({0, 0});
  harness.input<GameState>().playMode = TeamPlayMode::kickOffOpponent;
  EXPECT_LT(role().place.position.x(), 0);
}

TEST_F(FormationTest, nobodyStandsInThePenaltyAreaAtTheOpponentsGoalKick) {
  const FieldDimensions& field = harness.input<FieldDimensions>();
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(13, 0, 0), 0.5),
                                            reportOf(8, Pose2(-5, 0, 0), 9)};
  harness.input<RobotPose>().pose = Pose2(14, 1, 0);
  harness.input<GameState>().playMode = TeamPlayMode::goalKickOpponent;
  for (double x = 11; x < 15; x += 0.5)
    for (double y = -9.5; y < 10; y += 0.5) {
      ballAt({x, y});
      const Vec2 place = role().place.position;
      EXPECT_TRUE(std::abs(place.y()) > field.penaltyWidth / 2 ||
                  place.x() < field.length / 2 - field.penaltyDepth)
          << x << " " << y;
    }
}

// The area begins at 13.2 m and is 6 m wide; players stay 0.4 m off its line, whatever a file says.
TEST_F(FormationTest, aPlaceInThePenaltyAreaIsMovedOutOfItAtTheOpponentsGoalKick) {
  const test::ScratchFolder folder;
  folder.write("set_pieces/goalKickOpponent.yaml",
               "modes: [goalKickOpponent]\nlasts: 3\nstand:\n  - {x: 11.8, y: 0.8}\n"
               "places:\n  - {x: 14, y: 2}\n  - {x: 14, y: -2}\n");
  test::ModuleHarness<Formation> one({"config", folder.path()});
  setUp(one, 3);
  one.input<RobotPose>().pose = Pose2(10, 0, 0);
  one.input<GameState>().playMode = TeamPlayMode::goalKickOpponent;
  one.input<BallPos>().field = {14.5, 8};
  one.input<TeamRobotPose>().reports = {reportOf(7, Pose2(13, 8, 0), 0.5), reportOf(3, Pose2(10, 0, 0), 9),
                                        reportOf(8, Pose2(5, 0, 0), 9)};
  one.cycle();
  int moved = 0;
  for (const PlacedPlayer& player : one.output<TeamPlaces>().players)
    if (player.placed && player.place.x() > 12) {
      EXPECT_NEAR(player.place.x(), 12.8, 1e-9) << player.number;
      ++moved;
    }
  EXPECT_EQ(moved, 2);
}

TEST_F(FormationTest, placesOfASetPieceHoldUntilItIsOver) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(15, 10, 0), 0.5)};
  harness.input<RobotPose>().pose = Pose2(12, 2, 0);
  ballAt({15, 10});
  harness.input<GameState>().playMode = TeamPlayMode::cornerOwn;
  const Vec2 nearPost = role().place.position;
  EXPECT_EQ(nearPost, Vec2(13.6, 1.4)) << "config/set_pieces/cornerOwn.yaml";
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_EQ(role().place.position, nearPost);
  harness.input<FrameInfo>().time += 10;
  EXPECT_NE(role().place.position, nearPost) << "the formation's own place";
  // Any other mode ends it at once.
  harness.input<GameState>().playMode = TeamPlayMode::cornerOwn;
  role();
  harness.input<GameState>().playMode = TeamPlayMode::offsideOwn;
  EXPECT_NE(role().place.position, nearPost);
}

TEST_F(FormationTest, theSupporterNearestToADangerousOpponentBlocksIt) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(-5, 0, 0), 0.5),
                                            reportOf(8, Pose2(-7, 0, 0), 3), reportOf(9, Pose2(-2, 0, 0), 4)};
  harness.input<RobotPose>().pose = Pose2(-9, -1, 0);
  ballAt({-5, 0});
  BlockPosition& block = harness.input<BlockPosition>();
  const Vec2 own = role().place.position;
  block.valid = true;
  block.position = own + Vec2(-1, -1);
  EXPECT_TRUE(role().place.position.isApprox(block.position));
  block.position = own + Vec2(0, -6);
  EXPECT_TRUE(role().place.position.isApprox(own)) << "too far";
}

TEST_F(FormationTest, whoTookARestartWaitsUntilAnotherOneTouchesTheBall) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(-5, 0, 0), 6)};
  harness.input<RobotPose>().pose = Pose2(-0.2, 0, 0);
  ballAt({0, 0});
  harness.input<GameState>().playMode = TeamPlayMode::kickInOwn;
  EXPECT_TRUE(role().mayTouchBall);
  EXPECT_EQ(role().role, PlayerRole::striker);
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_FALSE(role().mayTouchBall);
  EXPECT_EQ(role().role, PlayerRole::supporter);
  OtherRobot& robot = harness.input<OtherRobots>().robots.emplace_back();
  robot.position = {0.2, 0.1};
  EXPECT_TRUE(role().mayTouchBall);
  // A player that was not at the ball did not take it.
  harness.input<OtherRobots>().robots.clear();
  ballAt({5, 5});
  harness.input<GameState>().playMode = TeamPlayMode::kickInOwn;
  role();
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_TRUE(role().mayTouchBall);
}

TEST_F(FormationTest, whoTookARestartKnowsItThoughTheBallIsAwayWhenPlayIsOn) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(-5, 0, 0), 6)};
  harness.input<RobotPose>().pose = Pose2(-0.2, 0, 0);
  ballAt({0, 0});
  harness.input<GameState>().playMode = TeamPlayMode::kickOffOwn;
  role();
  ballAt({0.9, 0});  // a hard kick, seen before the play mode
  role();
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_FALSE(role().mayTouchBall);
}

TEST_F(FormationTest, waitsForNoTouchLongerThanItMust) {
  harness.input<TeamRobotPose>().reports = {reportOf(7, Pose2(-5, 0, 0), 6)};
  harness.input<RobotPose>().pose = Pose2(-0.2, 0, 0);
  ballAt({0, 0});
  harness.input<GameState>().playMode = TeamPlayMode::cornerOwn;
  role();
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_FALSE(role().mayTouchBall);
  harness.input<FrameInfo>().time += 4.1;
  EXPECT_TRUE(role().mayTouchBall);
}

TEST_F(FormationTest, theRoleIsDrawnAtItsPlaceAndThePlanForAll) {
  ballAt({0, 0});
  harness.input<RobotPose>().pose = Pose2(-6, 0, 0);
  harness.input<TeamRobotPose>().reports = {reportOf(3, Pose2(-6, 0, 0), 9), reportOf(8, Pose2(-1, 0, 0), 1)};
  const Drawing own = test::drawnBy("draw:team:role", [&] { role(); });
  const PlayerRole& is = harness.output<PlayerRole>();
  ASSERT_EQ(is.role, PlayerRole::supporter);
  const Vec3 place = test::placeOf(own, "3 supporter 1");
  EXPECT_TRUE(place.head<2>().isApprox(is.place.position));
  const auto& line = std::get<shapes::Line>(own.shapes().front().form);
  EXPECT_EQ(line.begin, Vec3(-6, 0, 0)) << "from the player";
  EXPECT_EQ(line.end, place);
  const Drawing plan = test::drawnBy("draw:Formation:plan", [&] { role(); });
  EXPECT_EQ(test::placeOf(plan, "8 striker"), Vec3(0, 0, 0));
  EXPECT_EQ(test::placeOf(plan, "3 supporter 1"), place);
}

TEST_F(FormationTest, saysWhereMatesLookAndGo) {
  ballAt({0, 0});
  harness.input<TeamRobotPose>().reports = {reportOf(1, Pose2(-14, 0, 0.5), 15),
                                            reportOf(3, Pose2(-1, 0, 0), 1), reportOf(8, Pose2(-4, 2, 1), 5)};
  OtherRobot& seen = harness.input<OtherRobots>().robots.emplace_back();
  seen.mate = true;
  seen.number = 9;
  seen.position = {-6, 0};
  seen.lastSeen = 29.9;
  role();
  const TeamPlaces& places = harness.output<TeamPlaces>();
  ASSERT_EQ(places.players.size(), 3u) << "the heading of a player that is only seen is not known";
  EXPECT_FALSE(places.of(1)->placed) << "the goalie";
  EXPECT_FALSE(places.of(3)->placed) << "the striker";
  ASSERT_TRUE(places.of(8)->placed);
  EXPECT_EQ(places.of(8)->heading, 1);
  const Vec2 toBall = -places.of(8)->place.position;
  EXPECT_NEAR(normalizeAngle(places.of(8)->place.heading - std::atan2(toBall.y(), toBall.x())), 0, 1e-9);
}

/// A file with what players have said, and the role and place that people expect of one of them
/// (tests/data/situations/formation).
struct FormationSituations : FormationTest, testing::WithParamInterface<std::string> {};

TEST_P(FormationSituations, areDecidedAsExpected) {
  const test::WrittenSituation<FormationExpected> written("formation", GetParam());
  harness.input<PlayerInfo>().number = written->player;
  harness.input<GameState>().playMode = written->mode;
  for (const SaidPlace& said : written->team)
    harness.input<TeamRobotPose>().reports.push_back(reportOf(said.number, said.pose, said.timeToBall));
  harness.input<RobotPose>().pose = written->robot;
  harness.input<OtherRobots>().robots = written->others;
  ballAt(written->ball);
  const PlayerRole& is = role();
  const FormationExpected& expected = written.expected();
  using Role = FormationExpected::Role;
  EXPECT_EQ(is.strikerNumber, expected.striker);
  EXPECT_EQ(is.supports()                    ? Role::supporter
            : is.role == PlayerRole::striker ? Role::striker
                                             : Role::goalie,
            expected.role);
  if (!expected.area) return;
  const auto& area = *expected.area;
  EXPECT_GE(is.place.x(), area[0]);
  EXPECT_LE(is.place.x(), area[1]);
  EXPECT_GE(is.place.y(), area[2]);
  EXPECT_LE(is.place.y(), area[3]);
}

INSTANTIATE_TEST_SUITE_P(Written, FormationSituations, testing::ValuesIn(test::situationNames("formation")),
                         test::situationName);

}  // namespace
