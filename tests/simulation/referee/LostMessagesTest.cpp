#include "simulation/referee/rules/LostMessages.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simspark/ServerMessageParser.h"
#include "simulation/Simulation.h"

namespace plumbline::simulation {
namespace {

/// How many of a player's 400 messages another one hears, as a text of ones and zeros.
std::string heardBy(double share, std::uint64_t seed) {
  SimulationConfig config;
  config.seed = seed;
  config.rules.of<LostMessages>().share = share;
  Simulation simulation(config);
  const PlayerId speaker = simulation.addPlayer(0), listener = simulation.addPlayer(0);
  simspark::AgentCommand command;
  for (const auto& [id, number] : {std::pair(speaker, 1), std::pair(listener, 2)}) {
    command.init = simspark::InitRequest{number, "Red"};
    simulation.act(id, command);
  }
  command.init.reset();
  for (int i = 0; i < 2; ++i) simulation.step();  // they come into the team
  std::string heard;
  for (int i = 0; i < 800; ++i) {
    command.say = i % 2 == 0 ? std::optional<std::string>("word") : std::nullopt;
    simulation.act(speaker, command);
    simulation.step();
    if (i % 2 != 0) continue;
    const auto heardOf = [&](PlayerId id) {
      simspark::ServerMessage message;
      EXPECT_FALSE(simspark::parseServerMessage(simulation.message(id), message));
      return message.heard.size();
    };
    EXPECT_EQ(heardOf(speaker), 1u) << "a player hears itself";
    heard += heardOf(listener) > 0 ? '1' : '0';
  }
  return heard;
}

TEST(LostMessagesTest, noneInTheLeague) {
  EXPECT_EQ(heardBy(Rules().of<LostMessages>().share, 1), std::string(400, '1'));
}

TEST(LostMessagesTest, theShareByLotFromTheSeed) {
  const std::string half = heardBy(0.5, 1);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(half, '1')), 200, 40);  // four standard deviations
  EXPECT_EQ(heardBy(0.5, 1), half);
  EXPECT_NE(heardBy(0.5, 2), half);
  EXPECT_EQ(heardBy(1, 1), std::string(400, '0'));
}

TEST(LostMessagesTest, eachListenerHasItsOwnLot) {
  Rules rules;
  rules.of<LostMessages>().share = 0.5;
  const LostMessages rule;
  int differ = 0;
  for (std::uint64_t cycle = 0; cycle < 100; ++cycle)
    differ += rule.loses(rules, {1, cycle, 1, 2}) != rule.loses(rules, {1, cycle, 1, 3});
  EXPECT_NEAR(differ, 50, 20);
}

}  // namespace
}  // namespace plumbline::simulation
