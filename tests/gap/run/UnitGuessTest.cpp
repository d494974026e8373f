#include "gap/run/UnitGuess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "robot/MechanismFile.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

using Numbers = std::vector<double>;

Numbers series(const std::function<double(double)>& f) {
  Numbers values;
  for (int i = 0; i < 1000; ++i) values.push_back(f(0.01 * i));
  return values;
}
Numbers wave(double amplitude) {
  return series([=](double t) { return amplitude * std::sin(2 * t); });
}

/// The unit of one channel beside known ones; "unclear: ..." where it is refused.
class Guess {
public:
  explicit Guess(const std::string& robot = "nao_v5") {
    if (!robot.empty()) robot_ = findMechanism(robot), given_ = true;
    t_ = series([](double t) { return t; });
    known.t = &t_;
  }
  std::string of(ChannelKind kind, const std::string& place, const Numbers& values) const {
    return of(kind, {{place, &values}});
  }
  std::string of(ChannelKind kind, const std::vector<UnitGuess::Raw>& raws) const {
    try {
      return UnitGuess(given_ ? &robot_ : nullptr, known).of(kind, raws, false).unit;
    } catch (const UnclearUnit& unclear) {
      return std::string("unclear: ") + unclear.what();
    }
  }
  UnitGuess::Known known;

private:
  Mechanism robot_;
  bool given_ = false;
  Numbers t_;
};

constexpr double perRad = 180 / M_PI;
const std::string unclear = "unclear: ";

TEST(UnitGuess, anglesByTheJointsLimits) {
  const Guess guess;
  EXPECT_EQ(guess.of(ChannelKind::position, "HeadYaw", wave(60)), "deg");
  EXPECT_EQ(guess.of(ChannelKind::command, "HeadYaw", wave(60)), "deg");
  EXPECT_EQ(guess.of(ChannelKind::position, "HeadYaw", wave(1)), "rad");
  EXPECT_EQ(guess.of(ChannelKind::position, "HeadYaw", Numbers(100, 0.0)), "rad");
  EXPECT_EQ(guess.of(ChannelKind::position, "NoJoint", wave(60)), "rad") << "the check of runs names it";
}

TEST(UnitGuess, anglesThatFitBothUnitsOrNoneAreAsked) {
  const Guess guess;
  EXPECT_EQ(guess.of(ChannelKind::position, "HeadYaw", wave(2)),
            unclear +
                "could be in rad or in deg: it moves by up to 4, which is within the joints' limits in "
                "both; write unit: rad or unit: deg");
  EXPECT_TRUE(guess.of(ChannelKind::position, "HeadYaw", wave(3))
                  .starts_with(unclear + "fits neither rad nor deg clearly: pos."));
  EXPECT_TRUE(guess.of(ChannelKind::position, "HeadYaw", wave(2000))
                  .starts_with(unclear + "fits neither rad nor deg clearly: pos."));
}

TEST(UnitGuess, oneJointOfSeveralShowsTheUnitOfAll) {
  const Guess guess;
  const Numbers small = wave(1), large = wave(40);
  EXPECT_EQ(guess.of(ChannelKind::position, {{"HeadYaw", &small}, {"LShoulderPitch", &large}}), "deg");
}

TEST(UnitGuess, aSignAndAnOffsetAreTakenIntoAccount) {
  const Guess guess;
  // The knee turns from -0.09 to 2.1 rad; as recorded it turns the other way and 180 is straight.
  const Numbers values = series([](double t) { return 150 + 25 * std::sin(t); });
  EXPECT_EQ(guess.of(ChannelKind::position, {{"LKneePitch", &values, -1, M_PI}}), "deg");
}

TEST(UnitGuess, aCommandThatIsUnclearFollowsItsPosition) {
  Guess guess;
  guess.known.channels["pos.HeadYaw"] = wave(2);
  EXPECT_EQ(guess.of(ChannelKind::command, "HeadYaw", wave(2.1)), "rad");
  guess.known.channels["pos.HeadYaw"] = wave(2 / perRad);
  EXPECT_EQ(guess.of(ChannelKind::command, "HeadYaw", wave(2.1)), "deg");
}

TEST(UnitGuess, withoutTheRobotsFileOnlySmallAnglesAreClear) {
  const Guess guess("");
  EXPECT_EQ(guess.of(ChannelKind::position, "Elbow", wave(1)), "rad");
  EXPECT_EQ(guess.of(ChannelKind::position, "Elbow", wave(60)),
            unclear +
                "reaches 60, and the robot's file is not known: give it by --robot, or write unit: rad "
                "or unit: deg");
}

TEST(UnitGuess, speedsByTheirPosition) {
  Guess guess;
  guess.known.channels["pos.HeadYaw"] = wave(1);
  const auto speed = [&](double scale) {
    return guess.of(ChannelKind::velocity, "HeadYaw",
                    series([=](double t) { return 2 * scale * std::cos(2 * t); }));
  };
  EXPECT_EQ(speed(1), "rad/s");
  EXPECT_EQ(speed(-1), "rad/s") << "the check of runs names the sign";
  EXPECT_EQ(speed(perRad), "deg/s");
  EXPECT_EQ(speed(30 / M_PI), "rpm");
  EXPECT_TRUE(speed(1000).starts_with(unclear));
  EXPECT_EQ(guess.of(ChannelKind::velocity, "LKneePitch", wave(0.01)), "rad/s");
  EXPECT_EQ(guess.of(ChannelKind::velocity, "LKneePitch", wave(3)),
            unclear + "has no position beside it that shows its unit; write unit: rad/s, deg/s or rpm");
}

TEST(UnitGuess, effortsByWhatTheMotorCanGive) {
  const Guess nao, pendulum("xl330_pendulum");
  EXPECT_EQ(nao.of(ChannelKind::torque, "HeadYaw", wave(1)), "Nm");
  EXPECT_EQ(nao.of(ChannelKind::torque, "HeadYaw", wave(1000)), "mNm");
  EXPECT_EQ(pendulum.of(ChannelKind::current, "pendulum", wave(1.5)), "A");
  EXPECT_EQ(pendulum.of(ChannelKind::current, "pendulum", wave(900)), "mA");
  EXPECT_TRUE(nao.of(ChannelKind::current, "HeadYaw", wave(50)).starts_with(unclear));
  EXPECT_EQ(pendulum.of(ChannelKind::voltage, "pendulum", Numbers(100, 7.1)), "V");
  EXPECT_EQ(pendulum.of(ChannelKind::voltage, "pendulum", Numbers(100, 7100)), "mV");
  EXPECT_EQ(pendulum.of(ChannelKind::voltage, "pendulum", Numbers(100, 71)),
            unclear + "is 71, but the supply is 7.4 V; write unit: V, unit: mV or a scale");
  EXPECT_EQ(nao.of(ChannelKind::duty, "HeadYaw", wave(0.9)), "1");
  EXPECT_EQ(nao.of(ChannelKind::duty, "HeadYaw", wave(80)), "percent");
  EXPECT_TRUE(nao.of(ChannelKind::duty, "HeadYaw", wave(885)).starts_with(unclear));
}

TEST(UnitGuess, bodySensorsByGravity) {
  Guess guess;
  const Numbers metres(1000, 9.7), gs(1000, 0.99), odd(1000, 3.0), zero(1000, 0.0);
  EXPECT_EQ(guess.of(ChannelKind::acceleration, {{"x", &zero}, {"y", &zero}, {"z", &metres}}), "m/s^2");
  EXPECT_EQ(guess.of(ChannelKind::acceleration, {{"x", &zero}, {"y", &zero}, {"z", &gs}}), "g");
  EXPECT_TRUE(guess.of(ChannelKind::acceleration, {{"z", &odd}}).starts_with(unclear));
  EXPECT_EQ(guess.of(ChannelKind::gyro, "x", wave(0.5)), "rad/s") << "the base is fixed";
  guess.known.freeBase = true;
  EXPECT_TRUE(guess.of(ChannelKind::gyro, "x", wave(0.5)).starts_with(unclear));
  EXPECT_EQ(guess.of(ChannelKind::gyro, "x", wave(100)), "deg/s");
  const double weight = findMechanism("nao_v5").totalMass() * 9.81;
  EXPECT_EQ(guess.of(ChannelKind::force, "LFoot.FrontLeft", Numbers(100, weight)), "N");
  EXPECT_EQ(guess.of(ChannelKind::force, "LFoot.FrontLeft", Numbers(100, weight / 9.81)), "kgf");
}

TEST(UnitGuess, timesByTheRateOfTheRobot) {
  EXPECT_EQ(guessTimeUnit(0.01, 100).unit, "s");
  EXPECT_EQ(guessTimeUnit(10, 100).unit, "ms");
  EXPECT_EQ(guessTimeUnit(1000, 100).unit, "us");
  EXPECT_EQ(guessTimeUnit(1e7, 100).unit, "ns");
  EXPECT_EQ(thrownBy([] { guessTimeUnit(1, 50); }),
            "advances by 1 a line, in no unit near 50 Hz; write unit: s, ms, us or ns");
}

}  // namespace
}  // namespace plumbline::gap
