// A simulation that has run for so long that its cycles no longer fit into 31 or 32 bits, or for 10,000 days,
// goes on as on its first day.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "simulation/Simulation.h"

namespace plumbline::simulation {
namespace {

struct Message {
  std::string now, rest;
};

/// A message's clock, and all else that it says.
Message taken(const std::string& message) {
  const std::string name = "(now ";
  const std::size_t begin = message.find(name) + name.size(), end = message.find(')', begin);
  return {message.substr(begin, end - begin), message.substr(0, begin) + message.substr(end)};
}

/// What two robots hear in three seconds of a game in which one swings an arm and talks.
std::vector<Message> heard(std::uint64_t firstCycle) {
  SimulationConfig config;
  config.firstCycle = firstCycle;
  Simulation simulation(config);
  PlayerId ids[2] = {simulation.addPlayer(0), simulation.addPlayer(4)};
  for (int i = 0; i < 2; ++i) {
    simspark::AgentCommand command;
    command.init = simspark::InitRequest{0, i == 0 ? "A" : "B"};
    simulation.act(ids[i], command);
  }
  EXPECT_EQ(simulation.train(simspark::KickOffCommand{simspark::TeamSide::left}), "");
  std::vector<Message> messages;
  for (int i = 0; i < 150; ++i) {
    simspark::AgentCommand command;
    command.velocity[rElbowRoll] = i % 20 < 10 ? 2 : -2;
    if (i % 10 == 0) command.say = "cycle" + std::to_string(i);
    simulation.act(ids[0], command);
    simulation.step();
    EXPECT_EQ(simulation.cycle(), firstCycle + static_cast<std::uint64_t>(i) + 1);
    if (i > 0)
      for (const PlayerId id : ids) messages.push_back(taken(simulation.message(id)));
  }
  return messages;
}

TEST(SimulationClock, nothingChangesWhereCyclesNoLongerFitIntoThirtyTwoBits) {
  const std::vector<Message> first = heard(0);
  ASSERT_EQ(first.size(), 298U);
  for (const std::uint64_t from : {(1ULL << 31) - 75, (1ULL << 32) - 75, 10000ULL * 86400 * 50}) {
    SCOPED_TRACE(from);
    const std::vector<Message> later = heard(from);
    ASSERT_EQ(later.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_EQ(later[i].rest, first[i].rest) << "message " << i;
      ASSERT_NEAR(std::atof(later[i].now.c_str()) - std::atof(first[i].now.c_str()),
                  static_cast<double>(from) * 0.02, 0.006)
          << "message " << i;
    }
  }
}

}  // namespace
}  // namespace plumbline::simulation
