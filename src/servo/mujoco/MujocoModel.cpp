#include "servo/mujoco/MujocoModel.h"

#include <cstdio>

namespace plumbline::servo::mujoco {
namespace {

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.12g", x);
  return buffer;
}

std::string text(const Vec3& v) { return text(v.x()) + " " + text(v.y()) + " " + text(v.z()); }

std::string text(const Mat3& r) {
  const Eigen::Quaterniond q(r);
  return text(q.w()) + " " + text(q.x()) + " " + text(q.y()) + " " + text(q.z());
}

class Writer {
public:
  Writer(const Mechanism& robot, const ModelOptions& options) : robot_(robot), options_(options) {}

  std::string run() {
    out_ =
        "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\" boundmass=\"0\" boundinertia=\"0\"/>\n"
        "<option timestep=\"" +
        text(options_.step) + "\" gravity=\"" + text(robot_.gravity) +
        "\" cone=\"elliptic\" solver=\"Newton\" iterations=\"60\" tolerance=\"1e-12\" impratio=\"10\"/>\n"
        "<size njmax=\"600\" nconmax=\"100\" nstack=\"2000000\"/>\n<worldbody>\n";
    if (options_.freeBase && options_.engineContacts) {
      const double angle = options_.slope.norm();
      const Mat3 turned = angle > 0 ? Eigen::AngleAxisd(angle, options_.slope / angle).toRotationMatrix()
                                    : Mat3(Mat3::Identity());
      out_ += "<geom name=\"ground\" type=\"plane\" size=\"20 20 1\" quat=\"" + text(turned) + "\"" +
              contact(1, 0) + "/>\n";
    }
    body(0);
    out_ += "</worldbody>\n<sensor>\n";
    if (robot_.hasImu) out_ += "<gyro site=\"imu.gyro\"/><accelerometer site=\"imu.acc\"/>\n";
    return out_ + "</sensor></mujoco>\n";
  }

private:
  std::string contact(int type, int affinity) const {
    return " contype=\"" + std::to_string(type) + "\" conaffinity=\"" + std::to_string(affinity) +
           "\" condim=\"3\" friction=\"" + text(options_.groundFriction) +
           " 0.005 0.0001\" solref=\"0.002 1\" solimp=\"0.99 0.999 0.0001\"";
  }

  void body(std::size_t l) {
    const Mechanism::Link& link = robot_.links[l];
    const auto j = l - 1;
    out_ += "<body name=\"" + link.name + "\"";
    if (l > 0) {
      const Pose3 T = robot_.joints[j].T_parent_joint();
      out_ += " pos=\"" + text(Vec3(T.translation())) + "\" quat=\"" + text(Mat3(T.linear())) + "\"";
    }
    out_ += ">\n";
    if (l == 0 && options_.freeBase) out_ += "<freejoint name=\"base\"/>\n";
    if (l > 0) {
      const bool geared = options_.geared[j];
      joint(robot_.joints[j].name, robot_.joints[j], geared ? 0 : options_.armature[j],
            geared ? 0 : options_.damping[j], options_.hasFriction[j] && !geared);
    }
    if (link.mass > 0) {
      const Mat3& i = link.inertia;
      out_ += "<inertial pos=\"" + text(link.com) + "\" mass=\"" + text(link.mass) + "\" fullinertia=\"" +
              text(i(0, 0)) + " " + text(i(1, 1)) + " " + text(i(2, 2)) + " " + text(i(0, 1)) + " " +
              text(i(0, 2)) + " " + text(i(1, 2)) + "\"/>\n";
    }
    sites(static_cast<int>(l));
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) {
      if (robot_.joints[k].parent != static_cast<int>(l)) continue;
      if (options_.geared[k]) rotor(k);
      body(k + 1);
    }
    out_ += "</body>\n";
  }

  void joint(const std::string& name, const Mechanism::Joint& j, double armature, double damping,
             bool hasFriction) {
    out_ += "<joint name=\"" + name + "\" type=\"" +
            (j.type == Mechanism::Joint::Type::prismatic ? "slide" : "hinge") + "\" axis=\"" + text(j.axis) +
            "\" armature=\"" + text(armature) + "\" damping=\"" + text(damping) + "\"";
    // Set at every step; above 0 here so that the engine keeps a row for it.
    if (hasFriction)
      out_ += " frictionloss=\"1e-9\" solreffriction=\"" + text(2 * options_.step) +
              " 1\" solimpfriction=\"0.9999 0.9999 0.001\"";
    out_ += "/>\n";
  }

  /// A body of no weight worth speaking of: its inertia is the joint's armature.
  void rotor(std::size_t k) {
    const Mechanism::Joint& j = robot_.joints[k];
    const Pose3 T = j.T_parent_joint();
    out_ += "<body name=\"" + j.name + ".rotor\" pos=\"" + text(Vec3(T.translation())) + "\" quat=\"" +
            text(Mat3(T.linear())) +
            "\"><inertial pos=\"0 0 0\" mass=\"1e-6\" diaginertia=\"1e-10 1e-10 1e-10\"/>\n";
    joint(j.name + ".rotor", j, options_.armature[k], options_.damping[k], options_.hasFriction[k]);
    out_ += "</body>\n";
  }

  void sites(int l) {
    if (robot_.hasImu && robot_.imu.link == l) {
      const std::string turned = text(rotationOfRpy(robot_.imu.rpy));
      out_ += "<site name=\"imu.gyro\" pos=\"" + text(robot_.imu.gyro) + "\" quat=\"" + turned +
              "\"/><site name=\"imu.acc\" pos=\"" + text(robot_.imu.accelerometer) + "\" quat=\"" + turned +
              "\"/>\n";
    }
    if (!options_.freeBase || !options_.engineContacts) return;
    for (const Mechanism::Foot& foot : robot_.feet)
      if (foot.link == l)
        out_ += "<geom name=\"sole." + foot.name + "\" type=\"box\" pos=\"" + text(foot.soleCentre) +
                "\" size=\"" + text(Vec3(foot.soleSize / 2)) + "\" mass=\"0\"" + contact(0, 1) + "/>\n";
  }

  const Mechanism& robot_;
  const ModelOptions& options_;
  std::string out_;
};

}  // namespace

std::string modelText(const Mechanism& robot, const ModelOptions& options) {
  return Writer(robot, options).run();
}

}  // namespace plumbline::servo::mujoco
