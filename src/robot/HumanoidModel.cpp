#include "robot/HumanoidModel.h"

#include <stdexcept>

#include "math/Index.h"
#include "robot/OwnJoints.h"

namespace plumbline {
namespace {

Mat3 aboutOther(const Mat3& inertia, double mass, const Vec3& offset) {
  return inertia + mass * (offset.squaredNorm() * Mat3::Identity() - offset * offset.transpose());
}

/// Adds a rigid part to a link: mass, centre (in the link's frame) and inertia about that centre.
void join(Link& link, double mass, const Vec3& com, const Mat3& inertia) {
  const double total = link.mass + mass;
  if (!(total > 0)) return;
  if (link.mass == 0) {  // exactly as written
    link.mass = mass;
    link.com = com;
    link.inertia = inertia;
    return;
  }
  const Vec3 centre = (link.mass * link.com + mass * com) / total;
  link.inertia =
      aboutOther(link.inertia, link.mass, link.com - centre) + aboutOther(inertia, mass, com - centre);
  link.mass = total;
  link.com = centre;
}

/// Takes over the shape; without one the link is a point in its centre of mass.
void wear(Link& link, const Mechanism::Link& own) {
  link.shape.T_link_shape = translation(link.com);
  if (own.shape) link.shape = *own.shape;
  link.collides = own.collides;
}

}  // namespace

Humanoid::Humanoid(const Mechanism& mechanism) : mechanismJoints_(mechanism.joints.size()) {
  const auto refuse = [&](const std::string& joint, const char* why) {
    throw std::invalid_argument("robot " + mechanism.name + ", joint " + joint + ": " + why);
  };
  indices_.fill(-1);
  model_.name = mechanism.name;
  model_.linkOfJoint.fill(-1);
  // The model's link that each of the mechanism's belongs to, and where that link's frame is in it.
  std::vector<int> linkOf(mechanism.links.size(), 0);
  std::vector<Vec3> origin(mechanism.links.size(), Vec3::Zero());
  Link torso;
  torso.name = "torso";
  join(torso, mechanism.links[0].mass, mechanism.links[0].com, mechanism.links[0].inertia);
  if (mechanism.links[0].shape) wear(torso, mechanism.links[0]);
  model_.links.push_back(torso);
  const std::vector<JointId> ids = jointNumbers(mechanism);
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Mechanism::Joint& joint = mechanism.joints[j];
    const Mechanism::Link& child = mechanism.links[at(joint.child)];
    if (!joint.rpy.isZero(1e-9)) refuse(joint.name, "its frame is turned in its parent's; it must not be");
    const Vec3 place = origin[at(joint.parent)] + joint.origin;
    const JointId id = ids[j];
    if (id == noJoint) {
      linkOf[at(joint.child)] = linkOf[at(joint.parent)];
      origin[at(joint.child)] = place;
      join(model_.links[at(linkOf[at(joint.parent)])], child.mass, place + child.com, child.inertia);
      continue;
    }
    if (joint.type != Mechanism::Joint::Type::revolute) refuse(joint.name, "a humanoid's joints turn");
    Link link;
    link.name = child.name;
    link.parent = linkOf[at(joint.parent)];
    link.joint = id;
    link.origin = place;
    link.axis = joint.axis;
    link.lower = joint.lower;
    link.upper = joint.upper;
    link.maxSpeed = joint.maxSpeed;
    join(link, child.mass, child.com, child.inertia);
    wear(link, child);
    if (id >= numHumanoidJoints) {
      model_.ownJointNames.resize(maxJoints - numHumanoidJoints);
      model_.ownJointNames[at(id - numHumanoidJoints)] = joint.name;
    }
    indices_[at(id)] = static_cast<int>(j);
    linkOf[at(joint.child)] = model_.linkOfJoint[at(id)] = static_cast<int>(model_.links.size());
    model_.links.push_back(link);
  }
  for (const Mechanism::Foot& foot : mechanism.feet) {
    Link& link = model_.links[at(linkOf[at(foot.link)])];
    const bool humanoid = model_.has(lAnkleRoll) || model_.has(rAnkleRoll);
    if (humanoid && link.joint != lAnkleRoll && link.joint != rAnkleRoll)
      refuse(foot.name, "a foot must be moved by the ankle's roll");
    if (mechanism.links[at(foot.link)].shape) continue;
    link.shape = {Shape::Kind::box, foot.soleSize, translation(origin[at(foot.link)] + foot.soleCentre)};
    link.collides = true;
  }
  const int left = indices_[lHipYawPitch], right = indices_[rHipYawPitch];
  model_.sharedHipYawPitch =
      left >= 0 && right >= 0 &&
      (mechanism.joints[at(right)].driver == left || mechanism.joints[at(left)].driver == right);
}

JointArray Humanoid::toModel(const std::vector<double>& values) const {
  JointArray result{};
  for (std::size_t j = 0; j < maxJoints; ++j)
    if (indices_[j] >= 0) result[j] = values.at(at(indices_[j]));
  return result;
}

std::vector<double> Humanoid::toMechanism(const JointArray& values) const {
  std::vector<double> result(mechanismJoints_, 0);
  for (std::size_t j = 0; j < maxJoints; ++j)
    if (indices_[j] >= 0) result[at(indices_[j])] = values[j];
  return result;
}

std::array<std::size_t, 2> twoFeet(const Mechanism& mechanism, const Humanoid& humanoid) {
  if (mechanism.feet.size() != 2)
    throw std::invalid_argument("robot " + mechanism.name + " has " + std::to_string(mechanism.feet.size()) +
                                " feet; the walk needs two");
  const int left = mechanism.joints[static_cast<std::size_t>(humanoid.mechanismJoint(lAnkleRoll))].child;
  return mechanism.feet[0].link == left ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 0};
}

}  // namespace plumbline
