#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "math/Gravity.h"
#include "robot/Mechanism.h"

namespace plumbline {

/// A robot as its files name it, before it is sorted and checked: what the readers of the two forms share.
/// Indices of Mechanism's parts are not set; names are used instead.
struct MechanismParts {
  struct Joint {
    Mechanism::Joint joint;
    std::string parent, child;
    std::string driver;
    std::string servoType;
    bool fixed = false;
    bool hasServo = false;
    bool isDriven = false;  ///< of a model of MuJoCo: it has an actuator, or follows a joint with one
    double dampRatio = 0;   ///< of its critical damping at zero, added to the servo's kd when assembled
  };
  struct Foot {
    Mechanism::Foot foot;
    std::string link;
  };

  struct Group {
    std::string name;
    std::vector<std::string> joints;
  };

  std::string name, base, imuLink;
  std::vector<Mechanism::Link> links;
  std::vector<Joint> joints;
  std::vector<Foot> feet;
  std::vector<Group> groups;
  Mechanism::Imu imu;
  Vec3 gravity = Vec3(0, 0, -earthGravity);
  double controlHz = 100;
  std::vector<std::string> warnings;  ///< about what a file says and the nominal model does not have

  Joint* find(const std::string& joint);
};

/// Sorts, joins what fixed joints hold together, and checks. `file` is named in errors.
Mechanism assemble(const MechanismParts& parts, const std::string& file);

/// Reads a whole JSON robot.
MechanismParts partsOfJson(const nlohmann::json& json, const std::string& file);
/// Reads a URDF; servos are still missing.
MechanismParts partsOfUrdf(const std::string& text, const std::string& file);
/// Reads a model of MuJoCo (MJCF); servos are those of its position actuators. A joint without one has no
/// gain.
MechanismParts partsOfMjcf(const std::string& text, const std::string& file);
/// Adds a servo table to a URDF's parts.
void applyServoTable(const nlohmann::json& table, const std::string& file, MechanismParts& parts);

/// An axis that has length 1 but for rounding stays as it is, so that a file can hold one to the last digit.
Vec3 unitAxis(const Vec3& axis);

[[noreturn]] void failMechanism(const std::string& file, const std::string& what);
std::string numberText(double value);

/// Names what a column of a recording or a file can carry: throws for an empty one, a long one, dots, commas,
/// slashes, quotes, blanks.
void checkName(const std::string& name, const std::string& what, const std::string& file);

}  // namespace plumbline
