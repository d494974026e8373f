#include "gap/record/Excitation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gap/record/Waves.h"
#include "robot/FeltInertias.h"

namespace plumbline::gap {

const char* name(Segment::Kind kind) {
  switch (kind) {
    case Segment::Kind::move:
      return "move";
    case Segment::Kind::triangle:
      return "triangle";
    case Segment::Kind::chirp:
      return "chirp";
    case Segment::Kind::steps:
      return "steps";
    case Segment::Kind::sine:
      return "sine";
    case Segment::Kind::bumps:
      return "bumps";
    case Segment::Kind::multisine:
      return "multisine";
    case Segment::Kind::fast:
      return "fast";
  }
  return "";
}

CommandTable playExcitation(const Excitation& excitation, const Mechanism& robot, double rateHz) {
  if (excitation.walk)
    throw std::invalid_argument(excitation.name + " is a walk: its commands are not known before");
  CommandTable table;
  const auto cycles = static_cast<std::size_t>(std::floor(excitation.duration * rateHz + 1e-9)) + 1;
  for (std::size_t i = 0; i < cycles; ++i) table.t.push_back(static_cast<double>(i) / rateHz);
  table.commands.resize(robot.joints.size());

  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    std::vector<double>& command = table.commands[j];
    command.assign(cycles, excitation.posture[j]);
    // Moves first: each sets a new posture from its start on.
    for (const Segment& segment : excitation.segments) {
      if (segment.kind != Segment::Kind::move) continue;
      for (const auto& [joint, target] : segment.joints) {
        if (joint != static_cast<int>(j)) continue;
        double from = 0;
        bool begun = false;
        for (std::size_t i = 0; i < cycles; ++i) {
          if (table.t[i] < segment.start) continue;
          if (!begun) from = command[i];
          begun = true;
          const double share = segment.duration > 0 ? (table.t[i] - segment.start) / segment.duration : 1;
          command[i] = from + (target - from) * smoothStep(share);
        }
      }
    }
    for (const Segment& segment : excitation.segments) {
      if (segment.kind == Segment::Kind::move) continue;
      for (std::size_t k = 0; k < segment.joints.size(); ++k) {
        const auto [joint, amplitude] = segment.joints[k];
        if (joint != static_cast<int>(j) || amplitude == 0) continue;
        const double most = k < segment.accelerations.size() ? segment.accelerations[k] : 1e9;
        const Wave wave(segment, joint, robot.joints[j].maxSpeed / std::abs(amplitude),
                        most / std::abs(amplitude));
        for (std::size_t i = 0; i < cycles; ++i) {
          const double t = table.t[i] - segment.start;
          if (t >= 0 && t < segment.duration) command[i] += amplitude * wave(t);
        }
      }
    }
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Mechanism::Joint& joint = robot.joints[j];
    if (joint.driver >= 0) {
      table.commands[j] = table.commands[static_cast<std::size_t>(joint.driver)];
      for (double& x : table.commands[j]) x = joint.driven(x);
    }
    const double margin = std::min(limitMargin, 0.01 * (joint.upper - joint.lower));
    for (double& x : table.commands[j]) x = std::clamp(x, joint.lower + margin, joint.upper - margin);
  }
  return table;
}

std::vector<double> gravityTorques(const Mechanism& robot, const std::vector<double>& q) {
  const std::vector<Pose3> poses = linkPoses(robot, q);
  // First moment and mass of all that a link carries, gathered from the leaves.
  std::vector<double> mass(robot.links.size());
  std::vector<Vec3> moment(robot.links.size(), Vec3::Zero());
  std::vector<double> torques(robot.joints.size());
  for (std::size_t l = robot.links.size(); l-- > 0;) {
    const Mechanism::Link& link = robot.links[l];
    mass[l] += link.mass;
    moment[l] += link.mass * (poses[l] * link.com);
    if (l == 0) break;
    const Mechanism::Joint& joint = robot.joints[l - 1];
    const Vec3 axis = poses[l].linear() * joint.axis;
    torques[l - 1] = joint.type == Mechanism::Joint::Type::prismatic
                         ? -axis.dot(mass[l] * robot.gravity)
                         : -axis.dot((moment[l] - mass[l] * poses[l].translation()).cross(robot.gravity));
    const auto parent = static_cast<std::size_t>(link.parent);
    mass[parent] += mass[l];
    moment[parent] += moment[l];
  }
  return torques;
}

std::vector<double> reachableAccelerations(const Mechanism& robot, const std::vector<double>& q) {
  const std::vector<double> inertias = feltInertias(robot, q), gravity = gravityTorques(robot, q);
  std::vector<double> result;
  for (std::size_t j = 0; j < inertias.size(); ++j) {
    const double most = 0.7 * robot.joints[j].maxTorque;
    result.push_back(std::max(0.1 * most, most - std::abs(gravity[j])) / std::max(1e-9, inertias[j]));
  }
  return result;
}

}  // namespace plumbline::gap
