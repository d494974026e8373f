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
  std::string of(ChannelKind kind, const std::vector<UnitGuess::Raw>& raws, bool sliding = false) const {
    try {
      return UnitGuess(given_ ? &robot_ : nullptr, known).of(kind, raws, sliding).unit;
    } catch (const UnclearUnit& unclear) {
      return std::string("unclear: ") + unclear.what();
    }
  }
  Mechanism::Joint& joint(const std::string& name) {
    return robot_.joints[static_cast<std::size_t>(robot_.jointIndex(name))];
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

TEST(UnitGuess, anglesMayBeTwentyDegreesBeyondTheLimits) {
  // The head turns to 2.086 rad both ways.
  EXPECT_TRUE(
      Guess().of(ChannelKind::position, "HeadYaw", wave(2.38)).starts_with(unclear + "could be in rad"));
  EXPECT_TRUE(Guess().of(ChannelKind::position, "HeadYaw", wave(2.48)).starts_with(unclear + "fits neither"));
  EXPECT_EQ(Guess().of(ChannelKind::position, "HeadYaw", wave(1.25)), "rad") << "2.5 degrees are no motion";
  EXPECT_TRUE(Guess().of(ChannelKind::position, "HeadYaw", wave(1.5)).starts_with(unclear))
      << "3 degrees are";
}

TEST(UnitGuess, lengthsMayBeTenCentimetresBeyondTheLimits) {
  Guess guess;
  guess.joint("HeadYaw").lower = -0.2;
  guess.joint("HeadYaw").upper = 0.2;
  const auto unitOf = [&](double most) {
    const Numbers values = wave(most);
    return guess.of(ChannelKind::position, {{"HeadYaw", &values}}, true);
  };
  EXPECT_EQ(unitOf(0.29), "m");
  EXPECT_TRUE(unitOf(0.31).starts_with(unclear));
  EXPECT_EQ(unitOf(290), "mm");
  EXPECT_TRUE(unitOf(310).starts_with(unclear));
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

TEST(UnitGuess, whatMovesOnlyInPartAsAnotherShowsNoUnit) {
  Guess guess;
  // Two motions that have nothing in common over ten seconds.
  const auto one = [](double t) { return std::sin(M_PI * t); };
  const auto other = [](double t) { return std::sin(1.8 * M_PI * t); };
  const auto mixed = [&](double share) {
    return series([=](double t) { return 1.8 * (share * one(t) + std::sqrt(1 - share * share) * other(t)); });
  };
  guess.known.channels["pos.HeadYaw"] = series([=](double t) { return 1.8 * one(t); });
  EXPECT_EQ(guess.of(ChannelKind::command, "HeadYaw", mixed(0.65)), "rad");
  EXPECT_TRUE(guess.of(ChannelKind::command, "HeadYaw", mixed(0.5)).starts_with(unclear));
  const auto speed = [&](double share) {
    return series([=](double t) {
      return 1.8 * M_PI * (std::cos(M_PI * t) + std::sqrt(1 / (share * share) - 1) * other(t));
    });
  };
  EXPECT_EQ(guess.of(ChannelKind::velocity, "HeadYaw", speed(0.65)), "rad/s");
  EXPECT_TRUE(guess.of(ChannelKind::velocity, "HeadYaw", speed(0.55)).starts_with(unclear));
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
  EXPECT_EQ(guess.of(ChannelKind::velocity, "LKneePitch", wave(0.09)), "rad/s") << "hardly moves";
  EXPECT_TRUE(guess.of(ChannelKind::velocity, "LKneePitch", wave(0.11)).starts_with(unclear));
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

TEST(UnitGuess, howFarEffortsMayBeFromWhatTheMotorGives) {
  const Guess nao, pendulum("xl330_pendulum");
  const auto torque = [&](double limits) {  // the head's motor gives 1.547 N m
    return nao.of(ChannelKind::torque, "HeadYaw", Numbers(100, 1.547 * limits));
  };
  EXPECT_EQ(torque(1.4), "Nm");
  EXPECT_TRUE(torque(1.6).starts_with(unclear));
  EXPECT_EQ(torque(1400), "mNm");
  EXPECT_TRUE(torque(1600).starts_with(unclear));
  const auto supply = [&](double volts) {  // of 7.4 V
    return pendulum.of(ChannelKind::voltage, "pendulum", Numbers(100, volts));
  };
  EXPECT_EQ(supply(0.45 * 7.4), "V");
  EXPECT_TRUE(supply(0.35 * 7.4).starts_with(unclear));
  EXPECT_EQ(supply(2.4 * 7.4), "V");
  EXPECT_TRUE(supply(2.6 * 7.4).starts_with(unclear));
}

TEST(UnitGuess, howFarGravityAndTheWeightMayBeOff) {
  Guess guess;
  guess.known.freeBase = true;
  const double weight = findMechanism("nao_v5").totalMass() * 9.81;
  const auto force = [&](double weights) {
    return guess.of(ChannelKind::force, "LFoot.FrontLeft", Numbers(100, weight * weights));
  };
  EXPECT_EQ(force(0.55), "N");
  EXPECT_TRUE(force(0.45).starts_with(unclear));
  EXPECT_EQ(force(1.7), "N");
  EXPECT_TRUE(force(1.9).starts_with(unclear));
  const auto acceleration = [&](double size) {
    return guess.of(ChannelKind::acceleration, "z", Numbers(100, size));
  };
  EXPECT_EQ(acceleration(0.75 * 9.81), "m/s^2");
  EXPECT_TRUE(acceleration(0.65 * 9.81).starts_with(unclear));
}

/// A gyro beside the accelerometer of a body that rocks about y by this, and by `aside` as the gyro alone
/// says.
std::string rocking(double tilt, double scale, double aside = 0) {
  Guess guess;
  guess.known.freeBase = true;
  guess.known.channels["acc.x"] = series([=](double t) { return -9.81 * std::sin(tilt * std::sin(2 * t)); });
  guess.known.channels["acc.z"] = series([=](double t) { return 9.81 * std::cos(tilt * std::sin(2 * t)); });
  return guess.of(ChannelKind::gyro, "y", series([=](double t) {
                    return scale * (2 * tilt * std::cos(2 * t) + 5 * aside * std::cos(5 * t));
                  }));
}

TEST(UnitGuess, aGyroTurnsAsGravityDoesInTheAccelerometer) {
  EXPECT_EQ(rocking(0.3, 1), "rad/s");
  EXPECT_EQ(rocking(0.3, perRad), "deg/s");
  for (const double factor : {0.45, 2.2}) {
    EXPECT_EQ(rocking(0.3, factor), "rad/s");
    EXPECT_EQ(rocking(0.3, factor * perRad), "deg/s");
  }
  EXPECT_TRUE(rocking(0.3, 0.35).starts_with(unclear));
  EXPECT_TRUE(rocking(0.3, 3).starts_with(unclear));
  EXPECT_EQ(rocking(0.04, perRad), "deg/s") << "half a second turns it by 1.5 degrees";
  // Half a second shows 0.96 of a slow rocking and 1.9 of a fast one: they are alike by 0.8 and by 0.6.
  EXPECT_EQ(rocking(0.3, 1, 0.114), "rad/s");
  EXPECT_TRUE(rocking(0.3, 1, 0.202).starts_with(unclear));
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
  EXPECT_EQ(guessTimeUnit(1 / 1100.0, 100).unit, "s");
  EXPECT_NE(thrownBy([] { guessTimeUnit(1 / 1400.0, 100); }), "nothing thrown");
  EXPECT_EQ(guessTimeUnit(1 / 9.0, 100).unit, "s");
  EXPECT_NE(thrownBy([] { guessTimeUnit(1 / 7.0, 100); }), "nothing thrown");
  EXPECT_EQ(thrownBy([] { guessTimeUnit(1, 50); }),
            "advances by 1 a line, in no unit near 50 Hz; write unit: s, ms, us or ns");
}

}  // namespace
}  // namespace plumbline::gap
