#include "SetPiece.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "field/FieldSize.h"
#include "math/Random.h"
#include "watch/BallTouches.h"

namespace plumbline::bench {
namespace {

using namespace simspark;
using watch::BallMoment;
using watch::BallTouches;

const std::vector<int> playerTypes = {4, 4, 2, 4, 3, 4, 2, 4, 4, 4, 3};
constexpr double timeToKick = 15,
                 dropMargin = 0.3;  // the referee's time, and what of it a scene may be late [s]
constexpr double onTorso = 0.4, keepApart = 0.6, insideLines = 0.5;  // of robots that are put [m]
constexpr double ballOnGround = 0.05;                                // [m]
constexpr double touchLate =
    0.35;  // a touch is seen in scenes up to so long after the play mode's change [s]

bool goesOn(const std::string& mode) {
  return mode == playModeName(PlayMode::playOn) || mode.starts_with("pass");
}

PlayMode modeOf(SetPieceKind kind) {
  constexpr std::array modes = {PlayMode::kickOffLeft, PlayMode::kickInLeft, PlayMode::cornerKickLeft,
                                PlayMode::goalKickLeft, PlayMode::freeKickLeft};
  return modes[static_cast<std::size_t>(kind)];
}

Vec2 ballPlace(SetPieceKind kind, const FieldSize& field, Random& random) {
  const double halfWidth = field.width / 2 - field.ballRadius, halfLength = field.length / 2;
  const double side = random.uniform(0, 1) < 0.5 ? -1 : 1;
  switch (kind) {
    case SetPieceKind::kickIn:
      return {random.uniform(-10, 10), side * halfWidth};
    case SetPieceKind::cornerKick:  // where the referee puts it
      return {halfLength - field.ballRadius, side * ((field.width + field.goalWidth) / 4 - field.ballRadius)};
    case SetPieceKind::goalKick:
      return {1 - halfLength, 0};
    case SetPieceKind::freeKick:
      return {random.uniform(-8, 11), random.uniform(-7, 7)};
    default:
      return Vec2::Zero();
  }
}

/// What happens from the kick on.
class Play {
public:
  Play(const FieldSize& field, SetPieceResult& result)
      : touches_(field.length / 2, field.goalWidth / 2), result_(result) {}

  void observe(const SceneState& scene) {
    BallMoment moment{.time = scene.time, .mode = scene.playMode, .ball = scene.ball.head<2>()};
    for (const SceneRobot& robot : scene.robots)
      moment.players.push_back({robot.side, robot.unum, robot.T_world_torso.translation().head<2>()});
    touches_.observe(std::move(moment));
    if (!result_.taken) return;
    if (!taker_ || scene.time - kicked_ < touchLate) taker_ = touches_.lastTouch();
    const auto last = touches_.lastTouch();
    if (!next_ && last && taker_ && (last->side != taker_->side || last->number != taker_->number)) {
      next_ = last;
      result_.ours = last->side == TeamSide::left;
      result_.theirs = !result_.ours;
    }
    if (scene.time - kicked_ <= SetPieceGame::gainAfter) result_.gain = scene.ball.x() - from_;
    if (last && scene.time - kicked_ <= SetPieceGame::keptAfter) result_.kept = last->side == TeamSide::left;
  }
  void kick(double time, double from) {
    result_.taken = true;
    kicked_ = time;
    from_ = from;
  }
  /// The ball goes out of play; whose the restart is.
  void out(double time, bool ours) {
    if (time - kicked_ <= SetPieceGame::keptAfter) result_.kept = ours;
  }
  bool isOver(double time) const { return time - kicked_ > SetPieceGame::longest; }

private:
  BallTouches touches_;
  SetPieceResult& result_;
  std::optional<BallMoment::Player> taker_, next_;
  double kicked_ = 0, from_ = 0;
};

TrainedTeam teamOf(const SetPieceOptions& options, const char* name, bool other) {
  TrainedTeam team{name, options.programs};
  if (other && !options.others.empty()) team.options = {"--modules", options.others};
  team.types.assign(playerTypes.begin(), playerTypes.begin() + options.players);
  return team;
}

}  // namespace

SetPieceGame::SetPieceGame(const SetPieceOptions& options, std::uint64_t seed)
    : options_(options),
      game_(options.programs, options.scratch, seed, teamOf(options, "Own", false),
            teamOf(options, "Others", true)) {}

void SetPieceGame::place(const Vec2& ball, std::uint64_t seed) {
  Random random(seed);
  const FieldSize& field = game_.scene().field;
  std::vector<Vec2> taken = {ball};
  const auto put = [&](TeamSide side, int number, const Vec2& place) {
    taken.push_back(place);
    const Vec2 way = ball - place;
    game_.send(MoveAgentCommand{.player = PlayerName{number, side},
                                .position = Vec3(place.x(), place.y(), onTorso),
                                .heading = std::atan2(way.y(), way.x())});
  };
  const auto near = [&](double least, double most) {
    constexpr int mostTries = 200;
    Vec2 spot = Vec2::Zero();
    for (int i = 0; i < mostTries; ++i) {
      const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      spot = ball + random.uniform(least, most) * Vec2(std::cos(angle), std::sin(angle));
      if (std::abs(spot.x()) < field.length / 2 - field.penaltyDepth &&
          std::abs(spot.y()) < field.width / 2 - insideLines &&
          std::ranges::all_of(taken, [&](const Vec2& other) { return (spot - other).norm() > keepApart; }))
        break;
    }
    return spot;
  };
  const double goalie = field.length / 2 - insideLines;
  put(TeamSide::left, 1, {-goalie, 0.3});
  put(TeamSide::right, 1, {goalie, 0});
  for (int number = 2; number <= options_.players; ++number) {
    put(TeamSide::left, number, number == 2 ? near(1.5, 4) : near(3, 9));
    put(TeamSide::right, number, near(2.5, 8));
  }
}

void SetPieceGame::give(SetPieceKind kind, std::uint64_t seed) {
  const PlayMode mode = modeOf(kind);
  if (kind == SetPieceKind::kickOff) {
    // After a goal of the other team the referee gives it by itself, when all have beamed to their places.
    game_.setMode(PlayMode::goalRight);
    game_.await("has the kick-off",
                [&](const SceneState& scene) { return scene.playMode == playModeName(mode); });
    return;
  }
  Random random(seed);
  const Vec2 ball = ballPlace(kind, game_.scene().field, random);
  game_.send(BallCommand{.position = Vec3(ball.x(), ball.y(), ballOnGround), .velocity = Vec3::Zero()});
  place(ball, seed);
  game_.setMode(PlayMode::playOn);  // in which the referee sees where the ball is
  game_.setMode(mode);
}

SetPieceResult SetPieceGame::play(SetPieceKind kind, std::uint64_t seed) {
  game_.begin();
  give(kind, seed);
  const SceneState& scene = game_.scene();
  const double begin = scene.time;
  const int left = scene.scoreLeft, right = scene.scoreRight;
  SetPieceResult result{.kind = kind};
  Play play(scene.field, result);
  double before = scene.ball.x();
  while (true) {
    game_.nextScene();
    play.observe(scene);
    if (!result.taken) {
      const double passed = scene.time - begin;
      if (passed > timeToKick + dropMargin) return result;
      if (scene.playMode == playModeName(modeOf(kind))) {
        before = scene.ball.x();
        continue;
      }
      if (passed > timeToKick - dropMargin) return result;
      result.seconds = passed;
      play.kick(scene.time, before);
    }
    result.goal = scene.scoreLeft > left;
    result.against = scene.scoreRight > right;
    result.doubleTouch = scene.playMode == playModeName(PlayMode::freeKickRight);
    const bool over = play.isOver(scene.time);
    if (!result.goal && !result.against && goesOn(scene.playMode) && !over) continue;
    // A ball that went out is the other team's that brings it in.
    if (!over && !goesOn(scene.playMode) && !scene.playMode.starts_with("Goal_"))
      play.out(scene.time, scene.playMode.ends_with("_Left"));
    if (result.goal) result.kept = true;
    return result;
  }
}

}  // namespace plumbline::bench
