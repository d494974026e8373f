// The whole agent behind its parser: messages of a server, one in a line, a cycle for each.
#include <cmath>
#include <memory>

#include "framework/Controller.h"
#include "fuzz/Readers.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/motion/JointRequest.h"
#include "support/PerceptionModules.h"
#include "support/Samples.h"

namespace plumbline::fuzz {
namespace {

constexpr int agentCycles = 25;

/// The speeds that it asks of its joints are numbers, and of a size that joints have.
void agent(std::string_view bytes) {
  const auto source = std::make_shared<test::MessageSource>();
  Controller controller(ControllerOptions{}, test::playingModules());
  controller.objects().set(std::make_shared<AgentOptions>());
  controller.objects().set(source);
  int cycles = 0;
  for (std::size_t begin = 0; begin < bytes.size() && cycles < agentCycles; ++cycles) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    source->text = bytes.substr(begin, end - begin);
    begin = end + 1;
    controller.runCycles(1);
    for (const double speed : controller.find<JointRequestWithSpeeds>()->speeds)
      require(std::abs(speed) < 1e3, "a speed that no joint has");
  }
}

std::vector<std::string> agentSeeds() {
  std::vector<std::string> all;
  for (const char* name : {"agent_type0", "agent_type4", "agent_game_22_players"}) {
    const auto messages = test::samples(name);
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(messages.size(), 8); ++i) text += messages[i] + '\n';
    all.push_back(text);
  }
  return all;
}

const Registered agentTarget({"agent", agent, agentSeeds, 240});

}  // namespace
}  // namespace plumbline::fuzz
