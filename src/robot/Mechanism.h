#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/Gravity.h"
#include "math/Types.h"
#include "robot/Shape.h"

namespace plumbline {

/// What drives a joint. kp, kd are always the gains of the linear law
///   tau = stiffness * (kp * (cmd - q) - kd * qd).
/// A servo with kp 0 takes no positions: torques alone or, with kd, speeds.
/// With model dcMotor they are the linear equivalent of
///   duty = clamp(kpFirmware * errorGain * (cmd - q), -maxPwm, maxPwm)
///   tau = stiffness * kt * (vin * duty - kt * qd) / R.
/// A prismatic joint has N and m where this says N m and rad.
struct Servo {
  enum class Model { position, dcMotor };
  Model model = Model::position;
  double kp = 0;        ///< [N m/rad]
  double kd = 0;        ///< [N m s/rad]
  double armature = 0;  ///< the rotor's inertia seen at the joint [kg m^2]
  // Of dcMotor alone:
  double kt = 0;          ///< [N m/A], also [V s/rad], at the joint
  double R = 0;           ///< [Ohm]
  double vin = 0;         ///< supply [V]
  double errorGain = 0;   ///< share of the supply per rad and unit of kpFirmware
  double kpFirmware = 0;  ///< gain in the firmware's own unit
  double maxPwm = 0;      ///< largest share of the supply, 0..1
  /// Follows torques that are sent, by a loop about its current, and no positions. Of a recording, not of a
  /// robot's file.
  bool followsTorque = false;

  bool operator==(const Servo&) const = default;
};

/// Any robot as data: a tree of links with one motor per joint and names instead of numbers known in advance.
/// links[0] is the base (the torso of a humanoid); joints[i] moves links[i + 1]; parents come before
/// children.
struct Mechanism {
  struct Link {
    std::string name;
    int parent = -1;               ///< index into links, smaller than the link's own; -1: the base
    double mass = 0;               ///< [kg]
    Vec3 com = Vec3::Zero();       ///< in the link's frame, which sits on the joint that moves it [m]
    Mat3 inertia = Mat3::Zero();   ///< about com, axes of the link's frame [kg m^2]
    std::optional<Shape> shape{};  ///< its body, where the file has one
    bool collides = false;         ///< whether shape takes part in collisions
  };

  struct Joint {
    enum class Type { revolute, prismatic };
    enum class Encoder { motor, link };  ///< side of the gear on which the position is measured
    std::string name;
    Type type = Type::revolute;
    int parent = 0, child = 0;    ///< indices into links
    Vec3 origin = Vec3::Zero();   ///< joint frame in the parent's frame [m]
    Vec3 rpy = Vec3::Zero();      ///< its rotation Rz(rpy.z) Ry(rpy.y) Rx(rpy.x) [rad]
    Vec3 axis = Vec3::UnitZ();    ///< in the joint's frame, length 1
    double lower = 0, upper = 0;  ///< limits [rad]; -+maxTurns for a joint without stops
    double maxTorque = 0;         ///< [N m]
    double maxSpeed = 0;          ///< [rad/s]
    Encoder encoder = Encoder::motor;
    Servo servo;
    double friction = 0;  ///< dry friction, the same at any speed and load [N m]
    double damping = 0;   ///< passive: not of the servo, and outside its torque limit [N m s/rad]
    /// Index of the joint whose motor moves this one too (its position is ratio * the driver's + offset, its
    /// command the driver's); -1: it has its own motor.
    int driver = -1;
    double driverRatio = 1, driverOffset = 0;
    /// Where this joint is, or is commanded to be, when its driver is at q.
    double driven(double q) const { return driverRatio * q + driverOffset; }

    /// Joint frame in the parent link's frame, at position 0.
    Pose3 T_parent_joint() const;
    /// Child link's frame in the parent link's frame, at position q [rad] or [m].
    Pose3 T_parent_child(double q) const;
  };

  struct Imu {
    int link = 0;
    Vec3 gyro = Vec3::Zero(), accelerometer = Vec3::Zero();  ///< positions in the link's frame [m]
    Vec3 rpy = Vec3::Zero();                                 ///< sensor axes in the link's frame [rad]
  };

  struct ForceSensor {
    std::string corner;            ///< FrontLeft, FrontRight, RearLeft, RearRight
    Vec3 position = Vec3::Zero();  ///< in the foot's link frame [m]
  };

  struct Foot {
    std::string name;  ///< as in the channel fsr.<foot>.<corner>
    int link = 0;
    Vec3 soleCentre = Vec3::Zero(),
         soleSize = Vec3::Zero();  ///< box: centre and edge lengths, link frame [m]
    std::vector<ForceSensor> sensors;
  };

  /// A name for a place on a link: what a fixed joint of a URDF joined to it.
  struct Frame {
    std::string name;
    int link = 0;
    Pose3 T_link_frame = Pose3::Identity();
  };

  /// Joints that have something in common, such as where they are or their type of servo.
  struct Group {
    std::string name;
    std::vector<int> joints;  ///< indices, rising
  };

  static constexpr double maxTurns = 1e3;  ///< [rad]

  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Foot> feet;
  std::vector<Group> groups;
  Imu imu;
  bool hasImu = false;
  Vec3 gravity = Vec3(0, 0, -earthGravity);  ///< in the world, z up [m/s^2]
  double controlHz = 100;                    ///< rate of commands and readings

  int numJoints() const { return static_cast<int>(joints.size()); }
  /// Index of the joint of that name, or -1.
  int jointIndex(std::string_view joint) const;
  /// The same; throws std::invalid_argument that names the robot and the nearest name it has.
  int requireJoint(std::string_view joint) const;
  std::vector<std::string> jointNames() const;
  /// Index of the link of that name, or that carries the frame of that name; -1 if there is neither.
  int linkIndex(std::string_view link) const;
  /// Index into feet, or -1.
  int footIndex(std::string_view foot) const;
  double totalMass() const;
  /// Whether there are several motors and all are servos of one type.
  bool sharesServo() const;
  /// The joint whose motor moves a joint: its driver, or itself.
  int motorOf(int joint) const {
    const int driver = joints[static_cast<std::size_t>(joint)].driver;
    return driver < 0 ? joint : driver;
  }
  /// The joint of the only motor; -1 where there are several.
  int onlyMotor() const;
  /// Joints from the base to a link, base first.
  std::vector<int> chain(int link) const;
};

/// Pose of every link's frame in the base's frame for joint positions q (one per joint, else
/// std::invalid_argument).
std::vector<Pose3> linkPoses(const Mechanism& mechanism, const std::vector<double>& q);
/// Centre of mass of the whole robot in the base's frame [m], links posed as linkPoses gives.
Vec3 centreOfMass(const Mechanism& mechanism, const std::vector<Pose3>& T_base_link);

/// Rotation Rz(rpy.z) Ry(rpy.y) Rx(rpy.x), and the angles of a rotation (pitch within +-pi/2).
Mat3 rotationOfRpy(const Vec3& rpy);
Vec3 rpyOfRotation(const Mat3& rotation);

}  // namespace plumbline
