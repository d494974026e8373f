#include "situation/SituationOfLog.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "field/TeamSize.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "situation/CycleOfLog.h"
#include "situation/SituationKind.h"

namespace plumbline {

Situation situationOfLog(record::LogReader& log, const record::LogReader::Thread& thread, double time,
                         const SituationKind& kind) {
  const CycleOfLog cycle(log, thread, time);
  Situation situation;
  situation.kind = &kind;
  const PlayerInfo player = cycle.get<PlayerInfo>();
  const RobotPose pose = cycle.get<RobotPose>();
  const BallPos ball = cycle.get<BallPos>();
  if (!pose.valid || !ball.valid)
    throw std::runtime_error(
        fmt::format("{}: at {:.2f} s the player does not know where {} is; take another time", log.path(),
                    cycle.time(), pose.valid ? "the ball" : "it"));
  situation.player = player.number;
  situation.robot = pose.pose;
  situation.mode = cycle.get<GameState>().playMode;
  situation.about =
      fmt::format("What number {} of {} believed at {:.2f} s of the log {}.", player.number, player.team,
                  cycle.time(), std::filesystem::path(log.path()).lexically_normal().filename().string())
          .substr(0, 300);
  situation.ball = ball.field;
  situation.ballVelocity = pose.pose.rotation() * ball.relativeVelocity;
  situation.others = cycle.get<OtherRobots>().robots;
  const auto mates = std::ranges::count(situation.others, true, &OtherRobot::mate);
  const auto most = std::max<std::ptrdiff_t>(mates, std::ssize(situation.others) - mates);
  if (most > teamSize)
    throw std::runtime_error(
        fmt::format("{}: at {:.2f} s the player believes in a team of {}; take another time", log.path(),
                    cycle.time(), most));
  std::stable_partition(situation.others.begin(), situation.others.end(),  // clang 14 has no ranges' one
                        [](const OtherRobot& robot) { return robot.mate; });
  kind.take(cycle, situation);
  return situation;
}

}  // namespace plumbline
