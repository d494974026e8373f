#include "bench/walking/Subjects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "bench/walking/NoisySensors.h"
#include "simspark/LeagueRobots.h"
#include "training/ServerWalker.h"
#include "training/ServoWalker.h"
#include "training/WalkingRobot.h"

namespace plumbline::bench {
namespace {

using namespace walking;
using namespace training;

Subject leagueRobot(int type, bool plain) {
  // Sustained forward speed of the better of two teams' published agents on the league's server.
  const double peer[] = {0.83, 0.79, 0.87, 0.82, 0.85};
  Subject subject;
  subject.name = fmt::format("type{}{}", type, plain ? "_plain" : "");
  subject.gaits = plain ? plainWalk() : readLeagueGaits(type);
  subject.make = [type](const WalkGaits& gaits) { return std::make_unique<WalkingRobot>(type, gaits); };
  subject.peer = "FC Portugal codebase 2024-10";
  subject.peerForward = peer[type];
  return subject;
}

/// type0@server, type3_plain@HOST:AGENTPORT:MONITORPORT: the same robot on a SimSpark server.
Subject onServer(const std::string& name) {
  const std::size_t at = name.find('@');
  const training::SimSparkAddress server = training::SimSparkAddress::parse(name.substr(at + 1));
  Subject subject = subjectOf(name.substr(0, at));
  if (!subject.name.starts_with("type")) throw std::invalid_argument("no server has a robot '" + name + "'");
  const int type = subject.name[4] - '0';
  subject.name += "@server";
  subject.onServer = true;
  subject.make = [type, server](const WalkGaits& gaits) {
    return std::make_unique<ServerWalker>(type, gaits, server);
  };
  return subject;
}

Subject nao(const std::string& engine) {
  Subject subject;
  subject.name = "nao-" + engine;
  subject.gaits = readServoGaits("nao_v5");
  subject.make = [engine](const WalkGaits& gaits) -> std::unique_ptr<Walker> {
    const Mechanism robot = findMechanism("nao_v5");
    if (engine == "bullet") return std::make_unique<ServoWalker>(robot, gaits);
    return std::make_unique<ServoWalker>(
        robot, gaits, std::make_unique<NoisySensors>(servo::RobotSimulations::make("mujoco", robot)));
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
  if (name.find('@') != std::string::npos) return onServer(name);
  if (name == "nao-bullet" || name == "nao-mujoco") return nao(name.substr(4));
  for (int type = 0; type < numSimsparkTypes(); ++type)
    for (const bool plain : {false, true})
      if (name == fmt::format("type{}{}", type, plain ? "_plain" : "")) return leagueRobot(type, plain);
  throw std::invalid_argument(fmt::format("no robot '{}'; there is {}, and typeN@server on a SimSpark server",
                                          name, fmt::join(subjectNames(), ", ")));
}

std::vector<Subject> subjects(const std::vector<std::string>& names, bool plain) {
  std::vector<Subject> result;
  for (const std::string& name : names) {
    Subject subject = subjectOf(name);
    if (plain || subject.name.find("_plain") == std::string::npos) result.push_back(std::move(subject));
  }
  return result;
}

std::vector<Subject> embedded(std::vector<Subject> subjects) {
  std::erase_if(subjects, [](const Subject& subject) { return subject.onServer; });
  return subjects;
}

}  // namespace plumbline::bench
