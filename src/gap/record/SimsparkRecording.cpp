#include "gap/record/SimsparkRecording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "framework/StopSignal.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/record/Waves.h"
#include "math/Gravity.h"
#include "robot/JointId.h"
#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/ServerMessageParser.h"

namespace plumbline::gap {

namespace {

constexpr double cycle = 0.02, approach = 2.5, rest = 0.5;  // [s]

JointId jointOf(const std::string& name, const Mechanism& robot) {
  if (const JointId joint = humanoidJoint(name); joint != noJoint) return joint;
  throw std::invalid_argument(robot.name + " has a joint " + name + " that SimSpark's robots do not have");
}

class Session {
public:
  Session(const Mechanism& robot, const SimsparkRecordingOptions& options)
      : robot_(robot), options_(options) {
    for (const Mechanism::Joint& joint : robot_.joints) ids_.push_back(jointOf(joint.name, robot_));
    angles_.resize(ids_.size());
    speeds_.resize(ids_.size());
    connection_.interruptBy(StopSignal::caughtDescriptor());
    if (const std::string why = connection_.connect(options_.host, options_.port, options_.timeout);
        !why.empty()) {
      endIfStopped();
      throw std::runtime_error(why + "; start bin/simulator or the league's server first");
    }
    simspark::AgentCommand scene;
    scene.scene = simspark::SceneRequest{.type = options_.type};
    scene.syn = true;
    send(scene);
    receive();
    simspark::AgentCommand init;
    init.init = simspark::InitRequest{options_.number, options_.team};
    init.syn = true;
    send(init);
  }

  /// Waits for the next message.
  const simspark::ServerMessage& receive() {
    std::string_view text;
    endIfStopped();
    switch (connection_.receive(text, options_.timeout)) {
      case simspark::Connection::Status::message:
        break;
      case simspark::Connection::Status::timeout:
        endIfStopped();
        throw std::runtime_error("the server on port " + std::to_string(options_.port) +
                                 " sent nothing for " + std::to_string(static_cast<int>(options_.timeout)) +
                                 " s");
      case simspark::Connection::Status::closed:
        throw std::runtime_error("the server on port " + std::to_string(options_.port) +
                                 " ended the connection: " + connection_.error());
    }
    if (const auto error = parser_.parse(text, message_))
      throw std::runtime_error("the server sent a message that cannot be read, at byte " +
                               std::to_string(error->position) + ": " + error->what);
    for (std::size_t j = 0; j < ids_.size(); ++j)
      if (const auto& angle = message_.angle[ids_[j]]) angles_[j] = *angle;
    return message_;
  }

  /// Answers the last message: every joint moves to its target as by the servo law, dq/dt = kp/kd (target -
  /// q). It starts from its position when the answer takes effect, one cycle later; until then it moves at
  /// the speed of the previous answer.
  void drive(const std::vector<double>& targets, const std::optional<Pose2>& beam = {}) {
    simspark::AgentCommand command;
    command.beam = beam;
    for (std::size_t j = 0; j < ids_.size(); ++j) {
      const Mechanism::Joint& joint = robot_.joints[j];
      const double way = 1 - std::exp(-cycle * joint.servo.kp / joint.servo.kd);  // share of it in a cycle
      const double then = std::clamp(angles_[j] + cycle * speeds_[j], joint.lower, joint.upper);
      speeds_[j] = std::clamp(way * (targets[j] - then) / cycle, -joint.maxSpeed, joint.maxSpeed);
      command.velocity[ids_[j]] = speeds_[j];
    }
    command.syn = true;
    send(command);
  }

  const std::vector<double>& angles() const { return angles_; }

private:
  void endIfStopped() const {
    if (options_.stop && options_.stop()) throw std::runtime_error("stopped; nothing was written");
  }
  void send(const simspark::AgentCommand& command) {
    if (!connection_.send(simspark::writeAgentCommand(command)))
      throw std::runtime_error("the server on port " + std::to_string(options_.port) +
                               " ended the connection: " + connection_.error());
  }

  const Mechanism& robot_;
  const SimsparkRecordingOptions& options_;
  std::vector<JointId> ids_;
  std::vector<double> angles_, speeds_;  ///< per joint: as last heard, as last commanded
  simspark::Connection connection_;
  simspark::ServerMessageParser parser_;
  simspark::ServerMessage message_;
};

/// Forces on a sole's corners with the reading's sum and point.
void writeForces(Run& run, std::size_t row, const Mechanism::Foot& foot,
                 const std::optional<simspark::ForceReading>& reading) {
  for (const Mechanism::ForceSensor& sensor : foot.sensors) {
    double& value = run.channels[channelName(ChannelKind::force, foot.name + "." + sensor.corner)][row];
    value = 0;
    if (!reading) continue;
    const auto share = [&](int axis) {
      const double half = std::abs(sensor.position[axis] - foot.soleCentre[axis]);
      const double at =
          std::clamp((reading->point[axis] - foot.soleCentre[axis]) / std::max(1e-6, half), -1.0, 1.0);
      return 0.5 * (1 + (sensor.position[axis] > foot.soleCentre[axis] ? at : -at));
    };
    value = reading->force.z() * share(0) * share(1);
  }
}

}  // namespace

std::size_t cyclesBetween(double before, double now) {
  const double cycles = (now - before) / cycle;
  // 0.03 s are one cycle still, not two.
  return cycles < 0.25
             ? 0
             : static_cast<std::size_t>(std::max<long>(1, std::lround(std::min(cycles, 1e6) - 0.01)));
}

SimsparkRecording recordSimspark(const Mechanism& robot, const Excitation& program,
                                 const SimsparkRecordingOptions& options) {
  if (!program.freeBase)
    throw std::invalid_argument(program.name +
                                " is for a robot with a fixed base; SimSpark's robots stand: use a program "
                                "on the feet, such as stand_squat");
  SimsparkRecording result;
  result.run = blankRun(robot, program, 1 / cycle);
  Run& run = result.run;
  const std::vector<double> planned = run.t;
  const CommandTable table = playExcitation(program, robot, 1 / cycle);
  std::vector<double> targets(robot.joints.size());

  Session session(robot, options);
  // On its feet at its place, then slowly to where the program begins.
  const Pose2 place(Vec2(-7, 0), program.heading);
  std::vector<double> start;
  const auto steps = static_cast<int>((approach + rest) / cycle);
  for (int i = 0; i < steps; ++i) {
    session.receive();
    if (i == 0) {
      session.drive(session.angles(), place);
      continue;
    }
    if (start.empty()) start = session.angles();
    const double share = smoothStep(i * cycle / approach);
    for (std::size_t j = 0; j < targets.size(); ++j)
      targets[j] = start[j] + share * (table.commands[j].front() - start[j]);
    session.drive(targets);
  }

  double last = 0;
  std::vector<std::size_t> kept;  // planned cycles whose message came
  for (std::size_t k = 0; k < planned.size();) {
    const simspark::ServerMessage& message = session.receive();
    // The clock says which cycle this is: a message that was lost must not shift what follows.
    const std::size_t now = kept.empty() ? 0 : kept.back() + cyclesBetween(last, message.time);
    last = message.time;
    if (now >= planned.size()) break;
    if (!kept.empty() && now == kept.back()) {
      session.drive(targets);  // the clock stood still
      continue;
    }
    if (!kept.empty()) result.lostCycles += now - kept.back() - 1;
    k = now;
    kept.push_back(k);
    for (std::size_t j = 0; j < targets.size(); ++j) {
      targets[j] = table.commands[j][k];
      run.channels[channelName(ChannelKind::position, robot.joints[j].name)][k] = session.angles()[j];
    }
    constexpr std::array axes = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      run.channels[channelName(ChannelKind::gyro, axes[static_cast<std::size_t>(axis)])][k] =
          message.gyro[axis];
      run.channels[channelName(ChannelKind::acceleration, axes[static_cast<std::size_t>(axis)])][k] =
          message.acc[axis];
    }
    for (const Mechanism::Foot& foot : robot.feet)
      writeForces(run, k, foot, foot.name.starts_with("L") ? message.leftFoot : message.rightFoot);
    result.fell = result.fell || (k > 10 && message.acc.z() < 0.5 * message.acc.norm() &&
                                  std::abs(message.acc.norm() - earthGravity) < 3);
    session.drive(targets);
    ++k;
  }
  // Cycles that never came are left out: the times have gaps there.
  const auto keep = [&](std::vector<double>& values) {
    std::vector<double> left;
    left.reserve(kept.size());
    for (const std::size_t k : kept) left.push_back(values[k]);
    values = std::move(left);
  };
  keep(run.t);
  for (auto& [name, values] : run.channels) keep(values);
  run.timing["*"].cmdAt = cycle;
  run.motion += "; a robot of type " + std::to_string(options.type) + " of a SimSpark server";
  if (result.lostCycles > 0) run.motion += ", " + std::to_string(result.lostCycles) + " cycles lost";
  return result;
}

}  // namespace plumbline::gap
