#pragma once
#include "framework/Module.h"
#include "representations/communication/TeamBelief.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/perception/HearPercept.h"

namespace plumbline {

MODULE(TeamComRecv)
  REQUIRES(FrameInfo)
  REQUIRES(PlayerInfo)
  REQUIRES(HearPercept)
  PROVIDES(TeamComDataIn)
  PARAMETER(int, oldestSlot, 4, "", Range(0, 100),
            "slots of 0.04 s that a message may take from mouth to ear; an older one is not believed")
END_MODULE

/// Understands what mates say. Believed is what has the own team's name and a checksum that fits team and
/// time, of another number than the own.
class TeamComRecv : public TeamComRecvBase {
public:
  void update(TeamComDataIn* theTeamComDataIn) override;
};

}  // namespace plumbline
