#include "modules/communication/code/BeliefCode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/TeamSize.h"
#include "modules/communication/code/SayAlphabet.h"
#include "representations/behavior/PlayerRole.h"

namespace plumbline {
namespace {

constexpr int checkBits = 16, numberBits = 4, roleBits = 4;
constexpr int xBits = 9, yBits = 8, headingBits = 5;
constexpr int ballXBits = 9, ballYBits = 9, speedBits = 4;
constexpr double maxSpeed = 8;  ///< [m/s]
constexpr int farXBits = 7, farYBits = 7;
constexpr int timeBits = 6;
/// Ages of the ball by their code, upper ends; the last code says that it is not known [s].
constexpr std::array<double, 7> ages = {0.1, 0.25, 0.5, 1, 2, 4, 8};
constexpr std::uint32_t unknownAge = ages.size();
constexpr int ageBits = 3;

std::uint32_t codeOfAge(double age) {
  const auto it = std::ranges::lower_bound(ages, age);
  return static_cast<std::uint32_t>(it - ages.begin());
}

/// FNV-1a over team, slot and all bits after the checksum, folded to 16 bits.
std::uint32_t checksum(SayBits bits, std::string_view team, std::int64_t slot) {
  std::uint32_t hash = 2166136261u;
  const auto mix = [&hash](std::uint32_t byte) { hash = (hash ^ (byte & 0xff)) * 16777619u; };
  for (const char c : team) mix(static_cast<unsigned char>(c));
  for (int shift = 0; shift < 64; shift += 8)
    mix(static_cast<std::uint32_t>(static_cast<std::uint64_t>(slot) >> shift));
  bits.seek(checkBits);
  for (int i = checkBits; i < SayBits::numBits; i += 8) mix(bits.read(8));
  return (hash >> 16) ^ (hash & 0xffff);
}

void writePoint(SayBits& bits, const Vec2& p, int forX, int forY) {
  bits.write(quantise(p.x(), -messageHalfLength, messageHalfLength, forX), forX);
  bits.write(quantise(p.y(), -messageHalfWidth, messageHalfWidth, forY), forY);
}

Vec2 readPoint(SayBits& bits, int forX, int forY) {
  const double x = unquantise(bits.read(forX), -messageHalfLength, messageHalfLength, forX);
  const double y = unquantise(bits.read(forY), -messageHalfWidth, messageHalfWidth, forY);
  return {x, y};
}

void writeBall(SayBits& bits, const TeamBelief& belief) {
  bits.write(belief.ballKnown ? codeOfAge(belief.ballAge) : unknownAge, ageBits);
  writePoint(bits, belief.ball, ballXBits, ballYBits);
  // A ball at rest is sent exactly: zero is one of the steps.
  constexpr double half = maxSpeed / (1 << speedBits);
  for (const double v : {belief.ballVelocity.x(), belief.ballVelocity.y()})
    bits.write(quantise(v, -maxSpeed - half, maxSpeed - half, speedBits), speedBits);
}

void readBall(SayBits& bits, TeamBelief& belief) {
  const std::uint32_t age = bits.read(ageBits);
  belief.ballKnown = age != unknownAge;
  belief.ballAge = belief.ballKnown ? ages[age] : 0;
  belief.ball = readPoint(bits, ballXBits, ballYBits);
  constexpr double half = maxSpeed / (1 << speedBits);
  for (int axis = 0; axis < 2; ++axis)
    belief.ballVelocity[axis] =
        unquantise(bits.read(speedBits), -maxSpeed - half, maxSpeed - half, speedBits);
}

}  // namespace

std::string encodeBelief(const TeamBelief& belief, std::string_view team, std::int64_t slot) {
  SayBits bits;
  bits.write(0, checkBits);
  bits.write(static_cast<std::uint32_t>(std::clamp(belief.number, 0, teamSize)), numberBits);
  writePoint(bits, belief.pose.position, xBits, yBits);
  bits.write(quantise(normalizeAngle(belief.pose.heading), -pi, pi, headingBits), headingBits);
  bits.write(belief.localised ? 1 : 0, 1);
  bits.write(belief.fallen ? 1 : 0, 1);
  bits.write(static_cast<std::uint32_t>(std::clamp(belief.role, 0, (1 << roleBits) - 1)), roleBits);
  bits.write(quantise(belief.timeToBall, 0, PlayerRole::never, timeBits), timeBits);
  writeBall(bits, belief);
  for (std::size_t i = 0; i < TeamBelief::maxOpponents; ++i) {
    const bool known = i < belief.opponents.size();
    bits.write(known ? static_cast<std::uint32_t>(std::clamp(belief.opponents[i].number, 0, teamSize)) : 0,
               numberBits);
    writePoint(bits, known ? belief.opponents[i].position : Vec2(Vec2::Zero()), farXBits, farYBits);
  }
  const std::uint32_t check = checksum(bits, team, slot);
  bits.seek(0);
  bits.write(check, checkBits);
  return bits.text();
}

std::optional<TeamBelief> decodeBelief(std::string_view text, std::string_view team, std::int64_t slot) {
  auto bits = SayBits::fromText(text);
  if (!bits || bits->read(checkBits) != checksum(*bits, team, slot)) return std::nullopt;
  TeamBelief belief;
  belief.number = static_cast<int>(bits->read(numberBits));
  if (!isUniformNumber(belief.number)) return std::nullopt;
  belief.pose.position = readPoint(*bits, xBits, yBits);
  belief.pose.heading = unquantise(bits->read(headingBits), -pi, pi, headingBits);
  belief.localised = bits->read(1) != 0;
  belief.fallen = bits->read(1) != 0;
  belief.role = static_cast<int>(bits->read(roleBits));
  belief.timeToBall = unquantise(bits->read(timeBits), 0, PlayerRole::never, timeBits);
  readBall(*bits, belief);
  for (std::size_t i = 0; i < TeamBelief::maxOpponents; ++i) {
    SaidOpponent opponent;
    opponent.number = static_cast<int>(bits->read(numberBits));
    opponent.position = readPoint(*bits, farXBits, farYBits);
    if (isUniformNumber(opponent.number)) belief.opponents.push_back(opponent);
  }
  return belief;
}

}  // namespace plumbline
