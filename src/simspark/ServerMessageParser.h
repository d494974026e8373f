#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// Why and at which byte of the text a message could not be read.
struct ParseError {
  std::size_t position = 0;
  std::string what;
};

/// Reads one message of the server to an agent (without frame) into message, whose old content goes. Nodes it
/// does not know are skipped. On an error message holds what came before it. Reentrant; takes no time but the
/// text's. Grammar: ServerMessage.y, words: ServerMessage.l.
std::optional<ParseError> parseServerMessage(std::string_view text, ServerMessage& message);

}  // namespace plumbline::simspark
