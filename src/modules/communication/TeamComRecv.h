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

/// Decodes messages of team mates. Accepts a message if its checksum fits the own team's name and the time,
/// and its number is not the own one.
class TeamComRecv : public TeamComRecvBase {
public:
  void update(TeamComDataIn* theTeamComDataIn) override;
};

}  // namespace plumbline
