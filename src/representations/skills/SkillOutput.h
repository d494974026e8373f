#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Pose2.h"
#include "representations/behavior/Skill.h"
#include "representations/motion/Motion.h"
#include "robot/JointId.h"

namespace plumbline {

/// How the robot must stand at the ball before a skill begins. none: anywhere. Otherwise with the requested
/// heading, with its kicking foot behind the ball and facing the kick's direction, or with the ball ahead and
/// facing its direction.
enum class BallApproach : std::uint8_t { none, heading, kick, dribble };

/// What a skill wants of the motions. A new skill is a module that provides a representation of this kind,
/// and a line in modules.cfg:
///
///     REPRESENTATION_OF(SkillPassOutput, SkillOutput)
///     class SkillPassOutput : public SkillPassOutputBase {
///     public:
///       SkillPassOutput() : SkillPassOutputBase("pass", "passing", BallApproach::kick) {}
///     };
class SkillOutput : public Representation {
public:
  static constexpr const char* kindName() { return "SkillOutput"; }

  std::string skill;          ///< name by which SkillRequest asks for it; never changes
  std::string doing;          ///< for people: "going to kick"; never changes
  BallApproach approach;      ///< never changes; SkillGetBall walks there
  bool goesToTarget = false;  ///< the robot itself is to be at the request's target; never changes

  /// Whether the request's target is where the ball is to go.
  bool playsBall() const { return approach == BallApproach::kick || approach == BallApproach::dribble; }

  bool active = false;  ///< it is asked for
  std::string motion = Motion::stand;
  Vec2 walkVelocity = Vec2::Zero();  ///< [m/s]
  double walkTurn = 0;               ///< [rad/s]
  std::string specialAction;         ///< where motion is Motion::specialAction
  bool atOnce = false;               ///< the motion does not wait until a walk has stopped
  std::string kick;                  ///< where motion is Motion::kick
  Side kickFoot = Side::right;
  Vec2 kickBall = Vec2::Zero();  ///< the ball relative to the robot [m]

  /// Neither active nor moving.
  void clear() { want(false, Motion::stand); }
  /// As another skill wants it, but for its name.
  void takeOver(const SkillOutput& other) {
    want(other.active, other.motion);
    walkVelocity = other.walkVelocity;
    walkTurn = other.walkTurn;
    specialAction = other.specialAction;
    atOnce = other.atOnce;
    kick = other.kick;
    kickFoot = other.kickFoot;
    kickBall = other.kickBall;
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(skill);
    STREAM(doing);
    STREAM(approach);
    STREAM(active);
    STREAM(motion);
    STREAM(walkVelocity);
    STREAM(walkTurn);
    STREAM(specialAction);
    STREAM(atOnce);
    STREAM(kick);
    STREAM(kickFoot);
    STREAM(kickBall);
  }

protected:
  SkillOutput(std::string name, std::string words, BallApproach ballApproach = BallApproach::none)
      : skill(std::move(name)), doing(std::move(words)), approach(ballApproach) {}
  ~SkillOutput() = default;

private:
  void want(bool isActive, const std::string& wanted) {
    active = isActive;
    motion = wanted;
    walkVelocity = Vec2::Zero();
    walkTurn = 0;
    specialAction.clear();
    atOnce = false;
    kick.clear();
    kickFoot = Side::right;
    kickBall = Vec2::Zero();
  }
};

/// The one of that name; null: nobody provides the skill.
inline const SkillOutput* findSkill(const std::vector<const SkillOutput*>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &SkillOutput::skill);
  return found == all.end() ? nullptr : *found;
}

}  // namespace plumbline
