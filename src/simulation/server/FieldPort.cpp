#include "simulation/server/FieldPort.h"

#include <algorithm>
#include <cmath>

#include "framework/Loopback.h"
#include "simspark/FieldMessage.h"

namespace plumbline::simulation {

namespace {
constexpr std::size_t maxViewers = 32;
constexpr std::size_t maxMessage = 1024;  ///< bytes: a token and no more
constexpr std::size_t viewerMayLeave =
    1 << 16;                         ///< bytes a viewer may leave unread; it is sent nothing meanwhile
constexpr double uprightAxis = 0.5;  ///< as in simspark::fieldState
}  // namespace

std::string fieldMessage(const Simulation& simulation) {
  const Game& game = simulation.game();
  simspark::FieldState state;
  state.time = game.time;
  state.half = game.half;
  state.scoreLeft = game.score[0];
  state.scoreRight = game.score[1];
  state.playMode = simspark::playModeName(game.mode);
  state.teamLeft = game.teams[0];
  state.teamRight = game.teams[1];
  state.field = simulation.field();
  state.ball = simulation.world().ball().pose.translation();
  for (const auto& [id, player] : simulation.allPlayers()) {
    const Pose3 torso = simulation.world().torso(player->robot).pose;
    const Vec3 forward = torso.linear().col(0);
    state.robots.push_back({player->side, player->unum, torso.translation().head<2>(),
                            std::atan2(forward.y(), forward.x()), torso.linear()(2, 2) < uprightAxis});
  }
  return simspark::writeFieldMessage(state);
}

FieldPort::Viewer::Viewer(int fd, const std::string& address)
    : client(fd, address, maxMessage, viewerMayLeave) {}

FieldPort::FieldPort(const Config& config, Simulation& simulation, LogFunction log)
    : config_(config),
      simulation_(simulation),
      log_(std::move(log)),
      listener_(config_.address, config_.port) {}

void FieldPort::watch(std::vector<pollfd>& descriptors) {
  descriptors.push_back({listener_.descriptor(), POLLIN, 0});
  for (const auto& viewer : viewers_) descriptors.push_back(viewer->client.watch());
  watched_ = viewers_.size();
}

void FieldPort::serve(const pollfd* events) {
  for (std::size_t i = 0; i < watched_; ++i) {
    if (events[1 + i].revents == 0) continue;
    viewers_[i]->client.serve(events[1 + i].revents);
    receive(*viewers_[i]);
  }
  if (events[0].revents != 0) accept();
}

void FieldPort::accept() {
  std::string address;
  for (std::size_t i = 0; i < mostAccepted; ++i) {
    const int fd = listener_.accept(address);
    if (fd < 0) return;
    viewers_.push_back(std::make_unique<Viewer>(fd, address));
    viewers_.back()->admitted = config_.token.empty();
    makeRoom(
        viewers_, maxViewers, "too many viewers", [this](Viewer& viewer) { receive(viewer); },
        [](const Viewer& viewer) { return !viewer.spoke; });
  }
}

void FieldPort::receive(Viewer& viewer) {
  for (std::string_view message; viewer.client.next(message);) {
    // It has no commands; any message keeps its place when others want it.
    if (!viewer.admitted) viewer.admitted = sameSecret(message, "(token " + config_.token + ")");
    viewer.spoke = viewer.admitted;
    if (!viewer.admitted) return viewer.client.drop("did not name the token");
  }
}

void FieldPort::sendState() {
  if (viewers_.empty()) return;
  const double now = steadySeconds();
  text_.clear();
  for (const auto& viewer : viewers_) {
    if (!viewer->admitted || viewer->client.broken() || now < viewer->nextTime || !viewer->client.idle())
      continue;
    if (text_.empty()) text_ = fieldMessage(simulation_);
    if (viewer->lastMessage == text_) continue;
    viewer->client.send(text_);
    viewer->lastMessage = text_;
    viewer->nextTime = now + simspark::fieldInterval;
  }
}

void FieldPort::dropBroken() {
  const double now = steadySeconds();
  for (const auto& viewer : viewers_)
    if (!viewer->admitted && now - viewer->client.since() > silentTimeout)
      viewer->client.drop("did not name the token");
  std::erase_if(viewers_, [this](const auto& viewer) {
    if (!viewer->client.broken()) return false;
    log_("viewer " + viewer->client.address() + ' ' + viewer->client.reason());
    return true;
  });
}

}  // namespace plumbline::simulation
