#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "simspark/SExpression.h"
#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// Why and at which byte of the text a message could not be read.
struct ParseError {
  std::size_t position = 0;
  std::string what;
};

/// Reads messages of the server to an agent (without frame). Nodes that it does not know are skipped, at the
/// top and inside known ones; a known one with too few or too many words is an error.
class ServerMessageParser {
public:
  /// Fills message, whose old content goes. On an error it holds what came before it.
  std::optional<ParseError> parse(std::string_view text, ServerMessage& message);

private:
  SExpressions tree_{{.nodes = 1 << 16}};  ///< keeps its memory; with 22 players it has some 2,000 nodes
};

/// The same for one message.
std::optional<ParseError> parseServerMessage(std::string_view text, ServerMessage& message);

}  // namespace plumbline::simspark
