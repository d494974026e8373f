#include "robot/UrdfWriter.h"

#include <tinyxml2.h>

#include <cmath>

#include "parameters/Range.h"

namespace plumbline {
namespace {

std::string numbers(const Vec3& v) {
  return shortestText(v.x()) + ' ' + shortestText(v.y()) + ' ' + shortestText(v.z());
}

/// Turns about the fixed axes x, then y, then z, as URDF has it.
std::string rollPitchYaw(const Mat3& r) {
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  return numbers({std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))});
}

class Writer {
public:
  std::string write(const RobotModel& model) {
    printer_.OpenElement("robot");
    attribute("name", model.name);
    for (const Link& link : model.links) writeLink(link);
    for (std::size_t i = 1; i < model.links.size(); ++i) writeJoint(model, model.links[i]);
    printer_.CloseElement();
    return printer_.CStr();
  }

private:
  void attribute(const char* name, const std::string& value) { printer_.PushAttribute(name, value.c_str()); }

  void element(const char* name, std::initializer_list<std::pair<const char*, std::string>> attributes) {
    printer_.OpenElement(name);
    for (const auto& [key, value] : attributes) attribute(key, value);
    printer_.CloseElement();
  }

  void origin(const Pose3& pose) {
    element("origin", {{"xyz", numbers(pose.translation())}, {"rpy", rollPitchYaw(pose.linear())}});
  }

  void writeLink(const Link& link) {
    printer_.OpenElement("link");
    attribute("name", link.name);
    if (link.mass > 0) {
      const auto& inertia = link.inertia;
      printer_.OpenElement("inertial");
      origin(translation(link.com));
      element("mass", {{"value", shortestText(link.mass)}});
      element("inertia", {{"ixx", shortestText(inertia(0, 0))},
                          {"ixy", shortestText(inertia(0, 1))},
                          {"ixz", shortestText(inertia(0, 2))},
                          {"iyy", shortestText(inertia(1, 1))},
                          {"iyz", shortestText(inertia(1, 2))},
                          {"izz", shortestText(inertia(2, 2))}});
      printer_.CloseElement();
    }
    if (!link.shape.size.isZero()) writeShape(link.shape);
    printer_.CloseElement();
  }

  void visual(const Pose3& pose, const char* geometry,
              std::initializer_list<std::pair<const char*, std::string>> attributes) {
    printer_.OpenElement("visual");
    origin(pose);
    printer_.OpenElement("geometry");
    element(geometry, attributes);
    printer_.CloseElement();
    printer_.CloseElement();
  }

  void writeShape(const Shape& shape) {
    const std::string radius = shortestText(shape.size.x());
    const Pose3& pose = shape.T_link_shape;
    if (shape.kind == Shape::Kind::box) return visual(pose, "box", {{"size", numbers(shape.size)}});
    if (shape.kind == Shape::Kind::sphere) return visual(pose, "sphere", {{"radius", radius}});
    // URDF has no capsules: a cylinder and a ball at each end.
    const double length = shape.size.z();
    visual(pose, "cylinder", {{"radius", radius}, {"length", shortestText(length)}});
    for (const double side : {-0.5, 0.5})
      visual(pose * translation(0, 0, side * length), "sphere", {{"radius", radius}});
  }

  void writeJoint(const RobotModel& model, const Link& link) {
    const bool moves = link.joint != noJoint;
    printer_.OpenElement("joint");
    attribute("name", moves ? std::string(model.jointName(link.joint)) : link.name + "_fixed");
    attribute("type", moves ? "revolute" : "fixed");
    element("parent", {{"link", model.links[static_cast<std::size_t>(link.parent)].name}});
    element("child", {{"link", link.name}});
    origin(translation(link.origin));
    if (moves) {
      element("axis", {{"xyz", numbers(link.axis)}});
      element("limit", {{"lower", shortestText(link.lower)},
                        {"upper", shortestText(link.upper)},
                        {"effort", "0"},
                        {"velocity", shortestText(link.maxSpeed)}});
    }
    printer_.CloseElement();
  }

  tinyxml2::XMLPrinter printer_;
};

}  // namespace

std::string urdfOf(const RobotModel& model) { return Writer().write(model); }

}  // namespace plumbline
