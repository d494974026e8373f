#include "simulation/referee/RulesFile.h"

#include "framework/ConfigFile.h"

namespace plumbline::simulation {

namespace {

const Range number = Range::atLeast(0);  ///< times, distances, speeds, angles
const Range count = {0, 11};

/// Reads the keys of one section.
class Section {
public:
  Section(const ConfigSection& root_, std::string name_) : root(root_), name(std::move(name_)) {}
  template <typename T>
  const Section& operator()(const char* key, T& value, Range range = {}) const {
    if (const auto found = root.find<T>(name + '.' + key, range)) value = *found;
    return *this;
  }
  const Section& operator()(const char* key, double& value) const {
    return operator()<double>(key, value, number);
  }

private:
  const ConfigSection& root;
  std::string name;
};

}  // namespace

Rules readRules(const std::string& path, const Rules& otherwise) {
  const ConfigFile file(path);
  const ConfigSection& root = file.root();
  Rules r = otherwise;
  Section(root, "time")("half", r.time.half, {0.02, 1e6})("goalPause", r.time.goalPause)(
      "kickPause", r.time.kickPause)("dropBall", r.time.dropBall)("singleHalf", r.time.singleHalf)(
      "changeSides", r.time.changeSides)("quitAfterGame", r.time.quitAfterGame)("waitForKickOff",
                                                                                r.time.waitForKickOff);
  if (const auto after = root.find<double>("kickOff.after", number)) r.kickOff.after = *after;
  Section(root, "kickOff")("byLot", r.kickOff.byLot)("ownHalf", r.kickOff.ownHalf)("noDirectGoal",
                                                                                   r.kickOff.noDirectGoal);
  Section(root, "restarts")("keepDistance", r.restarts.keepDistance)("distance", r.restarts.distance)(
      "moveDistance", r.restarts.moveDistance)("repel", r.restarts.repel)(
      "goalKick", r.restarts.goalKick, {0.05, 10})("doubleTouch", r.restarts.doubleTouch)(
      "noIndirectGoal", r.restarts.noIndirectGoal);
  Section(root, "goals")("on", r.goals.on);
  Section(root, "ballOut")("on", r.ballOut.on);
  Section(root, "pass")("on", r.pass.on)("maxBallSpeed", r.pass.maxBallSpeed)(
      "maxBallDistance", r.pass.maxBallDistance)("minOpponentDistance", r.pass.minOpponentDistance)(
      "duration", r.pass.duration)("scoreWait", r.pass.scoreWait)("retryWait", r.pass.retryWait);
  Section(root, "incapable")("on", r.incapable.on)("notStanding", r.incapable.notStanding)(
      "onGround", r.incapable.onGround)("goalieNotStanding", r.incapable.goalieNotStanding)(
      "goalieOnGround", r.incapable.goalieOnGround);
  Section(root, "illegalDefence")("on", r.illegalDefence.on)(
      "maxInOwnArea", r.illegalDefence.maxInOwnArea, count)("putOutside", r.illegalDefence.putOutside);
  Section(root, "crowding")("on", r.crowding.on)("minOpponent", r.crowding.minOpponent)(
      "minSecond", r.crowding.minSecond)("minThird", r.crowding.minThird);
  Section(root, "touching")("on", r.touching.on)("maxGroup", r.touching.maxGroup, {1, 22})(
      "putOutside", r.touching.putOutside);
  Section(root, "charging")("on", r.charging.on)("minSpeed", r.charging.minSpeed)(
      "minBallAngle", r.charging.minBallAngle)("minDistanceDifference", r.charging.minDistanceDifference)(
      "minAngleDifference", r.charging.minAngleDifference)("immunity", r.charging.immunity)(
      "minInterval", r.charging.minInterval)("maxBallDistance", r.charging.maxBallDistance)(
      "minCollisionBallDistance", r.charging.minCollisionBallDistance)("minCollisionSpeed",
                                                                       r.charging.minCollisionSpeed);
  Section(root, "selfCollision")("on", r.selfCollision.on)("tolerance", r.selfCollision.tolerance)(
      "frozen", r.selfCollision.frozen)("thaw", r.selfCollision.thaw)(
      "putOutside", r.selfCollision.putOutside)("cooldown", r.selfCollision.cooldown);
  Section(root, "moves")("foulHold", r.moves.foulHold)("agentRadius", r.moves.agentRadius)(
      "attempts", r.moves.attempts, {0, 10000})("startAnywhere", r.moves.startAnywhere);
  Section(root, "types")("on", r.types.on)("maxOfOne", r.types.maxOfOne, count)(
      "minDifferent", r.types.minDifferent, {1, 5})("maxOfTwo", r.types.maxOfTwo, count);
  file.checkUnknown();
  return r;
}

}  // namespace plumbline::simulation
