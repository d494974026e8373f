#include "simspark/JointNames.h"

#include <array>

namespace plumbline::simspark {

namespace {

// In the order of JointId.
constexpr std::array<JointName, numHumanoidJoints> names = {{
    {"hj1", "he1", 1},     // HeadYaw
    {"hj2", "he2", -1},    // HeadPitch
    {"laj1", "lae1", -1},  // LShoulderPitch
    {"laj2", "lae2", 1},   // LShoulderRoll
    {"laj3", "lae3", 1},   // LElbowYaw
    {"laj4", "lae4", 1},   // LElbowRoll
    {"raj1", "rae1", -1},  // RShoulderPitch
    {"raj2", "rae2", 1},   // RShoulderRoll
    {"raj3", "rae3", 1},   // RElbowYaw
    {"raj4", "rae4", 1},   // RElbowRoll
    {"llj1", "lle1", 1},   // LHipYawPitch
    {"llj2", "lle2", 1},   // LHipRoll
    {"llj3", "lle3", -1},  // LHipPitch
    {"llj4", "lle4", -1},  // LKneePitch
    {"llj5", "lle5", -1},  // LAnklePitch
    {"llj6", "lle6", 1},   // LAnkleRoll
    {"llj7", "lle7", -1},  // LToePitch
    {"rlj1", "rle1", 1},   // RHipYawPitch
    {"rlj2", "rle2", 1},   // RHipRoll
    {"rlj3", "rle3", -1},  // RHipPitch
    {"rlj4", "rle4", -1},  // RKneePitch
    {"rlj5", "rle5", -1},  // RAnklePitch
    {"rlj6", "rle6", 1},   // RAnkleRoll
    {"rlj7", "rle7", -1},  // RToePitch
}};

/// h|l|r, then a|l for a limb, then `kind`, then a digit: found without comparing with every name.
JointId find(std::string_view name, char kind) {
  if (name.size() < 3) return noJoint;
  const int number = name.back() - '0';
  if (name.size() == 3) {
    if (name[0] != 'h' || name[1] != kind || number < 1 || number > 2) return noJoint;
    return static_cast<JointId>(headYaw + number - 1);
  }
  if (name.size() != 4 || name[2] != kind || number < 1) return noJoint;
  const bool left = name[0] == 'l';
  if (!left && name[0] != 'r') return noJoint;
  if (name[1] == 'a' && number <= 4)
    return static_cast<JointId>((left ? lShoulderPitch : rShoulderPitch) + number - 1);
  if (name[1] == 'l' && number <= 7)
    return static_cast<JointId>((left ? lHipYawPitch : rHipYawPitch) + number - 1);
  return noJoint;
}

}  // namespace

const JointName& simsparkName(JointId joint) { return names[joint]; }
JointId jointByPerceptor(std::string_view perceptor) { return find(perceptor, 'j'); }
JointId jointByEffector(std::string_view effector) { return find(effector, 'e'); }

}  // namespace plumbline::simspark
