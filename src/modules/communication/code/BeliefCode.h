#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "representations/communication/TeamBelief.h"

namespace plumbline {

/// A belief as a text of 20 letters and back (doc/reference/team-messages.md has the table of bits). Largest
/// errors: a robot 3.2 cm along the field, 4.3 cm across, heading 5.7 degrees; the ball 3.2 and 2.2 cm, its
/// speed 0.5 m/s per axis; opponents 13 and 8.6 cm; time to the ball 0.13 s up to 16 s.
/// team, slot: a word of the team and the slot of time in which it is said go into a checksum of 16 bits, so
/// that nothing is believed that another team says, or says again later.
std::string encodeBelief(const TeamBelief& belief, std::string_view team, std::int64_t slot);

/// Nothing if it is no message of this team said in this slot.
std::optional<TeamBelief> decodeBelief(std::string_view text, std::string_view team, std::int64_t slot);

}  // namespace plumbline
