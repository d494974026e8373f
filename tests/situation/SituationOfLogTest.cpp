#include "situation/SituationOfLog.h"

#include <gtest/gtest.h>

#include <memory>

#include "record/CdrStream.h"
#include "record/LogWriter.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/communication/TeamReports.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OppInfo.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"
#include "situation/SituationFile.h"
#include "situation/SituationKinds.h"
#include "situation/kinds/BlockSituationKind.h"
#include "situation/kinds/StrikerSituationKind.h"
#include "situation/kinds/SupporterSituationKind.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

using record::LogReader;

/// A log of three cycles, 20 ms apart, in which the ball moves on by 1 m.
struct SituationOfLogTest : testing::Test {
  SituationOfLogTest() {
    player.number = 7;
    player.team = "Own";
    pose.pose = Pose2(-1, 0, pi / 2);
    pose.valid = true;
    ball.valid = true;
    ball.relativeVelocity = {1, 0};
    ball.age = 0.5;
    game.playMode = TeamPlayMode::cornerOwn;
    add(false, {4, 0}, 3);
    add(true, {-5, 0}, 2);
    add(true, {-3, 3}, 9);
    PlacedPlayer& placed = places.players.emplace_back();
    placed.number = 9;
    placed.heading = 0.5;
    placed.placed = true;
    placed.place = Pose2(1, 3, 0);
    kicks.kicks = {Kick()};
    role.timeToBall = 1.25;
    role.place = Pose2(2, 2, 1);
    opponents.kickDistance = 8;
    TeamReport& report = team.reports.emplace_back();
    report.belief.number = 9;
    report.belief.localised = true;
    report.belief.pose = Pose2(-3, 3, 0.5);
    report.belief.timeToBall = 4;
  }
  void add(bool mate, const Vec2& place, int number) {
    OtherRobot& robot = others.robots.emplace_back();
    robot.mate = mate;
    robot.position = place;
    robot.number = number;
  }
  template <typename R>
  void put(const R&, record::RecordedThread& thread) const {
    thread.topics.push_back(
        {representationLoader<R>().name(), "Test", record::schemaOf(representationLoader<R>())});
  }
  std::unique_ptr<LogReader> log() {
    record::RecordedThread thread{"main", {"Test:execute"}, {}};
    std::apply([&](auto&... one) { (put(one, thread), ...); }, all());
    record::LogWriter writer(scratch / "log", {});
    writer.begin({thread});
    for (int number = 1; number <= 3; ++number) {
      ball.field = {static_cast<double>(number), 0.5};
      std::vector<std::string> messages;
      const auto message = [&](auto& value) {
        record::CdrOutStream out;
        out.begin();
        value.stream(nullptr, &out);
        messages.emplace_back(out.bytes());
      };
      std::apply([&](auto&... one) { (message(one), ...); }, all());
      writer.write({0,
                    static_cast<std::uint64_t>(number),
                    number * std::int64_t{20'000'000},
                    {messages.begin(), messages.end()}});
    }
    writer.finish();
    return std::make_unique<LogReader>(scratch / "log");
  }
  std::tuple<PlayerInfo&, RobotPose&, BallPos&, GameState&, OtherRobots&, TeamPlaces&, SkillKickParameters&,
             PlayerRole&, OppInfo&, TeamRobotPose&>
  all() {
    return {player, pose, ball, game, others, places, kicks, role, opponents, team};
  }
  Situation at(double time, const char* kind) {
    const auto reader = log();
    return situationOfLog(*reader, reader->thread(""), time, situationKind(kind));
  }
  std::string errorAt(double time) {
    return thrownBy([&] { at(time, "striker"); });
  }

  test::ScratchFolder scratch;
  PlayerInfo player;
  RobotPose pose;
  BallPos ball;
  GameState game;
  OtherRobots others;
  TeamPlaces places;
  SkillKickParameters kicks;
  PlayerRole role;
  OppInfo opponents;
  TeamRobotPose team;
};

TEST_F(SituationOfLogTest, isWhatThePlayerBelievedThen) {
  const Situation s = at(0.05, "striker");
  EXPECT_EQ(s.about, "What number 7 of Own believed at 0.04 s of the log log.");
  EXPECT_EQ(s.player, 7);
  EXPECT_EQ(s.robot.position, Vec2(-1, 0));
  EXPECT_EQ(s.ball, Vec2(2, 0.5)) << "of the cycle at that time, or before it";
  EXPECT_EQ(s.mode, TeamPlayMode::cornerOwn);
  ASSERT_EQ(s.others.size(), 3u);
  EXPECT_EQ(s.others[0].number, 9) << "whose place is known comes first";
  EXPECT_EQ(s.others[1].number, 2);
  EXPECT_FALSE(s.others[2].mate);
  ASSERT_EQ(s.going.size(), 1u);
  EXPECT_EQ(s.going[0].place.position, Vec2(1, 3));
  EXPECT_EQ(knownTo<StrikerKnowledge>(s).kicks.size(), 1u);
  EXPECT_FALSE(s.expected) << "people say what they expect";
}

TEST_F(SituationOfLogTest, anOpponentWithAMatesNumberGoesNowhere) {
  others.robots.clear();
  add(false, {4, 0}, 9);
  add(true, {-3, 3}, 9);
  const Situation s = at(0.05, "striker");
  ASSERT_EQ(s.others.size(), 2u);
  EXPECT_TRUE(s.others[0].mate);
  EXPECT_EQ(s.going.size(), 1u);
}

TEST_F(SituationOfLogTest, hasTheVelocityOfTheBall) {
  EXPECT_TRUE(at(0.02, "goalie").ballVelocity.isApprox(Vec2(0, 1))) << "the robot looks to the left";
}

TEST_F(SituationOfLogTest, hasWhatOnlyItsKindKnows) {
  const auto reader = log();
  const auto of = [&](const char* kind) {
    return situationOfLog(*reader, reader->thread(""), 0.02, situationKind(kind));
  };
  EXPECT_EQ(knownTo<SupporterKnowledge>(of("supporter")).ballAge, 0.5);
  EXPECT_EQ(knownTo<BlockKnowledge>(of("block")).kickDistance, 8);
}

TEST_F(SituationOfLogTest, ofATeamIsWhatItsPlayersSaid) {
  const Situation s = at(0.02, "formation");
  ASSERT_EQ(s.team.size(), 2u);
  EXPECT_EQ(s.team[0].number, 9);
  EXPECT_EQ(s.team[0].timeToBall, 4);
  EXPECT_EQ(s.team[1].number, 7);
  EXPECT_EQ(s.team[1].timeToBall, 1.25);
}

TEST_F(SituationOfLogTest, ofEveryKindIsAFileThatReadsBack) {
  const auto reader = log();
  for (const auto& kind : situationKinds()) {
    const Situation s = situationOfLog(*reader, reader->thread(""), 0.06, *kind);
    scratch.write("one.yaml", situationText(s));
    EXPECT_EQ(situationText(readSituation(scratch / "one.yaml")), situationText(s)) << kind->traits.name;
  }
}

TEST_F(SituationOfLogTest, saysWhichTimesThereAre) {
  EXPECT_EQ(errorAt(5), scratch / "log" + ": its times are 0.02 to 0.06 s, not 5");
}

TEST_F(SituationOfLogTest, aPlayerThatIsLostHasNone) {
  pose.valid = false;
  EXPECT_EQ(errorAt(0.04),
            scratch / "log" + ": at 0.04 s the player does not know where it is; take another time");
}

TEST_F(SituationOfLogTest, norOneThatDoesNotKnowTheBall) {
  ball.valid = false;
  EXPECT_EQ(errorAt(0.04),
            scratch / "log" + ": at 0.04 s the player does not know where the ball is; take another time");
}

TEST_F(SituationOfLogTest, aTeamIsNoLargerThanItCanBe) {
  for (int i = 0; i < 11; ++i) add(false, {5, 0}, 0);
  EXPECT_EQ(errorAt(0.04),
            scratch / "log" + ": at 0.04 s the player believes in a team of 12; take another time");
}

}  // namespace
}  // namespace plumbline
