// The readers of SimSpark's wire and of the compact port.
#include "fuzz/Targets.h"
#include "simspark/AgentCommand.h"
#include "simspark/FieldMessage.h"
#include "simspark/FieldScene.h"
#include "simspark/Framing.h"
#include "simspark/SceneState.h"
#include "simspark/ServerMessageParser.h"
#include "simspark/ServerMessageWriter.h"
#include "simspark/TrainerCommand.h"
#include "support/Samples.h"

namespace plumbline::fuzz {

using namespace simspark;

void agentMessage(std::string_view bytes) {
  AgentCommandParser parser;
  AgentCommand command, again;
  if (!parser.parse(bytes, command).empty()) return;
  require(parser.parse(writeAgentCommand(command), again).empty(), "an agent's command is not read back");
}

void trainerMessage(std::string_view bytes) {
  TrainerCommandParser parser;
  std::vector<TrainerCommand> commands, again;
  parser.parse(bytes, commands);
  for (const TrainerCommand& command : commands)
    require(parser.parse(writeTrainerCommand(command), again).empty(),
            "a trainer's command is not read back");
  require(commands.size() == again.size(), "a trainer's command was read back as several");
  readClock(bytes);
}

void serverMessage(std::string_view bytes) {
  ServerMessage message, again;
  if (parseServerMessage(bytes, message)) return;
  std::string first, second;
  appendServerMessage(first, message);
  if (parseServerMessage(first, again)) return;  // what the writer may cut: names with odd characters
  appendServerMessage(second, again);
}

/// Messages in lines.
void monitorScene(std::string_view bytes) {
  SceneState scene;
  FieldScene quick;
  for (std::size_t begin = 0; begin <= bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    scene.update(bytes.substr(begin, end - begin));
    quick.update(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  FieldState state;
  require(readFieldMessage(writeFieldMessage(quick.state()), state).empty(),
          "the quick reader tells nonsense");
  require(readFieldMessage(writeFieldMessage(fieldState(scene)), state).empty(),
          "a scene's field message is not read");
}

/// First byte: size of the pieces it comes in.
void framing(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::size_t piece = 1 + static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  FrameReader whole(maxAgentMessage), pieces(maxAgentMessage);
  std::vector<std::string> first, second;
  const auto drain = [](FrameReader& reader, std::vector<std::string>& messages) {
    for (std::string_view message; reader.next(message) == FrameReader::Status::message;)
      messages.emplace_back(message);
  };
  whole.feed(bytes);
  drain(whole, first);
  for (std::size_t i = 0; i < bytes.size(); i += piece) {
    pieces.feed(bytes.substr(i, piece));
    drain(pieces, second);
  }
  require(first == second, "frames depend on how the bytes arrive");
}

void fieldMessage(std::string_view bytes) {
  FieldState state, again;
  if (!readFieldMessage(bytes, state).empty()) return;
  const std::string written = writeFieldMessage(state);
  require(readFieldMessage(written, again).empty(), "a field message is not read back");
  require(writeFieldMessage(again) == written, "a field message changes when it is read back");
}

std::vector<std::string> agentMessageSeeds() {
  return {
      "(he1 1.5)(lle4 -0.25)(beam -1 2 90)(say hello)(init (unum 3)(teamname A))"
      "(scene rsg/agent/nao/nao_hetero.rsg 4)(pass)(syn)",
      "(syn)", "(lae1 1e-3)(rae1 -7)(lle7 0.5)(rle7 0)(syn)", "(scene rsg/agent/nao/nao.rsg)(syn)"};
}

std::vector<std::string> trainerMessageSeeds() {
  return {
      "(agent (unum 1)(team Left)(move 1 2 3 4))(ball (pos 1 2 3)(vel 4 5 6))(playMode PlayOn)(kickOff None)"
      "(score (left 1)(right 2))(time 4)(select)(kill (unum 1)(team Right))(repos)(reqfullstate)(getAck)",
      "(agent (unum 11)(team Right)(pos -1 -2 0.4))(select (unum -1))(select (unum 2)(team Left))(kill)",
      "(repos (unum 4)(team Left))(dropBall)(killsim)(kickOff Right)(ball (vel 1 0 0))",
      "(clock)(pause)(resume)(step 10)(speed 2.5)(viewer 0.03)",
      "(clock (paused 0)(speed 1))",
      "(init)(token secret)"};
}

std::vector<std::string> serverMessageSeeds() {
  std::vector<std::string> seeds;
  for (const char* name : {"agent_type0", "agent_type4", "agent_game_22_players"}) {
    const auto more = test::samples(name);
    for (std::size_t i = 0; i < std::min<std::size_t>(more.size(), 40); i += 3) seeds.push_back(more[i]);
  }
  return seeds;
}

std::vector<std::string> monitorSceneSeeds() {
  const auto two = test::samples("monitor_two_agents"), none = test::samples("monitor_first3");
  return {two[0] + '\n' + two[1] + '\n' + two[2], two[0], none[1] + '\n' + none[5], two[0] + '\n' + none[5],
          "((time 1)(play_modes A B)(play_mode 1))(RSG 0 1)((nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1)"
          "(nd StaticMesh (load models/naobody2.obj)(resetMaterials matNum3 matLeft))))\n"
          "((time 2))(RDS 0 1)((nd (SLT 1 0 0 0 0 1 0 0 0 0 1 0 4 5 6 1)(nd StaticMesh)))"};
}

std::vector<std::string> framingSeeds() {
  std::string frames("\x03", 1);
  for (const char* text : {"(syn)", "", "(he1 1)(syn)", "(init (unum 1)(teamname A))"})
    appendFrame(frames, text);
  std::string tooLong("\xff", 1);
  appendFrame(tooLong, "(syn)");
  appendFrameHeader(tooLong, maxAgentMessage + 1);
  return {frames, tooLong, std::string("\0\0\0\0\0", 5)};
}

std::vector<std::string> fieldMessageSeeds() {
  return {
      "(field 1)(t 83.42)(s 2 1 3)(m PlayOn)(nl Red)(nr Blue)(b -123 500 4)(l 1 -1450 0 0)(r 11 301 -200 180 "
      "f)"
      "(o 0 0 -100 -90)",
      "(field 1)(t 0.00)(s 1 0 0)(m BeforeKickOff)(b 0 0 4)"};
}

namespace {
const Registered agentMessageTarget({"agentMessage", agentMessage, agentMessageSeeds, 40000});
const Registered trainerMessageTarget({"trainerMessage", trainerMessage, trainerMessageSeeds, 40000});
const Registered serverMessageTarget({"serverMessage", serverMessage, serverMessageSeeds, 20000});
const Registered monitorSceneTarget({"monitorScene", monitorScene, monitorSceneSeeds, 6000});
const Registered framingTarget({"framing", framing, framingSeeds, 40000});
const Registered fieldMessageTarget({"fieldMessage", fieldMessage, fieldMessageSeeds, 40000});
}  // namespace

}  // namespace plumbline::fuzz
