#pragma once
#include <array>

namespace plumbline {

/// Names of the skills that behaviours here ask for, and that a situation's file may expect. Another skill
/// needs no entry: its name is what its SkillOutput says.
struct Skill {
  static constexpr const char* none = "";
  static constexpr const char* stand = "stand";
  static constexpr const char* moveToPos = "moveToPos";
  static constexpr const char* getBall = "getBall";
  static constexpr const char* kick = "kick";
  static constexpr const char* dribble = "dribble";
  static constexpr const char* dive = "dive";
  static constexpr std::array names = {stand, moveToPos, getBall, kick, dribble, dive};
};

}  // namespace plumbline
