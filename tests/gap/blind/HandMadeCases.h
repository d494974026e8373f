#pragma once
#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// Two hips on one motor, and a knee.
inline Mechanism twoHips() {
  Mechanism robot;
  robot.joints.resize(3);
  robot.joints[0].name = "LHip";
  robot.joints[1].name = "RHip";
  robot.joints[1].driver = 0;
  robot.joints[2].name = "Knee";
  return robot;
}

inline BlindCase caseOf(BlindKind kind, std::vector<BlindEffect> effects, double ratio = 8) {
  BlindCase c;
  c.kind = kind;
  c.effects = std::move(effects);
  c.ratio = ratio;
  return c;
}

inline BlindAnswer answer(const char* verdict, std::vector<BlindAnswer::Named> effects = {},
                          double closed = 0) {
  return {"", verdict, std::move(effects), closed};
}

inline BlindAnswer::Named named(const char* effect, const char* at, double value, double probability,
                                std::vector<NamedCause> rivals = {}) {
  return {{effect, at, "", value, probability}, std::move(rivals)};
}

}  // namespace plumbline::gap
