#pragma once
#include <string>

#include "framework/Representation.h"

namespace plumbline {

/// Who this robot is.
REPRESENTATION(PlayerInfo)
class PlayerInfo : public PlayerInfoBase {
public:
  std::string team;
  int number = 0;     ///< 0 until the server has assigned it
  std::string robot;  ///< name of its file in config/robots
  bool sideKnown = false;
  bool leftSide = true;  ///< own goal at x = -15 of the server's field
  void stream(InStream* in, OutStream* out) override {
    STREAM(team);
    STREAM(number);
    STREAM(robot);
    STREAM(sideKnown);
    STREAM(leftSide);
  }
};

}  // namespace plumbline
