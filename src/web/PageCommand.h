#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "field/FieldSize.h"
#include "simspark/TrainerCommand.h"

namespace plumbline::web {

// What a page asks for.
struct ResetGame {};  ///< score 0:0, clock 0, before the kick-off, ball in the middle
struct Seek {
  double time;
};  ///< of a recorded match [s]
struct PlayRecording {
  bool playing;
};
struct RecordingRate {
  double rate;  ///< times real time
};
using PageCommand = std::variant<simspark::TrainerCommand, ResetGame, Seek, PlayRecording, RecordingRate>;

/// Reads {"do":"kickOff","side":"left"} and its like (doc/reference/web-protocol.md). Returns empty or one
/// line why it cannot; then `command` is untouched.
std::string parsePageCommand(std::string_view json, PageCommand& command);

/// The trainer commands that make up a new game; robots stay where they are, agents beam themselves.
std::vector<simspark::TrainerCommand> resetGame(const FieldSize& field);

}  // namespace plumbline::web
