#include "simspark/PerceptLimits.h"

#include <cmath>

#include "simspark/JointNames.h"

namespace plumbline::simspark {

namespace {

/// Written so that NaN is outside.
bool within(double value, double most) { return std::abs(value) <= most; }
bool within(const Vec3& value, double most) { return value.cwiseAbs().maxCoeff() <= most && !value.hasNaN(); }

bool plausible(const Polar& place) {
  return within(place.distance, maxSeenDistance) && within(place.azimuth, maxJointAngle) &&
         within(place.elevation, maxJointAngle);
}

class Check {
public:
  Check(int& dropped, std::string& first) : dropped_(dropped), first_(first) {}

  /// Counts what is not good; true for it.
  bool bad(bool good, const char* kind, std::string_view name = {}) {
    if (good) return false;
    if (dropped_++ == 0) {
      first_ = kind;
      if (!name.empty()) first_ += " " + std::string(name.substr(0, 20));
    }
    return true;
  }
  void vector(Vec3& value, const Vec3& before, double most, const char* kind) {
    if (bad(within(value, most), kind)) value = before;
  }
  void force(std::optional<ForceReading>& value, const std::optional<ForceReading>& before,
             const char* name) {
    if (value && bad(within(value->point, maxForcePoint) && within(value->force, maxForce), "force", name))
      value = before;
  }

private:
  int& dropped_;
  std::string& first_;
};

void checkSee(See& see, Check& check) {
  std::erase_if(see.objects, [&](const SeenObject& object) {
    return check.bad(plausible(object.position), "seen", object.name);
  });
  std::erase_if(see.lines, [&](const SeenLine& line) {
    return check.bad(plausible(line.a) && plausible(line.b), "seen", "line");
  });
  for (SeenPlayer& player : see.players)
    std::erase_if(player.parts, [&](const SeenBodyPart& part) {
      return check.bad(plausible(part.position), "seen player's", part.name);
    });
}

}  // namespace

int dropImplausible(ServerMessage& message, const ServerMessage& before, std::string& first) {
  int dropped = 0;
  Check check(dropped, first);
  if (check.bad(within(message.gameState.time, maxServerTime), "game time"))
    message.gameState.time = before.gameState.time;
  for (int i = 0; i < numHumanoidJoints; ++i)
    if (message.angle[i] && check.bad(within(*message.angle[i], maxJointAngle), "angle of",
                                      simsparkName(static_cast<JointId>(i)).perceptor))
      message.angle[i].reset();
  check.vector(message.gyro, before.gyro, maxTurnRate, "gyro");
  check.vector(message.acc, before.acc, maxAcceleration, "accelerometer");
  check.force(message.leftFoot, before.leftFoot, "lf");
  check.force(message.rightFoot, before.rightFoot, "rf");
  check.force(message.leftToe, before.leftToe, "lf1");
  check.force(message.rightToe, before.rightToe, "rf1");
  if (message.see) checkSee(*message.see, check);
  std::erase_if(message.heard, [&](const HeardMessage& heard) {
    return check.bad(within(heard.time, maxServerTime) && within(heard.direction, maxJointAngle), "heard");
  });
  if (message.groundTruth) {
    const GroundTruth& truth = *message.groundTruth;
    if (check.bad(within(Vec3(truth.T_world_torso.translation()), maxTrueDistance) &&
                      within(truth.ball, maxTrueDistance) && truth.T_world_torso.matrix().allFinite(),
                  "true state"))
      message.groundTruth.reset();
  }
  return dropped;
}

}  // namespace plumbline::simspark
