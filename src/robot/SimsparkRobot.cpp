// The robots of the RoboCup 3D simulation league (rcssserver3d 0.7.3: naorobottypes.rb and the nao*.rsg
// scenes). The league places a child's body relative to its parent's body and the joint relative to the
// child's body; here both become link frames on the joints, in axes forward, left, up.
#include <stdexcept>

#include "math/Angle.h"
#include "robot/RobotModel.h"

namespace plumbline {
namespace {

struct TypeParameters {
  double hipY, thighZ, ankleZ, elbowX;     ///< distances of body centres [m]
  double anklePitchSpeed, ankleRollSpeed;  ///< [rad/s]
  double footX;                            ///< of the foot's body before the ankle's [m]
  double footLength, footMass, toeLength;  ///< [m, kg, m]; no toe: length 0
};

/// [rad/s] 351.77 deg/s for all joints, but for the ankles the file of types has four digits only.
constexpr double normalSpeed = fromDegrees(351.77), ankleSpeed = 6.1395;
constexpr double toeMass = 0.022199;
constexpr TypeParameters types[numSimsparkTypes] = {
    {0.055, -0.04, -0.055, 0.07, ankleSpeed, ankleSpeed, 0.03, 0.16, 0.2, 0},
    {0.055, -0.05832, -0.07332, 0.10664, ankleSpeed, ankleSpeed, 0.03, 0.16, 0.2, 0},
    {0.055, -0.04, -0.055, 0.07, 8.80667, 3.47234, 0.03, 0.16, 0.2, 0},
    {0.072954143, -0.067868424, -0.082868424, 0.125736848, ankleSpeed, ankleSpeed, 0.03, 0.16, 0.2, 0},
    {0.055, -0.04, -0.055, 0.07, ankleSpeed, ankleSpeed, 0.012241172, 0.124482344, 0.177801, 0.035517656}};

Shape box(double x, double y, double z) { return {Shape::Kind::box, Vec3(x, y, z), Pose3::Identity()}; }
Shape sphere(double radius) { return {Shape::Kind::sphere, Vec3(radius, 0, 0), Pose3::Identity()}; }
Shape capsule(double radius, double length) {
  return {Shape::Kind::capsule, Vec3(radius, 0, length), Pose3::Identity()};
}

/// Inertia of a homogeneous body about its centre, as ODE's dMassSet...Total gives it.
Mat3 inertiaOf(const Shape& shape, double mass) {
  const Vec3 s = shape.size;
  const double r = s.x(), l = s.z();
  Vec3 diagonal = Vec3::Zero();
  switch (shape.kind) {
    case Shape::Kind::box: {
      const Vec3 q = s.cwiseAbs2();
      diagonal = mass / 12.0 * Vec3(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
      break;
    }
    case Shape::Kind::sphere:
      diagonal.setConstant(0.4 * mass * r * r);
      break;
    case Shape::Kind::capsule: {
      const double cylinder = mass * l / (l + 4.0 / 3.0 * r), caps = mass - cylinder;
      const double across =
          cylinder * (r * r / 4 + l * l / 12) + caps * (0.4 * r * r + 0.375 * r * l + l * l / 4);
      diagonal = Vec3(across, across, (0.5 * cylinder + 0.4 * caps) * r * r);
      break;
    }
  }
  return diagonal.asDiagonal();
}

class Builder {
public:
  RobotModel model;

  Builder() { model.linkOfJoint.fill(-1); }

  void root(const Shape& shape, double mass) {
    Link link;
    link.name = "torso";
    add(link, shape, mass, Vec3::Zero(), true);
  }

  /// bodyOffset: child's body centre in the parent's body frame; anchor: joint in the child's body frame.
  void child(const std::string& name, const std::string& parent, JointId joint, const Vec3& bodyOffset,
             const Vec3& anchor, const Vec3& axis, double lowerDegrees, double upperDegrees,
             const Shape& shape, double mass, bool collides, double maxSpeed = normalSpeed) {
    Link link;
    link.name = name;
    link.parent = model.linkIndex(parent);
    link.joint = joint;
    link.origin = model.links[static_cast<std::size_t>(link.parent)].com + bodyOffset + anchor;
    link.axis = axis.normalized();
    link.lower = fromDegrees(lowerDegrees);
    link.upper = fromDegrees(upperDegrees);
    link.maxSpeed = maxSpeed;
    model.linkOfJoint[joint] = static_cast<int>(model.links.size());
    add(link, shape, mass, -anchor, collides);
  }

private:
  void add(Link link, const Shape& shape, double mass, const Vec3& com, bool collides) {
    link.mass = mass;
    link.com = com;
    link.inertia = inertiaOf(shape, mass);
    link.shape = shape;
    link.shape.T_link_shape = translation(com);
    link.collides = collides;
    model.links.push_back(link);
  }
};

JointId after(JointId first, int steps) { return static_cast<JointId>(first + steps); }

void addArm(Builder& b, Side side, const TypeParameters& t) {
  const bool left = side == Side::left;
  const double y = left ? 1 : -1;  // towards the outside
  const std::string p = left ? "l" : "r";
  const JointId first = left ? lShoulderPitch : rShoulderPitch;
  const Vec3 o = Vec3::Zero();
  // Shoulder roll and elbow roll turn about the vertical axis because the arms point forward at zero.
  const double rollLower = left ? -1 : -95, rollUpper = left ? 95 : 1;
  const double elbowLower = left ? -90 : -1, elbowUpper = left ? 1 : 90;
  b.child(p + "Shoulder", "torso", first, {0, y * 0.098, 0.075}, o, Vec3::UnitY(), -120, 120, sphere(0.01),
          0.07, false);
  b.child(p + "UpperArm", p + "Shoulder", after(first, 1), {0.02, y * 0.01, 0}, {-0.02, -y * 0.01, 0},
          Vec3::UnitZ(), rollLower, rollUpper, box(0.08, 0.07, 0.06), 0.15, true);
  b.child(p + "Elbow", p + "UpperArm", after(first, 2), {t.elbowX, -y * 0.01, 0.009}, o, Vec3::UnitX(), -120,
          120, sphere(0.01), 0.035, false);
  b.child(p + "LowerArm", p + "Elbow", after(first, 3), {0.05, 0, 0}, {-0.05, 0, 0}, Vec3::UnitZ(),
          elbowLower, elbowUpper, box(0.11, 0.05, 0.05), 0.2, true);
}

void addLeg(Builder& b, Side side, const TypeParameters& t) {
  const bool left = side == Side::left;
  const double y = left ? 1 : -1;
  const std::string p = left ? "l" : "r";
  const JointId first = firstLegJoint(side);
  const Vec3 o = Vec3::Zero();
  // Rolls have limits mirrored between the sides; 45 degrees to the outside, 25 to the inside.
  const double hipLower = left ? -25 : -45, hipUpper = left ? 45 : 25;
  const double ankleLower = left ? -45 : -25, ankleUpper = left ? 25 : 45;
  b.child(p + "Hip1", "torso", first, {-0.01, y * t.hipY, -0.115}, o, {0, 1, -y}, -90, 1, sphere(0.01), 0.09,
          false);
  b.child(p + "Hip2", p + "Hip1", after(first, 1), o, o, Vec3::UnitX(), hipLower, hipUpper, sphere(0.01),
          0.125, false);
  b.child(p + "Thigh", p + "Hip2", after(first, 2), {0.01, 0, t.thighZ}, {-0.01, 0, -t.thighZ}, Vec3::UnitY(),
          -100, 25, box(0.07, 0.07, 0.14), 0.275, true);
  b.child(p + "Shank", p + "Thigh", after(first, 3), {0.005, 0, -0.125}, {-0.01, 0, 0.045}, Vec3::UnitY(), -1,
          130, box(0.07, 0.08, 0.11), 0.225, true);
  b.child(p + "Ankle", p + "Shank", after(first, 4), {-0.01, 0, t.ankleZ}, o, Vec3::UnitY(), -75, 45,
          sphere(0.01), 0.125, false, t.anklePitchSpeed);
  b.child(p + "Foot", p + "Ankle", after(first, 5), {t.footX, 0, -0.04}, {-0.03, 0, 0.035}, Vec3::UnitX(),
          ankleLower, ankleUpper, box(t.footLength, 0.08, 0.02), t.footMass, true, t.ankleRollSpeed);
  if (t.toeLength > 0)
    b.child(p + "Toe", p + "Foot", after(first, 6), {0.08, 0, -0.005}, {-t.toeLength / 2, 0, -0.005},
            Vec3::UnitY(), -70, 1, box(t.toeLength, 0.08, 0.01), toeMass, true);
}

}  // namespace

RobotModel simsparkRobot(int type) {
  if (type < 0 || type >= numSimsparkTypes)
    throw std::out_of_range("SimSpark has robot types 0 to 4, not " + std::to_string(type));
  const TypeParameters& t = types[type];
  Builder b;
  b.model.name = "simspark" + std::to_string(type);
  b.root(box(0.1, 0.1, 0.18), 1.2171);
  b.child("neck", "torso", headYaw, {0, 0, 0.09}, Vec3::Zero(), Vec3::UnitZ(), -120, 120,
          capsule(0.015, 0.08), 0.05, true);
  b.child("head", "neck", headPitch, {0, 0, 0.065}, {0, 0, -0.005}, Vec3::UnitY(), -45, 45, sphere(0.065),
          0.35, true);
  for (const Side side : {Side::left, Side::right}) addArm(b, side, t);
  for (const Side side : {Side::left, Side::right}) addLeg(b, side, t);
  return b.model;
}

}  // namespace plumbline
