#include "training/ServerRobot.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "field/FieldSize.h"
#include "framework/StopSignal.h"
#include "robot/LegKinematics.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::training {
namespace {

constexpr double patience = 10;      // [s]
constexpr double lookEvery = 0.002;  // at the connection that is being left, too [s]
constexpr const char* onlySyn = "(syn)";
constexpr const char* startFirst = "; start bin/simulator --sync or the league's server first";
constexpr long maxUnseen = 4;      // cycles without a scene before one is waited for
constexpr double maxTime = 65536;  // s: from there on the league's clock tells 0.01 s no more
constexpr double fallen = 0.5;     // cosine of a torso's lean
const Vec2 outOfTheWay(14, -9.5);  // of a robot that walks [m, field]
constexpr long clockEvery = 5000;  // cycles: the game never gets to the end of a half

int portOf(const std::string& text, const std::string& whole) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() || port < 1 || port > 65535)
    throw std::invalid_argument("'" + whole +
                                "' is not a server; write HOST:AGENTPORT:MONITORPORT or 'server'");
  return port;
}

/// One robot at a time: those that are in step with each other on one field would be in each other's way.
std::mutex& mutexOf(const std::string& server) {
  static std::mutex guard;
  static std::map<std::string, std::unique_ptr<std::mutex>> all;
  const std::lock_guard lock(guard);
  std::unique_ptr<std::mutex>& mutex = all[server];
  if (!mutex) mutex = std::make_unique<std::mutex>();
  return *mutex;
}

/// Height of an upright torso over its soles' lowest corner [m].
double heightOver(const RobotModel& model, const JointArray& angles) {
  double lowest = 0;
  for (const Side side : {Side::left, Side::right}) {
    const LegKinematics leg(model, side);
    const std::size_t first = side == Side::left ? lHipYawPitch : rHipYawPitch;
    LegAngles joints{};
    for (std::size_t j = 0; j < joints.size(); ++j) joints[j] = angles[first + j];
    const Pose3 sole = leg.sole(joints);
    for (const double x : {-1, 1})
      for (const double y : {-1, 1}) {
        const Vec2 corner = leg.soleHalfSize().cwiseProduct(Vec2(x, y));
        lowest = std::min(lowest, (sole * Vec3(corner.x(), corner.y(), 0)).z());
      }
  }
  return -lowest;
}

std::optional<simulation::FootForce> felt(const std::optional<simspark::ForceReading>& reading) {
  if (!reading) return std::nullopt;
  return simulation::FootForce{reading->point, reading->force};
}

}  // namespace

SimSparkAddress SimSparkAddress::parse(const std::string& text) {
  if (text == "server") return {};
  const std::size_t second = text.rfind(':'),
                    first = second == std::string::npos || second == 0 ? second : text.rfind(':', second - 1);
  if (first == std::string::npos || first == 0 || first == second) portOf("", text);
  return {text.substr(0, first), portOf(text.substr(first + 1, second - first - 1), text),
          portOf(text.substr(second + 1), text)};
}

std::string SimSparkAddress::text() const { return fmt::format("{}:{}:{}", host, agentPort, monitorPort); }

ServerRobot::ServerRobot(int type, const SimSparkAddress& address)
    : type_(type),
      address_(address),
      alone_(mutexOf(address.text())),
      model_(simsparkRobot(type)),
      control_(model_) {
  trainer_.interruptBy(StopSignal::caughtDescriptor());
  if (const std::string why = trainer_.connect(address_.host, address_.monitorPort); !why.empty()) {
    StopSignal::throwIfCaught();
    throw std::runtime_error(why + startFirst);
  }
  join();
}

void ServerRobot::join() {
  leaving_ = std::move(agent_);
  agent_ = {};
  agent_.interruptBy(StopSignal::caughtDescriptor());
  if (const std::string why = agent_.connect(address_.host, address_.agentPort); !why.empty()) {
    StopSignal::throwIfCaught();
    throw std::runtime_error(why + startFirst);
  }
  message_ = {};
  if (leaving_.connected()) leaving_.send(onlySyn);
  simspark::AgentCommand scene, init;
  scene.scene = simspark::SceneRequest{.type = type_};
  exchange(scene);
  leaving_.close();
  init.init = simspark::InitRequest{0, "Plumbline"};
  exchange(init);
  for (int i = 0; i < 20 && !message_.gameState.unum; ++i) exchange({});
  if (!message_.gameState.unum || !message_.gameState.side)
    throw failure("gave the robot no number in a team");
  if (message_.time > maxTime)
    throw failure(
        fmt::format("has been running for {:.0f} s of its time, and its clock in single precision is now too "
                    "coarse; restart it",
                    message_.time));
  const bool left = *message_.gameState.side == "left";
  name_ = {*message_.gameState.unum, left ? simspark::TeamSide::left : simspark::TeamSide::right};
}

std::runtime_error ServerRobot::failure(const std::string& what) const {
  return std::runtime_error("the server at " + address_.text() + ' ' + what);
}

simspark::Connection::Status ServerRobot::receive(std::string_view& text) {
  using Status = simspark::Connection::Status;
  if (!leaving_.connected()) return agent_.receive(text, patience);
  for (double waited = 0; waited < patience; waited += lookEvery) {
    std::string_view ignored;
    if (leaving_.receive(ignored, 0) == Status::message) leaving_.send(onlySyn);
    if (const Status status = agent_.receive(text, lookEvery); status != Status::timeout) return status;
  }
  return Status::timeout;
}

void ServerRobot::exchange(simspark::AgentCommand command) {
  StopSignal::throwIfCaught();
  command.syn = true;
  if (!agent_.send(simspark::writeAgentCommand(command))) throw failure("went away: " + agent_.error());
  std::string_view text;
  const double before = message_.time;
  switch (receive(text)) {
    case simspark::Connection::Status::message:
      break;
    case simspark::Connection::Status::timeout:
      StopSignal::throwIfCaught();
      throw failure(fmt::format("sent nothing for {:.0f} s", patience));
    case simspark::Connection::Status::closed:
      throw failure("went away: " + agent_.error());
  }
  if (const auto error = parser_.parse(text, message_))
    throw failure(
        fmt::format("sent a message that cannot be read, at byte {}: {}", error->position, error->what));
  for (std::size_t j = 0; j < numHumanoidJoints; ++j)
    if (message_.angle[j]) readings_.angle[j] = *message_.angle[j];
  readings_.gyro = message_.gyro;
  readings_.acc = message_.acc;
  readings_.leftFoot = felt(message_.leftFoot);
  readings_.rightFoot = felt(message_.rightFoot);
  readings_.leftToe = felt(message_.leftToe);
  readings_.rightToe = felt(message_.rightToe);
  if (before > 0 && message_.time > before + 1.5 * cycleSeconds) ++lost_;
  if (++cycles_ > 100 && lost_ > cycles_ / 20)
    throw failure("does not wait for its agents; set $agentSyncMode = true in its spark.rb, or use --sync");
  follow();
}

void ServerRobot::follow() {
  // Scenes come every second cycle: how far they are behind must not depend on who runs when.
  double wait = ++unseen_ > maxUnseen ? patience : 0;
  for (;;) {
    const auto status = trainer_.receive(wait);
    if (status == simspark::Connection::Status::closed)
      throw failure("ended the monitor's connection: " + trainer_.error());
    if (status == simspark::Connection::Status::timeout) break;
    wait = 0;
    unseen_ = 0;
  }
  if (wait > 0) throw failure(fmt::format("sent its monitor nothing for {:.0f} s", patience));
  if (const auto* robot = trainer_.scene().robot(name_.side, name_.unum))
    T_world_torso_ = robot->T_world_torso;
}

void ServerRobot::drive(const JointArray& targets) {
  simspark::AgentCommand command;
  const JointArray& speeds = control_.update(readings_.angle, targets, cycleSeconds);
  for (std::size_t j = 0; j < numHumanoidJoints; ++j)
    if (model_.has(static_cast<JointId>(j))) command.velocity[j] = speeds[j];
  if (cycles_ % clockEvery == 0) trainer_.send(simspark::TimeCommand{1});
  exchange(command);
  attitude_.update(readings_.gyro, readings_.acc, cycleSeconds);
}

void ServerRobot::teleport(const Pose2& place, double height) {
  trainer_.send(simspark::MoveAgentCommand{name_, Vec3(place.x(), place.y(), height), place.heading});
}

void ServerRobot::put(const Pose2& place, const JointArray& angles) {
  constexpr int settle = 40;
  drop(place, angles, 0);
  for (int i = 0; i < settle; ++i) drive(angles);
}

void ServerRobot::drop(const Pose2& place, const JointArray& angles, double height) {
  if (T_world_torso_.linear()(2, 2) < fallen) join();
  // A pause frees joints that the referee has frozen. Else they would stay so until the clock, which is set
  // back, has come to where it was.
  trainer_.send(simspark::PlayModeCommand{simspark::PlayMode::beforeKickOff});
  trainer_.send(simspark::TimeCommand{1});
  putBall(outOfTheWay);
  control_.reset();
  // Held in the air until the joints are where they should be.
  constexpr double aloft = 1.5;
  constexpr int ready = 75, pause = 10;
  for (int i = 0; i < ready; ++i) {
    if (i == pause) trainer_.send(simspark::PlayModeCommand{simspark::PlayMode::playOn});
    if (i % 10 == 0) teleport(place, aloft);
    drive(angles);
  }
  teleport(place, heightOver(model_, angles) + height);
  attitude_.reset();
}

void ServerRobot::putBall(const Vec2& place) {
  trainer_.send(simspark::BallCommand{Vec3(place.x(), place.y(), FieldSize().ballRadius), Vec3::Zero()});
}

}  // namespace plumbline::training
