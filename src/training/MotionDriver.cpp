#include "training/MotionDriver.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/ModuleParameters.h"
#include "math/Angle.h"
#include "motion/KeyframeReader.h"
#include "motion/MotionDefaults.h"
#include "robot/BodyJoints.h"
#include "simspark/LeagueRobots.h"
#include "training/FeltFeet.h"
#include "training/WalkingRobot.h"

namespace plumbline::training {
namespace {

std::vector<std::filesystem::path> motionDirectories(int type) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& directory : MotionDriver::directories(type))
    paths.emplace_back(directory + "/motions");
  return paths;
}

motion::StandUpParameters readStandUp(int type, const std::vector<motion::KeyframeMotion>& motions) {
  const ConfigFile file("MotionSelector", MotionDriver::directories(type));
  motion::StandUpParameters parameters;
  std::optional<ConfigSection> section;
  if (file.root().has("standUp")) section = file.root().section("standUp");
  if (section) readParameters(*section, motion::StandUpParameters::parameterList(), &parameters);
  file.checkUnknown();
  if (const auto missing = missingStandUp(parameters, motions)) {
    if (section && section->has(missing->parameter)) section->fail(missing->parameter, missing->problem);
    throw ConfigurationError("MotionSelector.standUp." + missing->parameter + " " + missing->problem);
  }
  return parameters;
}

}  // namespace

MotionDriver::MotionDriver(int type)
    : model(simsparkRobot(type)),
      gaits(readLeagueGaits(type)),
      walk(gaits, model),
      stand(walk.stand().angles),
      motions(motion::readMotions(motionDirectories(type), model)),
      standUp(readStandUp(type, motions)) {
  standUpChoice.learn(standUp, motions);
}

std::vector<std::string> MotionDriver::directories(int type) {
  return {configFolder(), configPath("robots/" + simsparkRobotName(type))};
}

void MotionDriver::seedStart(std::uint64_t run, int draw) {
  seed(static_cast<unsigned>(run * 2654435761U + static_cast<unsigned>(draw)));
}

void MotionDriver::seedRun(std::uint64_t run) { seed(static_cast<unsigned>(run * 2246822519U + 1)); }

const motion::KeyframeMotion& MotionDriver::motion(const std::string& name) const {
  if (const motion::KeyframeMotion* found = findMotion(motions, name)) return *found;
  throw std::out_of_range("no motion " + name);
}

double MotionDriver::tilt() const { return std::acos(std::clamp(up().z(), -1.0, 1.0)); }

void MotionDriver::step(const JointArray& targets) {
  move(targets);
  tiltedCycles_ = tilt() > motion::lyingTilt ? tiltedCycles_ + 1 : 0;
  stillness_.update(readings().gyro);
}

bool MotionDriver::play(const motion::KeyframeMotion& motion, bool stopAtFall) {
  player.start(motion, readings().angle);
  while (!player.finished()) {
    player.step(dt, still());
    step(player.angles());
    elapsed += dt;
    if (stopAtFall && lying()) return false;
  }
  return true;
}

double MotionDriver::standStill(double seconds) {
  long tilted = 0;
  const JointArray from = player.angles();
  const long cycles = std::lround(seconds / dt);
  for (long i = 1; i <= cycles; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) * dt / motion::standFade);
    JointArray targets = stand;
    for (std::size_t j = 0; j < maxJoints; ++j) targets[j] = (1 - share) * from[j] + share * stand[j];
    step(targets);
    elapsed += dt;
    if (!upright()) tilted = i;
  }
  return static_cast<double>(tilted) * dt;
}

bool MotionDriver::walkFor(double seconds, const Vec2& velocity, double turn) {
  beginWalk();
  for (long i = std::lround(seconds / dt); i > 0; --i) {
    walkStep(velocity, turn);
    if (lying()) return false;
  }
  return true;
}

walking::WalkOutput MotionDriver::walkStep(const Vec2& velocity, double turn, bool go) {
  const walking::WalkOutput output = walkOutput(velocity, turn, go);
  step(output.angles);
  return output;
}

walking::WalkOutput MotionDriver::walkOutput(const Vec2& velocity, double turn, bool go) {
  walking::WalkSensors sensors;
  sensors.angles = readings().angle;
  const Vec3 u = feltUp();
  sensors.torsoAngles = Vec2(std::atan2(u.y(), u.z()), std::atan2(-u.x(), u.z()));
  sensors.gyro = readings().gyro;
  sensors.feet = feltFeet(readings());
  return walk.update({velocity, turn, go}, sensors);
}

const motion::KeyframeMotion& MotionDriver::nextStandUp(bool again) {
  return motion(standUpChoice.next(standUp, motion::lyingOn(up()), again));
}

void MotionDriver::forget() {
  walk =
      walking::WalkEngine(gaits, model);  // its reset() keeps what it learnt and the foot of its first step
  tiltedCycles_ = 0;
  stillness_ = {};
}

JointArray MotionDriver::jitter(double size) {
  JointArray angles = stand;
  for (int j = firstBodyJoint; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (!model.has(joint)) continue;
    const Link& link = model.linkMovedBy(joint);
    angles[joint] = std::clamp(angles[joint] + random(-size, size), link.lower + 0.02, link.upper - 0.02);
  }
  return angles;
}

}  // namespace plumbline::training
