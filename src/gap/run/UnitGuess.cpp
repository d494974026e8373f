#include "gap/run/UnitGuess.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/run/ColumnStatistics.h"
#include "gap/run/ImportUnits.h"
#include "math/Gravity.h"
#include "math/Median.h"

namespace plumbline::gap {
namespace {

// Limits are exceeded by encoders and stops; see RunCheck.cpp, which refuses what is farther.
constexpr double encoderSlack = 0.35, sliderSlack = 0.1;  // [rad, m]
/// A motion of no joint that is larger is nothing to diagnose [rad]; values that would be one are not in deg.
constexpr double still = 0.05;
constexpr double near = 1.3;         ///< ratio up to which two sizes count as the same
constexpr double mostRate = 12;      ///< times the expected rate, or its inverse
constexpr double leastMotion = 0.1;  ///< [rad/s] from which speeds are compared

using Raw = UnitGuess::Raw;
using Raws = std::vector<Raw>;

bool alike(double a, double b) { return a > b / near && a < b * near; }

/// Largest size of a channel's raw values with its factor and without its offset; 0 if all are lost.
double largest(const Raw& raw) {
  const Extremes e = extremesOf(*raw.values);
  return e.low > e.high ? 0 : std::abs(raw.factor) * std::max(std::abs(e.low), std::abs(e.high));
}

double largestOf(const Raws& channels) {
  double most = 0;
  for (const Raw& raw : channels) most = std::max(most, largest(raw));
  return most;
}

std::vector<double> scaled(const Raw& raw) {
  std::vector<double> values = *raw.values;
  for (double& x : values) x *= raw.factor;
  return values;
}

/// Of the values' sizes.
double medianSize(const Raws& channels) {
  std::vector<double> sizes;
  for (const Raw& raw : channels)
    for (const double x : *raw.values)
      if (!std::isnan(x)) sizes.push_back(std::abs(raw.factor * x));
  return upperMedian(std::move(sizes));
}

/// How a group of channels fits its joints' limits in a unit.
struct Fit {
  double over = 0, motion = 0;  ///< largest excess and largest range of motion, in the run's unit
  const Raw* farthest = nullptr;
  double reached = 0;  ///< by it
};

Fit fitOf(const Mechanism& robot, const Raws& channels, double unit) {
  Fit fit;
  for (const Raw& raw : channels) {
    const int index = robot.jointIndex(raw.place);
    const Extremes e = extremesOf(*raw.values);
    if (index < 0 || e.low > e.high) continue;
    const Mechanism::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
    double low = unit * raw.factor * e.low + raw.offset, high = unit * raw.factor * e.high + raw.offset;
    if (low > high) std::swap(low, high);
    fit.motion = std::max(fit.motion, high - low);
    const double over = std::max(high - joint.upper, joint.lower - low);
    if (fit.farthest && over <= fit.over) continue;
    fit.over = over;
    fit.farthest = &raw;
    fit.reached = high - joint.upper > joint.lower - low ? high : low;
  }
  return fit;
}

std::string limitsOf(const Mechanism::Joint& joint) {
  return shownNumber(joint.lower) + " to " + shownNumber(joint.upper);
}

}  // namespace

GuessedUnit guessTimeUnit(double step, double expectedHz) {
  for (const char* unit : {"s", "ms", "us", "ns"}) {
    const double rate = 1 / (step * *importUnit(unit));
    if (rate < expectedHz * mostRate && rate > expectedHz / mostRate)
      return {unit, "it then advances at " + shownNumber(rate) + " Hz"};
  }
  throw UnclearUnit("advances by " + shownNumber(step) + " a line, in no unit near " +
                    shownNumber(expectedHz) + " Hz; write unit: s, ms, us or ns");
}

bool UnitGuess::guesses(ChannelKind kind) {
  return kind != ChannelKind::time && kind != ChannelKind::temperature && kind != ChannelKind::truth;
}

const Mechanism::Joint* UnitGuess::joint(const std::string& name) const {
  const int index = robot_ ? robot_->jointIndex(name) : -1;
  return index < 0 ? nullptr : &robot_->joints[static_cast<std::size_t>(index)];
}

GuessedUnit UnitGuess::of(ChannelKind kind, const Raws& channels, bool sliding) const {
  switch (kind) {
    case ChannelKind::command:
    case ChannelKind::position:
      return sliding ? length(channels) : angle(kind, channels);
    case ChannelKind::velocity:
    case ChannelKind::commandSpeed:
      return speed(channels, sliding);
    case ChannelKind::torque:
    case ChannelKind::commandTorque:
      return sliding ? GuessedUnit{"N", "of a joint that slides"} : torque(channels);
    case ChannelKind::current:
    case ChannelKind::commandCurrent:
      return current(channels);
    case ChannelKind::voltage:
      return voltage(channels);
    case ChannelKind::duty:
    case ChannelKind::stiffness:
      return share(channels);
    case ChannelKind::gyro:
      return rotation(channels);
    case ChannelKind::acceleration:
      return acceleration(channels);
    case ChannelKind::force:
      return force(channels);
    default:
      return {"1", ""};
  }
}

GuessedUnit UnitGuess::angle(ChannelKind kind, const Raws& channels) const {
  const double degree = *importUnit("deg");
  // The command and the reading of a joint move alike; the one whose unit is known shows the other's.
  const ChannelKind other = kind == ChannelKind::command ? ChannelKind::position : ChannelKind::command;
  for (const Raw& raw : channels) {
    const auto known = known_.channels.find(channelName(other, raw.place));
    if (known == known_.channels.end()) continue;
    const std::vector<bool> all(known->second.size(), true);
    const Likeness like = likenessOf(known->second, scaled(raw), all);
    if (like.pairs < 20 || like.rmsA < 0.02 || like.correlation < 0.6) continue;
    for (const auto& [unit, size] : {std::pair{"rad", 1.0}, std::pair{"deg", 1 / degree}})
      if (alike(like.rmsB / like.rmsA, size))
        return {unit, channelName(kind, raw.place) + " moves " + (size > 1 ? "57 times as far as " : "as ") +
                          known->first};
  }
  if (!robot_) {
    const double most = largestOf(channels);
    if (most < still / degree / 2) return {"rad", "in deg nothing would move by 3 deg"};
    throw UnclearUnit("reaches " + shownNumber(most) +
                      ", and the robot's file is not known: give it by --robot, or write unit: rad or "
                      "unit: deg");
  }
  const Fit rad = fitOf(*robot_, channels, 1), deg = fitOf(*robot_, channels, degree);
  if (!rad.farthest) return {"rad", robot_->name + " has none of these joints"};
  const std::string name = channelName(kind, rad.farthest->place);
  const Mechanism::Joint& limits = *joint(rad.farthest->place);
  if (rad.over <= encoderSlack) {
    if (deg.motion < still) return {"rad", "it is within the limits, and in deg nothing would move by 3 deg"};
    throw UnclearUnit("could be in rad or in deg: it moves by up to " + shownNumber(rad.motion) +
                      ", which is within the joints' limits in both; write unit: rad or unit: deg");
  }
  const std::string where =
      name + " reaches " + shownNumber(rad.reached) + ", its limits are " + limitsOf(limits) + " rad";
  const double widest = std::max(std::abs(limits.lower), std::abs(limits.upper)) + encoderSlack;
  if (deg.over <= encoderSlack && std::abs(rad.reached) > 2 * widest) return {"deg", where};
  throw UnclearUnit("fits neither rad nor deg clearly: " + where + "; write a unit or counts_per_turn");
}

GuessedUnit UnitGuess::length(const Raws& channels) const {
  const Fit metre = fitOf(*robot_, channels, 1), millimetre = fitOf(*robot_, channels, 1e-3);
  if (!metre.farthest || metre.over <= sliderSlack) return {"m", "it is within the limits"};
  const Mechanism::Joint& limits = *joint(metre.farthest->place);
  const double widest = std::max(std::abs(limits.lower), std::abs(limits.upper)) + sliderSlack;
  const std::string where = metre.farthest->place + " reaches " + shownNumber(metre.reached) +
                            ", its limits are " + limitsOf(limits) + " m";
  if (millimetre.over <= sliderSlack && std::abs(metre.reached) > 2 * widest) return {"mm", where};
  throw UnclearUnit("fits neither m nor mm clearly: " + where + "; write a unit or scale");
}

GuessedUnit UnitGuess::speed(const Raws& channels, bool sliding) const {
  for (const Raw& raw : channels) {
    const auto position = known_.channels.find(channelName(ChannelKind::position, raw.place));
    if (position == known_.channels.end()) continue;
    const SpeedLikeness like = speedLikeness(*known_.t, position->second, scaled(raw), medianStep(*known_.t));
    if (like.rms < (sliding ? 0.1 : 1) * leastMotion || std::abs(like.correlation) < 0.6) continue;
    const auto fits = [&](const char* unit) { return alike(std::abs(like.slope), 1 / *importUnit(unit)); };
    for (const char* unit : {"rad/s", "deg/s", "rpm", "m/s", "mm/s"})
      if ((unit[0] == 'm') == sliding && fits(unit))
        return {unit,
                "it is " + shownNumber(std::abs(like.slope)) + " times the speed of " + position->first};
    throw UnclearUnit("is " + shownNumber(std::abs(like.slope)) + " times the speed of " + position->first +
                      " per second, which is no known unit; write a unit or scale");
  }
  if (largestOf(channels) < leastMotion) return {sliding ? "m/s" : "rad/s", "nothing moves"};
  throw UnclearUnit(std::string("has no position beside it that shows its unit; write ") +
                    (sliding ? "unit: m/s or unit: mm/s" : "unit: rad/s, deg/s or rpm"));
}

GuessedUnit UnitGuess::torque(const Raws& channels) const {
  double share = 0;  // of the joint's limit
  for (const Raw& raw : channels)
    if (const Mechanism::Joint* limits = joint(raw.place))
      share = std::max(share, largest(raw) / limits->maxTorque);
  if (!robot_ && largestOf(channels) > 0)
    throw UnclearUnit("has no limit to compare with: give the robot's file by --robot, or write unit: Nm");
  if (share <= 1.5) return {"Nm", "it is within the joints' limits"};
  if (share > 3 && share / 1000 <= 1.5)
    return {"mNm", "it reaches " + shownNumber(share) + " times a joint's limit"};
  throw UnclearUnit("reaches " + shownNumber(share) +
                    " times a joint's limit, neither Nm nor mNm clearly; write unit: Nm or unit: mNm");
}

GuessedUnit UnitGuess::current(const Raws& channels) const {
  double share = 0;  // of the stall current
  bool all = true;
  for (const Raw& raw : channels) {
    const Mechanism::Joint* motor = joint(raw.place);
    const bool known = motor && motor->servo.model == Servo::Model::dcMotor && motor->servo.R > 0;
    if (known) share = std::max(share, largest(raw) * motor->servo.R / motor->servo.vin);
    all = all && known;
  }
  const double most = largestOf(channels);
  if (all && share <= 2) return {"A", "it is below the motor's stall current"};
  if (all && share > 4 && share / 1000 <= 2)
    return {"mA", "it reaches " + shownNumber(share) + " times the motor's stall current"};
  if (!all && most < 5) return {"A", "as mA it would be nothing"};
  if (!all && most > 200) return {"mA", "it reaches " + shownNumber(most)};
  throw UnclearUnit("reaches " + shownNumber(most) + ", neither A nor mA clearly; write unit: A or unit: mA");
}

GuessedUnit UnitGuess::voltage(const Raws& channels) const {
  const double usual = medianSize(channels);
  for (const Raw& raw : channels) {
    const Mechanism::Joint* motor = joint(raw.place);
    if (!motor || !(motor->servo.vin > 0)) continue;
    const double ratio = usual / motor->servo.vin;
    const std::string why = "the supply is " + shownNumber(motor->servo.vin) + " V";
    if (ratio > 0.4 && ratio < 2.5) return {"V", why};
    if (ratio > 400 && ratio < 2500) return {"mV", why};
    throw UnclearUnit("is " + shownNumber(usual) + ", but " + why + "; write unit: V, unit: mV or a scale");
  }
  if (usual >= 3 && usual <= 60) return {"V", "it is " + shownNumber(usual)};
  if (usual >= 3000 && usual <= 60000) return {"mV", "it is " + shownNumber(usual)};
  throw UnclearUnit("is " + shownNumber(usual) +
                    ", which is no usual supply; write unit: V, unit: mV or a scale");
}

GuessedUnit UnitGuess::share(const Raws& channels) {
  const double most = largestOf(channels);
  if (most <= 1.001) return {"1", "it is within 1"};
  if (most > 2 && most <= 100.1) return {"percent", "it reaches " + shownNumber(most)};
  throw UnclearUnit("reaches " + shownNumber(most) +
                    ", neither a share nor a percentage clearly; write unit: 1, unit: percent or a scale");
}

GuessedUnit UnitGuess::acceleration(const Raws& channels) const {
  const std::vector<double> none(channels.front().values->size(), 0.0);
  const auto at = [&](std::size_t i) { return i < channels.size() ? scaled(channels[i]) : none; };
  const double size = medianLength(at(0), at(1), at(2)),
               gravity = robot_ && robot_->gravity.norm() > 1 ? robot_->gravity.norm() : earthGravity;
  for (const auto& [unit, one] : {std::pair{"m/s^2", gravity}, std::pair{"g", 1.0}})
    if (size > 0.7 * one && size < 1.35 * one) return {unit, "its median length is " + shownNumber(size)};
  throw UnclearUnit("has a median length of " + shownNumber(size) +
                    ", in m/s^2 and in g far from gravity; write unit: m/s^2, unit: g or a scale");
}

GuessedUnit UnitGuess::rotation(const Raws& channels) const {
  const auto acc = [&](const char* axis) {
    const auto it = known_.channels.find(std::string("acc.") + axis);
    return it == known_.channels.end() ? nullptr : &it->second;
  };
  for (const Raw& raw : channels) {
    const auto* side = raw.place == "y" ? acc("x") : raw.place == "x" ? acc("y") : nullptr;
    if (!side || !acc("z")) continue;
    const Likeness like =
        tiltLikeness(*known_.t, *side, *acc("z"), scaled(raw), raw.place == "y" ? -1.0 : 1.0);
    if (like.pairs < 10 || like.rmsA < 0.02 || std::abs(like.correlation) < 0.7) continue;
    const double ratio = like.rmsB / like.rmsA;
    for (const char* unit : {"rad/s", "deg/s"})
      if (const double one = 1 / *importUnit(unit); ratio > 0.4 * one && ratio < 2.5 * one)
        return {unit, "it turns " + shownNumber(ratio) + " times as fast as gravity in acc"};
  }
  const double most = largestOf(channels);
  if (!known_.freeBase && most < 5) return {"rad/s", "the base is fixed"};
  if (most < leastMotion) return {"rad/s", "nothing turns"};
  if (most > 40) return {"deg/s", "it reaches " + shownNumber(most)};
  throw UnclearUnit("reaches " + shownNumber(most) +
                    ", in rad/s or deg/s, and acc does not show which; write unit: rad/s or unit: deg/s");
}

GuessedUnit UnitGuess::force(const Raws& channels) const {
  if (!known_.freeBase) return {"N", "the base is fixed"};
  std::vector<std::vector<double>> forces;
  for (const Raw& raw : channels) forces.push_back(scaled(raw));
  std::vector<const std::vector<double>*> columns;
  columns.reserve(forces.size());
  for (const std::vector<double>& one : forces) columns.push_back(&one);
  const double sum = std::abs(medianSum(columns));
  const double weight = robot_ ? robot_->totalMass() * robot_->gravity.norm() : 0;
  for (const char* unit : {"N", "kgf"})
    if (const double share = sum * *importUnit(unit) / weight; weight > 0 && share > 0.5 && share < 1.8)
      return {unit,
              "the median sum is " + shownNumber(sum) + ", the weight is " + shownNumber(weight) + " N"};
  throw UnclearUnit("has a median sum of " + shownNumber(sum) +
                    (robot_ ? ", and the robot weighs " + shownNumber(weight) + " N"
                            : ", and the robot's file is not known") +
                    "; write unit: N, unit: kgf or a scale");
}

}  // namespace plumbline::gap
