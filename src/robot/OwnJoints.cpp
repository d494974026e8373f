#include "robot/OwnJoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "math/Index.h"

namespace plumbline {
namespace {

constexpr double mirrorCosine = 0.985;  // axes within 10 degrees of the mirror image are meant to be it

/// Cosine of the angle between one axis and the mirror image (left and right exchanged) of another.
double mirrorMatch(const Mechanism::Joint& one, const Mechanism::Joint& other) {
  // A turn is mirrored as a pseudovector.
  return Vec3(-one.axis.x(), one.axis.y(), -one.axis.z()).dot(other.axis);
}

class Numbers {
public:
  explicit Numbers(const Mechanism& mechanism)
      : mechanism_(mechanism), numbers_(mechanism_.joints.size(), noJoint) {}

  std::vector<JointId> all() {
    for (std::size_t j = 0; j < numbers_.size(); ++j) numbers_[j] = humanoidJoint(mechanism_.joints[j].name);
    for (std::size_t j = 0; j < numbers_.size(); ++j) {
      if (!isOwn(j)) continue;
      const std::size_t left = partnerOf(j, true), right = partnerOf(j, false);
      if (right < numbers_.size())
        addPair(j, right);
      else if (left < numbers_.size())
        addPair(left, j);
      else
        add(mirrorMatch(mechanism_.joints[j], mechanism_.joints[j]) >= 0 ? 0 : 1, j);
    }
    return numbers_;
  }

private:
  bool isOwn(std::size_t j) const {
    const Mechanism::Joint& joint = mechanism_.joints[j];
    return numbers_[j] == noJoint && joint.type == Mechanism::Joint::Type::revolute && joint.driver < 0;
  }

  /// Its left or right counterpart without a number; the number of joints if there is none.
  std::size_t partnerOf(std::size_t j, bool onLeft) const {
    std::size_t other = 0;
    const auto fits = [&] {
      const std::string &a = mechanism_.joints[onLeft ? other : j].name,
                        &b = mechanism_.joints[onLeft ? j : other].name;
      return isOwn(other) && isLeftOf(a, b);
    };
    while (other < numbers_.size() && !fits()) ++other;
    return other;
  }

  void addPair(std::size_t left, std::size_t right) {
    const Mechanism::Joint &l = mechanism_.joints[left], &r = mechanism_.joints[right];
    const double match = mirrorMatch(l, r);
    if (std::abs(match) < mirrorCosine)
      throw std::invalid_argument("robot " + mechanism_.name + ", joint " + r.name +
                                  ": its axis is not the mirror image of that of " + l.name +
                                  "; turn it, or let the names differ in more than the side");
    const std::size_t range = match > 0 ? 2 : 3;
    const JointId number = add(range, left);
    numbers_[right] = static_cast<JointId>(number + ownJointRanges[range].count / 2);
  }

  JointId add(std::size_t range, std::size_t j) {
    const OwnJointRange& room = ownJointRanges[range];
    const int most = room.pair ? room.count / 2 : room.count;
    if (used_[range] == most)
      throw std::invalid_argument(
          "robot " + mechanism_.name + ", joint " + mechanism_.joints[j].name + ": a robot has at most " +
          std::to_string(most) + (room.pair ? " pairs of" : " single") + " joints of its own that " +
          (room.signStays ? "keep" : "change") + " their sign when left and right change places");
    numbers_[j] = static_cast<JointId>(room.first + used_[range]++);
    return numbers_[j];
  }

  const Mechanism& mechanism_;
  std::vector<JointId> numbers_;
  std::array<int, ownJointRanges.size()> used_{};
};

}  // namespace

std::vector<JointId> jointNumbers(const Mechanism& mechanism) { return Numbers(mechanism).all(); }

bool isLeftOf(std::string_view left, std::string_view right) {
  // Left and Right end alike, so the t is part of what follows.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> sides = {
      {{"L", "R"}, {"l", "r"}, {"Lef", "Righ"}, {"lef", "righ"}, {"LEF", "RIGH"}}};
  const auto split = std::ranges::mismatch(left, right);
  left.remove_prefix(static_cast<std::size_t>(split.in1 - left.begin()));
  right.remove_prefix(static_cast<std::size_t>(split.in2 - right.begin()));
  while (!left.empty() && !right.empty() && left.back() == right.back()) {
    left.remove_suffix(1);
    right.remove_suffix(1);
  }
  return std::ranges::find(sides, std::pair(left, right)) != sides.end();
}

}  // namespace plumbline
