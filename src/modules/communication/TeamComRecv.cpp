#include "modules/communication/TeamComRecv.h"

#include "modules/communication/code/BeliefCode.h"
#include "modules/communication/code/SaySlot.h"

namespace plumbline {

MAKE_MODULE(TeamComRecv)

void TeamComRecv::update(TeamComDataIn* theTeamComDataIn) {
  theTeamComDataIn->beliefs.clear();
  const std::int64_t now = SaySlot::at(theFrameInfo->time);
  for (const HeardText& heard : theHearPercept->messages) {
    // Not every server names the team; the checksum knows it anyway.
    if (heard.self || (!heard.team.empty() && heard.team != thePlayerInfo->team)) continue;
    ++theTeamComDataIn->heard;
    bool believed = false;
    for (std::int64_t slot = now; slot >= now - oldestSlot && !believed; --slot) {
      const auto belief = decodeBelief(heard.text, thePlayerInfo->team, slot);
      if (!belief || belief->number == thePlayerInfo->number || belief->number != SaySlot::speaker(slot))
        continue;
      theTeamComDataIn->beliefs.push_back(*belief);
      believed = true;
    }
    if (!believed) ++theTeamComDataIn->refused;
  }
}

}  // namespace plumbline
