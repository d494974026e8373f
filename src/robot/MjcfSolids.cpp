#include "robot/MjcfSolids.h"

#include "math/TurnBetween.h"

namespace plumbline {

namespace {

/// The shortest rotation that takes z to a direction of any length.
Mat3 fromZ(const Vec3& direction) {
  const Vec3 turn = turnBetween(Vec3::UnitZ(), direction.normalized());
  return rotation(turn.normalized(), turn.norm()).linear();
}

}  // namespace

Mat3 MjcfSolids::rotationOf(const XMLElement& e) const {
  if (e.Attribute("quat")) {
    const std::vector<double> q = numbers(e, "quat", 4);
    if (q.size() != 4) fail(e, "quat needs four numbers");
    const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
    if (!(turn.norm() > 1e-6)) fail(e, "quat is zero");
    return turn.normalized().toRotationMatrix();
  }
  if (e.Attribute("euler")) {
    const Vec3 angles = unit * vector(&e, "euler", Vec3::Zero());
    Mat3 turn = Mat3::Identity();
    for (int i = 0; i < 3; ++i) {
      const char letter = eulerSequence[static_cast<std::size_t>(i)];
      const Vec3 axis = Vec3::Unit((letter | 0x20) - 'x');
      const Mat3 one = Eigen::AngleAxisd(angles[i], axis).toRotationMatrix();
      turn = letter >= 'x' ? Mat3(turn * one) : Mat3(one * turn);  // small letters turn with the body
    }
    return turn;
  }
  if (e.Attribute("axisangle")) {
    const std::vector<double> a = numbers(e, "axisangle", 4);
    if (a.size() != 4 || !(Vec3(a[0], a[1], a[2]).norm() > 1e-6))
      fail(e, "axisangle needs an axis and an angle");
    return Eigen::AngleAxisd(unit * a[3], Vec3(a[0], a[1], a[2]).normalized()).toRotationMatrix();
  }
  if (e.Attribute("xyaxes")) {
    const std::vector<double> a = numbers(e, "xyaxes", 6);
    if (a.size() != 6) fail(e, "xyaxes needs six numbers");
    const Vec3 x = Vec3(a[0], a[1], a[2]).normalized();
    const Vec3 y = Vec3(a[3], a[4], a[5]);
    Mat3 turn;
    turn.col(0) = x;
    turn.col(1) = (y - y.dot(x) * x).normalized();
    turn.col(2) = turn.col(0).cross(turn.col(1));
    if (!turn.allFinite()) fail(e, "xyaxes are no two directions");
    return turn;
  }
  if (e.Attribute("zaxis")) {
    const Vec3 z = vector(&e, "zaxis", Vec3::UnitZ());
    if (!(z.norm() > 1e-6)) fail(e, "zaxis is zero");
    return fromZ(z);
  }
  return Mat3::Identity();
}

MjcfLump MjcfSolids::inertialOf(const XMLElement& e) const {
  MjcfLump lump;
  lump.mass = number(e, "mass");
  lump.com = vector(&e, "pos", Vec3::Zero());
  if (const std::vector<double> d = numbers(e, "diaginertia", 3); d.size() == 3) {
    lump.inertia = Vec3(d[0], d[1], d[2]).asDiagonal();
  } else if (const std::vector<double> f = numbers(e, "fullinertia", 6); f.size() == 6) {
    lump.inertia << f[0], f[3], f[4], f[3], f[1], f[5], f[4], f[5], f[2];
  } else {
    fail(e, "<inertial> needs diaginertia or fullinertia");
  }
  const Mat3 turn = rotationOf(e);
  lump.inertia = turn * lump.inertia * turn.transpose();
  return lump;
}

MjcfLump MjcfSolids::lumpOf(const XMLElement& e) const {
  MjcfLump lump;
  const std::string type = e.Attribute("type")   ? e.Attribute("type")
                           : e.Attribute("mesh") ? "mesh"
                                                 : "sphere";
  if (type == "plane" || type == "hfield") return lump;
  if (e.Attribute("mass") && number(e, "mass") == 0) return lump;
  if (type == "mesh" || type == "sdf")
    fail(e, "a body's mass is that of a mesh; give the body an <inertial> (mj_saveLastXML writes them)");
  std::vector<double> size = numbers(e, "size", 3);
  Vec3 place = vector(&e, "pos", Vec3::Zero());
  Mat3 turn = rotationOf(e);
  if (const std::vector<double> ends = numbers(e, "fromto", 6); ends.size() == 6) {
    const Vec3 a(ends[0], ends[1], ends[2]), b(ends[3], ends[4], ends[5]);
    place = (a + b) / 2;
    if (!((b - a).norm() > 1e-9)) fail(e, "fromto has no length");
    turn = fromZ(b - a);
    size.resize(1);
    size.push_back((b - a).norm() / 2);
    if (type == "box" || type == "ellipsoid") size = {size[0], size[0], size[1]};
  }
  const auto need = [&](std::size_t count) {
    if (size.size() < count) fail(e, "size of a " + type + " needs " + std::to_string(count) + " numbers");
  };
  double volume = 0;
  Vec3 perMass = Vec3::Zero();
  if (type == "sphere") {
    need(1);
    volume = 4.0 / 3 * pi * std::pow(size[0], 3);
    perMass.setConstant(0.4 * size[0] * size[0]);
  } else if (type == "box" || type == "ellipsoid") {
    need(3);
    const Vec3 half(size[0], size[1], size[2]);
    volume = (type == "box" ? 8 : 4.0 / 3 * pi) * half.prod();
    const Vec3 squares = half.cwiseAbs2();
    perMass = (type == "box" ? 1.0 / 3 : 0.2) * (Vec3::Constant(squares.sum()) - squares);
  } else if (type == "cylinder") {
    need(2);
    const double r = size[0], half = size[1];
    volume = 2 * pi * r * r * half;
    perMass = Vec3(r * r / 4 + half * half / 3, r * r / 4 + half * half / 3, r * r / 2);
  } else if (type == "capsule") {
    need(2);
    const double r = size[0], l = 2 * size[1], ball = 4.0 / 3 * pi * r * r * r, tube = pi * r * r * l;
    volume = ball + tube;
    const double across = tube * (r * r / 4 + l * l / 12) + ball * (0.4 * r * r + l * l / 4 + 3 * l * r / 8);
    perMass = Vec3(across, across, tube * r * r / 2 + ball * 0.4 * r * r) / volume;
  } else {
    fail(e, "type is \"" + type.substr(0, 40) + "\", which is no geom");
  }
  lump.mass = e.Attribute("mass") ? number(e, "mass") : volume * number(e, "density", 1000);
  lump.com = place;
  lump.inertia = turn * (lump.mass * perMass).asDiagonal() * turn.transpose();
  return lump;
}

}  // namespace plumbline
