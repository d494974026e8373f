#pragma once
#include <cstdint>

#include "framework/Module.h"
#include "representations/communication/TeamBelief.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

MODULE(TeamComSend)
  REQUIRES(FrameInfo)
  REQUIRES(PlayerInfo)
  REQUIRES(TeamComDataOut)
  PROVIDES(SayMessage)
END_MODULE

/// Says what this player believes, once in each of its slots of time (SaySlot): every 0.44 s.
class TeamComSend : public TeamComSendBase {
public:
  void update(SayMessage* theSayMessage) override;

private:
  std::int64_t said_ = -1;  ///< the slot of the last text
};

}  // namespace plumbline
