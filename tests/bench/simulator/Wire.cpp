#include <algorithm>
#include <string>

#include "Bending.h"
#include "Figures.h"
#include "simspark/ServerMessageParser.h"
#include "support/Samples.h"

namespace plumbline::bench {

namespace {

std::string longest(const char* sample) {
  const auto all = test::samples(sample);
  return *std::max_element(all.begin(), all.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

}  // namespace

void measureWire(Figures& figures) {
  simspark::ServerMessageParser reader;  // one for all messages, as an agent has it
  simspark::ServerMessage message;
  const std::string alone = longest("agent_type0"), crowd = longest("agent_game_22_players");
  figures.add("parse_message_us", cpuPerCall(5000, [&] { reader.parse(alone, message); }), "us", "lower", 60);
  figures.add("parse_message_of_22_us", cpuPerCall(5000, [&] { reader.parse(crowd, message); }), "us",
              "lower");
  const std::string text = simspark::writeAgentCommand(bending(7));
  simspark::AgentCommandParser parser;
  simspark::AgentCommand command;
  figures.add("parse_command_us", cpuPerCall(20000, [&] { parser.parse(text, command); }), "us", "lower");
}

}  // namespace plumbline::bench
