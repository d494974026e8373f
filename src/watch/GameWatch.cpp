#include "watch/GameWatch.h"

#include <tuple>

#include "framework/SteadyClock.h"
#include "framework/StopSignal.h"
#include "simspark/MonitorClient.h"

namespace plumbline::watch {

using namespace simspark;

namespace {

/// Notices that nothing happens any more.
class Pulse {
public:
  void feel(const SceneState& scene, double now) {
    auto state = std::tuple(scene.time, scene.playMode, scene.robots.size(), scene.half);
    if (state == last_) return;
    last_ = std::move(state);
    lastChange_ = now;
  }
  void restart(double now) { lastChange_ = now; }
  double standsFor(double now) const { return now - lastChange_; }

private:
  std::tuple<double, std::string, std::size_t, int> last_{-1, "", 0, 0};
  double lastChange_ = steadySeconds();
};

/// Kicks off when everybody is there, or nobody more is waited for.
class Starter {
public:
  explicit Starter(const GameWatchOptions& options) : options_(options), begin_(steadySeconds()) {}

  enum class Verdict { wait, noPlayers, kickOff };
  Verdict look(const SceneState& scene, double now) {
    if (scene.playMode != "BeforeKickOff") {
      readySince_ = -1;
      return Verdict::wait;
    }
    const bool late = now - begin_ > options_.patience;
    const auto here = static_cast<int>(scene.robots.size());
    if (late && here == 0) return Verdict::noPlayers;
    const bool ready = scene.half > 1 || here >= options_.players || late;
    if (!ready) readySince_ = -1;
    if (ready && readySince_ < 0) readySince_ = now;
    if (!ready || now - readySince_ < options_.settle || now - lastReport_ < 1) return Verdict::wait;
    lastReport_ = now;  // once more if it was not heard
    return Verdict::kickOff;
  }

private:
  const GameWatchOptions& options_;
  double begin_, readySince_ = -1, lastReport_ = -10;
};

}  // namespace

const char* gameEndText(GameEnd end) {
  switch (end) {
    case GameEnd::over:
      return "over";
    case GameEnd::interrupted:
      return "interrupted";
    case GameEnd::noPlayers:
      return "no players";
    case GameEnd::hangs:
      return "hangs";
    case GameEnd::overLimit:
      return "over the limit";
    case GameEnd::serverGone:
      return "server gone";
  }
  return "?";
}

GameResult watchGame(const GameWatchOptions& options, const StopSignal& stop,
                     const std::function<void(const SceneState&)>& progress) {
  const double begin = steadySeconds();
  GameResult result;
  const auto end = [&](GameEnd how, std::string problem) {
    result.end = how;
    result.problem = std::move(problem);
    result.wallSeconds = steadySeconds() - begin;
    return result;
  };
  MonitorClient monitor;
  monitor.interruptBy(stop.fileDescriptor());
  if (std::string why = monitor.connect(options.host, options.port); !why.empty()) {
    if (stop.requested()) return end(GameEnd::interrupted, "interrupted");
    return end(GameEnd::serverGone, std::move(why));
  }
  Pulse pulse;
  Starter starter(options);
  double nextProgress = 0;
  while (!stop.requested()) {
    const auto status = monitor.receive(0.5);
    const double now = steadySeconds();
    if (status == Connection::Status::closed && !stop.requested())
      return end(GameEnd::serverGone, monitor.error().empty() ? "the server has gone" : monitor.error());
    if (stop.requested()) break;
    const SceneState& scene = monitor.scene();
    if (status == Connection::Status::message && scene.complete()) {
      pulse.feel(scene, now);
      result.counts.observe(scene);
      if (options.everyScene) options.everyScene(scene);
      result.teamLeft = scene.teamLeft;
      result.teamRight = scene.teamRight;
      result.scoreLeft = scene.scoreLeft;
      result.scoreRight = scene.scoreRight;
      result.gameSeconds = scene.time;
      if (scene.playMode == "GameOver" || (options.endTime > 0 && scene.time >= options.endTime)) {
        if (options.endServer) monitor.send(KillSimulatorCommand{});
        return end(GameEnd::over, "");
      }
      if (progress && now >= nextProgress) {
        progress(scene);
        nextProgress = now + 1;
      }
    }
    const auto verdict = options.kickOff ? starter.look(scene, now) : Starter::Verdict::wait;
    if (verdict == Starter::Verdict::noPlayers)
      return end(GameEnd::noPlayers,
                 "no player came within " + std::to_string(static_cast<int>(options.patience)) + " s");
    if (verdict == Starter::Verdict::kickOff)
      monitor.send(KickOffCommand{scene.half > 1 ? TeamSide::right : TeamSide::left});
    if (now - begin > options.limit)
      return end(GameEnd::overLimit,
                 "no end after " + std::to_string(static_cast<int>(options.limit)) + " s of real time");
    const bool waiting =
        options.kickOff && scene.playMode == "BeforeKickOff" && now - begin < options.patience;
    if (waiting) pulse.restart(now);
    if (pulse.standsFor(now) > options.hang)
      return end(GameEnd::hangs, "nothing has changed for " + std::to_string(static_cast<int>(options.hang)) +
                                     " s: " + std::to_string(scene.robots.size()) + " robots, " +
                                     (scene.playMode.empty() ? "no scene" : scene.playMode));
  }
  return end(GameEnd::interrupted, "interrupted");
}

}  // namespace plumbline::watch
