#include "gap/blind/Planting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "gap/blind/RealArm.h"
#include "gap/run/Channel.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

const RealRecordings& arm() { return realArm(); }

/// How far the planted model with the planted cause is from the nominal one, as a share of the plant's
/// change.
double inexactness(const RealRecordings& base, const Cause& cause) {
  const RealRecordings with = planted(base, cause);
  const std::vector<double> nominal = residualsOf(base, {});
  const double change = differenceOf(residualsOf(with, {}), nominal);
  EXPECT_GT(change, 1e-5) << describe(cause);
  return differenceOf(residualsOf(with, {cause}), nominal) / change;
}

TEST(Planting, whatIsTakenOutOfTheModelIsWhatRealityHasMore) {
  for (const auto& [id, place, value] :
       {std::tuple{"servo_gain", "Elbow", 1.3}, std::tuple{"servo_damping", "Elbow", 1.5},
        std::tuple{"rotor_inertia", "Elbow", -0.004}, std::tuple{"link_mass", "lower", 0.05},
        std::tuple{"link_length", "lower", 1.1}, std::tuple{"joint_offset", "Elbow", 0.05},
        std::tuple{"command_delay", "*", 0.02}, std::tuple{"bias_force", "Elbow", 0.1},
        std::tuple{"command_lag", "Elbow", 0.02}, std::tuple{"command_lag", "Elbow", 0.1}})
    EXPECT_LT(inexactness(arm(), causeOf(arm().robot, id, place, value)), 0.05) << id;
}

TEST(Planting, aMotorWithALawOfItsOwn) {
  const RealRecordings pendulum = realRecordings(findMechanism("xl330_pendulum"), "pendulum");
  for (const auto& [id, place, value] :
       {std::tuple{"servo_gain", "pendulum", 1.3}, std::tuple{"servo_damping", "pendulum", 1.3},
        std::tuple{"joint_offset", "pendulum", -0.05}, std::tuple{"command_delay", "pendulum", 0.02},
        std::tuple{"command_lag", "pendulum", 0.02}})
    EXPECT_LT(inexactness(pendulum, causeOf(pendulum.robot, id, place, value)), 0.05) << id;
  std::set<std::string_view> kinds;
  for (const Cause& cause : plantsFor(pendulum)) kinds.insert(cause.effect->id);
  EXPECT_FALSE(kinds.count("speed_limit") || kinds.count("torque_limit") || kinds.count("bias_force"));
  EXPECT_TRUE(kinds.count("servo_gain") && kinds.count("com_offset"));
}

TEST(Planting, aFilterOfCommandsThatMoveLinearlyIsTakenOutToo) {
  RealRecordings lines = arm();
  for (auto& run : lines.runs) run.linearCommands = true;
  lines = {lines.robot, lines.runs};
  EXPECT_LT(inexactness(lines, causeOf(lines.robot, "command_lag", "Elbow", 0.03)), 0.05);
}

TEST(Planting, aFilterIsTakenOutWhereCommandsWereNotRead) {
  RealRecordings holes = arm();
  for (auto& run : holes.runs)
    for (std::size_t k = 50; k < run.size(); k += 7)
      run.channels.at("cmd.Elbow")[k] = std::numeric_limits<double>::quiet_NaN();
  holes = {holes.robot, holes.runs};
  const RealRecordings with = planted(holes, causeOf(holes.robot, "command_lag", "Elbow", 0.03));
  EXPECT_TRUE(std::isnan((*with.runs[0].find("cmd.Elbow"))[57]));
  EXPECT_TRUE(std::isfinite((*with.runs[0].find("cmd.Elbow"))[58]));
  EXPECT_LT(inexactness(holes, causeOf(holes.robot, "command_lag", "Elbow", 0.03)), 0.1);
}

TEST(Planting, settingsOfARunAreChangedWithTheModel) {
  RealRecordings own = arm();
  for (auto& run : own.runs) run.servo["Elbow"].kp = 4;
  own = {own.robot, own.runs};
  const Cause gain = causeOf(own.robot, "servo_gain", "Elbow", 1.3);
  EXPECT_NEAR(*planted(own, gain).runs[0].servo.at("Elbow").kp, 4 / 1.3, 1e-12);
  EXPECT_LT(inexactness(own, gain), 0.05);
}

TEST(Planting, theMeasurementsStayReal) {
  const RealRecordings with = planted(arm(), causeOf(arm().robot, "link_mass", "lower", 0.05));
  EXPECT_EQ(with.runs[0].channels, arm().runs[0].channels);
  const RealRecordings offset = planted(arm(), causeOf(arm().robot, "joint_offset", "Elbow", 0.05));
  EXPECT_NEAR((*offset.runs[0].find("pos.Elbow"))[7], (*arm().runs[0].find("pos.Elbow"))[7] - 0.05, 1e-12);
  EXPECT_EQ(*offset.runs[0].find("pos.Shoulder"), *arm().runs[0].find("pos.Shoulder"));
}

TEST(Planting, whatWouldLeaveNothingIsRefused) {
  EXPECT_EQ(thrownBy([] { planted(arm(), causeOf(arm().robot, "link_mass", "lower", 0.2)); }),
            "no mass would be left");
  EXPECT_EQ(thrownBy([] { planted(arm(), causeOf(arm().robot, "rotor_inertia", "Elbow", 0.002)); }),
            "no rotor would be left");
}

TEST(Planting, onlyAtJointsThatWereRecorded) {
  RealRecordings elbow = arm();
  for (auto& run : elbow.runs) run.channels.erase("cmd.Shoulder");
  elbow = {elbow.robot, elbow.runs};
  for (const Cause& cause : plantsFor(elbow))
    EXPECT_TRUE(cause.place.at != "Shoulder" && cause.place.at != "upper");
  EXPECT_FALSE(plantsFor(elbow).empty());
}

TEST(Planting, aSizeIsSearchedThatMovesTheReplayAsWanted) {
  const std::vector<double> nominal = residualsOf(arm(), {});
  for (const double wanted : {0.002, 0.01}) {
    const Cause cause = sized(arm(), causeOf(arm().robot, "servo_gain", "Shoulder", 1.2), wanted);
    EXPECT_GT(cause.value, 1);
    EXPECT_NEAR(differenceOf(residualsOf(planted(arm(), cause), {}), nominal) / wanted, 1, 0.3);
  }
}

TEST(Planting, theSameThingInAnotherNameLeavesLittle) {
  const RealRecordings pendulum = realRecordings(findMechanism("xl330_pendulum"), "pendulum");
  const Cause shift = causeOf(pendulum.robot, "link_length", "arm", 1.1);
  const RealRecordings with = planted(pendulum, shift);
  const auto plants = plantsFor(pendulum);
  const auto along = std::ranges::find_if(
      plants, [](const Cause& cause) { return cause.effect->id == "com_offset" && cause.place.axis == 'z'; });
  ASSERT_NE(along, plants.end());
  EXPECT_LT(leftOfPlant(pendulum, with, *along), 0.1);
  EXPECT_GT(leftOfPlant(pendulum, with, causeOf(pendulum.robot, "joint_offset", "pendulum", 0.05)), 0.3);
}

}  // namespace
}  // namespace plumbline::gap
