#pragma once
#include <string>

#include "framework/Representation.h"

namespace plumbline {

/// The bytes of one message of the simulator, without the length in front.
REPRESENTATION(ServerMessageText)
class ServerMessageText : public ServerMessageTextBase {
public:
  std::string text;
  void stream(InStream* in, OutStream* out) override { STREAM(text); }
};

}  // namespace plumbline
