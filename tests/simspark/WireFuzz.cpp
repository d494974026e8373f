// Every reader of the wire against any bytes. LLVMFuzzerTestOneInput is libFuzzer's entry: with clang,
//   clang++ -std=c++20 -g -fsanitize=fuzzer,address,undefined -DPLUMBLINE_FUZZER -Isrc -Itests
//     -Ibuild/generated/src -I/usr/include/eigen3 tests/simspark/WireFuzz.cpp src/simspark/*.cpp
//     build/generated/src/simspark/*.cpp
// makes a fuzzer of it; here it runs on damaged recordings.
#include <cstdint>
#include <string>
#include <string_view>

#include "simspark/AgentCommand.h"
#include "simspark/Framing.h"
#include "simspark/SceneState.h"
#include "simspark/ServerMessageParser.h"
#include "simspark/ServerMessageWriter.h"
#include "simspark/TrainerCommand.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumbline::simspark;
  const std::string_view text(reinterpret_cast<const char*>(data), size);

  FrameReader reader(maxAgentMessage);
  reader.feed(text);
  for (std::string_view message; reader.next(message) == FrameReader::Status::message;) {
  }

  ServerMessage message;
  if (!parseServerMessage(text, message)) {  // what was read without error is read again from what is written
    std::string written, again;
    appendServerMessage(written, message);
    ServerMessage second;
    if (!parseServerMessage(written, second)) appendServerMessage(again, second);
  }

  AgentCommandParser agentParser;
  AgentCommand command;
  if (agentParser.parse(text, command).empty()) {
    AgentCommand second;
    if (!agentParser.parse(writeAgentCommand(command), second).empty()) __builtin_trap();
  }

  TrainerCommandParser trainerParser;
  std::vector<TrainerCommand> commands, again;
  trainerParser.parse(text, commands);
  for (const TrainerCommand& trainerCommand : commands)
    if (!trainerParser.parse(writeTrainerCommand(trainerCommand), again).empty()) __builtin_trap();

  SceneState scene;
  scene.update(text);
  scene.update(text);
  return 0;
}

#ifndef PLUMBLINE_FUZZER
#include <gtest/gtest.h>

#include <random>

#include "support/Samples.h"

namespace plumbline::simspark {
namespace {

TEST(WireFuzz, damagedRecordings) {
  std::vector<std::string> seeds = test::samples("monitor_two_agents");
  for (const char* name : {"agent_type4", "agent_game_22_players"}) {
    const auto more = test::samples(name);
    seeds.insert(seeds.end(), more.begin(), more.begin() + 40);
  }
  seeds.emplace_back(
      "(he1 1.5)(lle4 -0.25)(beam -1 2 90)(say hello)(init (unum 3)(teamname A))(scene a.rsg 4)(pass)(syn)");
  seeds.emplace_back(
      "(agent (unum 1)(team Left)(move 1 2 3 4))(ball (pos 1 2 3)(vel 4 5 6))(playMode PlayOn)(kickOff None)"
      "(score (left 1)(right 2))(time 4)(select)(kill (unum 1)(team Right))(repos)(reqfullstate)(getAck)");
  std::mt19937 random(17);
  const std::string_view letters = "() \0-.0123456789eE+nai\xff\x80(PLSTRF";
  for (int round = 0; round < 4000; ++round) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned n = random() % 5; n > 0 && !text.empty(); --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = letters[random() % letters.size()];
          break;
        case 1:
          text.erase(at, 1 + random() % 50);
          break;
        case 2:
          text.resize(at);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 60));
      }
    }
    ASSERT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), 0);
  }
}

}  // namespace
}  // namespace plumbline::simspark
#endif
