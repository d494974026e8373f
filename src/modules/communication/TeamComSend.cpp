#include "modules/communication/TeamComSend.h"

#include "modules/communication/code/BeliefCode.h"
#include "modules/communication/code/SaySlot.h"

namespace plumbline {

MAKE_MODULE(TeamComSend)

void TeamComSend::update(SayMessage* theSayMessage) {
  theSayMessage->text.clear();
  if (theFrameInfo->restarted) said_ = -1;
  const std::int64_t slot = SaySlot::at(theFrameInfo->time);
  const int number = thePlayerInfo->number;
  if (slot == said_ || number < 1 || SaySlot::speaker(slot) != number) return;
  said_ = slot;
  theSayMessage->text = encodeBelief(theTeamComDataOut->belief, thePlayerInfo->team, slot);
  // As it is understood, so that this player decides on the same numbers as its mates.
  if (const auto understood = decodeBelief(theSayMessage->text, thePlayerInfo->team, slot))
    theSayMessage->said = *understood;
  theSayMessage->time = theFrameInfo->time;
}

}  // namespace plumbline
