#include "bench/walking/Robots.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "bench/walking/MujocoPlant.h"
#include "training/ServoWalker.h"
#include "training/WalkingRobot.h"

namespace plumbline::bench {
namespace {

using namespace walking;

Subject leagueRobot(int type, bool plain) {
  // Sustained forward speed of the better of two teams' published agents on the league's server.
  const double peer[numSimsparkTypes] = {0.83, 0.79, 0.87, 0.82, 0.85};
  Subject subject;
  subject.name = fmt::format("type{}{}", type, plain ? "_plain" : "");
  subject.gaits = plain ? plainWalk() : readWalkGaits(type);
  subject.make = [type](const WalkGaits& gaits) { return std::make_unique<WalkingRobot>(type, gaits); };
  subject.peer = "FC Portugal codebase 2024-10";
  subject.peerForward = peer[type];
  return subject;
}

Subject nao(const std::string& engine) {
  Subject subject;
  subject.name = "nao-" + engine;
  subject.gaits = readServoGaits("nao_v5");
  subject.make = [engine](const WalkGaits& gaits) -> std::unique_ptr<Walker> {
    const Mechanism robot = findMechanism("nao_v5");
    if (engine == "bullet") return std::make_unique<ServoWalker>(robot, gaits);
    return std::make_unique<ServoWalker>(robot, gaits, std::make_unique<MujocoPlant>(robot));
  };
  subject.walkingSpeed = 0.15;
  subject.peer = "B-Human, NAO";
  subject.peerForward = 0.3;
  subject.forward = 0.3;
  subject.backward = 0.15;
  subject.sideways = 0.1;
  subject.turn = 40;
  return subject;
}

}  // namespace

std::vector<std::string> subjectNames() {
  return {"type0",       "type0_plain", "type1",      "type2",     "type3",
          "type3_plain", "type4",       "nao-bullet", "nao-mujoco"};
}

Subject subjectOf(const std::string& name) {
  if (name == "nao-bullet" || name == "nao-mujoco") return nao(name.substr(4));
  for (int type = 0; type < numSimsparkTypes; ++type)
    for (const bool plain : {false, true})
      if (name == fmt::format("type{}{}", type, plain ? "_plain" : "")) return leagueRobot(type, plain);
  throw std::invalid_argument(
      fmt::format("no robot '{}'; there is {}", name, fmt::join(subjectNames(), ", ")));
}

std::vector<Subject> subjects(const std::vector<std::string>& names, bool plain) {
  std::vector<Subject> result;
  for (const std::string& name : names)
    if (plain || !name.ends_with("_plain")) result.push_back(subjectOf(name));
  return result;
}

}  // namespace plumbline::bench
