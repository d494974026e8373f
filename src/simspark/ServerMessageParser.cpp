#include "simspark/ServerMessageParser.h"

#include <algorithm>
#include <array>
#include <utility>

#include "simspark/Framing.h"
#include "simspark/GroundTruthNode.h"
#include "simspark/NodeReader.h"
#include "simspark/SeeNode.h"
#include "simspark/SenseNodes.h"

namespace plumbline::simspark {

namespace {

using ReadNode = void (*)(NodeReader&, SExpressions::Node, ServerMessage&);

/// The frequent ones first.
constexpr std::array<std::pair<std::string_view, ReadNode>, 9> readers{{{"HJ", readHingeJoint},
                                                                        {"FRP", readForce},
                                                                        {"hear", readHeard},
                                                                        {"time", readTime},
                                                                        {"GS", readGameState},
                                                                        {"GYR", readGyro},
                                                                        {"ACC", readAcceleration},
                                                                        {"See", readSee},
                                                                        {"GT", readGroundTruth}}};

}  // namespace

std::optional<ParseError> ServerMessageParser::parse(std::string_view text, ServerMessage& message) {
  message = ServerMessage();
  if (text.size() > maxServerMessage) return ParseError{0, "longer than any message of the server"};
  const bool whole = tree_.parse(text);
  NodeReader reader(text);
  for (SExpressions::Node node = tree_.first(); node && !reader.failed(); node = node.next()) {
    if (!node.isList()) {
      reader.fail(node.text(), "a word outside of all parentheses");
      break;
    }
    const std::string_view name = node.name();
    const auto known = std::ranges::find(readers, name, [](const auto& entry) { return entry.first; });
    if (known != readers.end()) known->second(reader, node, message);
  }
  if (reader.failed()) return reader.error();
  if (!whole) return ParseError{tree_.errorPosition(), tree_.error()};
  return {};
}

std::optional<ParseError> parseServerMessage(std::string_view text, ServerMessage& message) {
  return ServerMessageParser().parse(text, message);
}

}  // namespace plumbline::simspark
