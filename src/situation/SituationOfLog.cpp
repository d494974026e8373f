#include "situation/SituationOfLog.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "field/TeamSize.h"
#include "record/CdrStream.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/communication/TeamReports.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OppInfo.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {
namespace {

using record::LogReader;

/// The representations of one cycle.
class CycleOfLog {
public:
  CycleOfLog(LogReader& log, const LogReader::Thread& thread, double time) : log_(log), thread_(thread) {
    if (thread.cycles.empty()) throw std::runtime_error(log.path() + ": it has no cycle");
    const auto timeOf = [](const LogReader::Cycle& cycle) { return record::secondsOf(cycle.timestamp); };
    const auto behind = std::ranges::upper_bound(thread.cycles, time, {}, timeOf);
    // A tenth of a second behind the last cycle is no time at which it went on.
    if (behind == thread.cycles.begin() || time > timeOf(thread.cycles.back()) + 0.1)
      throw std::runtime_error(fmt::format("{}: its times are {:.2f} to {:.2f} s, not {:g}", log.path(),
                                           timeOf(thread.cycles.front()), timeOf(thread.cycles.back()),
                                           time));
    const auto cycle = behind - 1;
    time_ = timeOf(*cycle);
    log.readWhole(thread, static_cast<std::size_t>(cycle - thread.cycles.begin()), messages_);
  }
  double time() const { return time_; }

  template <typename R>
  R get() const {
    const auto& loader = representationLoader<R>();
    const auto& topics = thread_.recorded.topics;
    const auto topic = std::ranges::find(topics, loader.name(), &record::RecordedTopic::representation);
    if (topic == topics.end()) throw std::runtime_error(log_.path() + " has no " + loader.name());
    if (topic->schema != record::schemaOf(loader))
      throw std::runtime_error(log_.path() + ": " + loader.name() +
                               " had other members when it was recorded");
    R value;
    const std::string& message = messages_[static_cast<std::size_t>(topic - topics.begin())];
    const std::string error = message.empty() ? "no value yet" : record::readMessage<R>(message, value);
    const std::string problem = error.empty() ? loader.problemOf(value) : error;
    if (!problem.empty())
      throw std::runtime_error(
          fmt::format("{}: {} at {:.2f} s: {}", log_.path(), loader.name(), time_, problem));
    return value;
  }

private:
  LogReader& log_;
  const LogReader::Thread& thread_;
  std::vector<std::string> messages_;
  double time_ = 0;
};

/// Mates whose places are known come first: the rows of `going` belong to the mates in their order.
void takeMates(const CycleOfLog& cycle, Situation& situation) {
  const TeamPlaces places = cycle.get<TeamPlaces>();
  const auto placeOf = [&](const OtherRobot& robot) -> const PlacedPlayer* {
    const PlacedPlayer* place = robot.mate && robot.number > 0 ? places.of(robot.number) : nullptr;
    return place && place->placed ? place : nullptr;
  };
  std::ranges::stable_partition(situation.others,
                                [&](const OtherRobot& robot) { return placeOf(robot) != nullptr; });
  for (const OtherRobot& robot : situation.others)
    if (const PlacedPlayer* place = placeOf(robot)) situation.going.push_back(*place);
}

void takeTeam(const CycleOfLog& cycle, Situation& situation) {
  const TeamRobotPose team = cycle.get<TeamRobotPose>();
  for (const TeamReport& report : team.reports)
    if (report.belief.localised && report.belief.number != situation.player)
      situation.team.push_back({report.belief.number, report.belief.pose, report.belief.timeToBall});
  situation.team.push_back({situation.player, situation.robot, cycle.get<PlayerRole>().timeToBall});
}

}  // namespace

Situation situationOfLog(LogReader& log, const LogReader::Thread& thread, double time, Decider decider) {
  const CycleOfLog cycle(log, thread, time);
  Situation situation;
  situation.decides = decider;
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
  situation.ballAge = ball.age;
  situation.others = cycle.get<OtherRobots>().robots;
  const auto mates = std::ranges::count(situation.others, true, &OtherRobot::mate);
  const auto most = std::max<std::ptrdiff_t>(mates, std::ssize(situation.others) - mates);
  if (most > teamSize)
    throw std::runtime_error(
        fmt::format("{}: at {:.2f} s the player believes in a team of {}; take another time", log.path(),
                    cycle.time(), most));
  std::ranges::stable_partition(situation.others, &OtherRobot::mate);
  if (decider == Decider::striker) {
    takeMates(cycle, situation);
    for (const Kick& kick : cycle.get<SkillKickParameters>().kicks) situation.kicks.push_back(kick);
  }
  if (decider == Decider::formation) takeTeam(cycle, situation);
  if (decider == Decider::supporter) situation.place = cycle.get<PlayerRole>().place;
  if (decider == Decider::block) {
    const double kick = cycle.get<OppInfo>().kickDistance;
    if (kick > 0) situation.opponentKick = kick;
  }
  return situation;
}

}  // namespace plumbline
