#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "representations/communication/TeamBelief.h"

namespace plumbline {

/// Half the length and width of where a message can say that something is [m]; beyond them it says the edge.
/// They belong to the message, whose receivers must read the numbers that the sender wrote, so they are no
/// parameters. The field and a little around it must lie within; a test compares config/field.yaml.
inline constexpr double messageHalfLength = 16, messageHalfWidth = 11;

/// A belief as a text of 20 letters and back (doc/reference/team-messages.md has the table of bits). Largest
/// errors: own position 3.2 cm along the field, 4.3 cm across, heading 5.7 degrees; ball 3.2 and 2.2 cm, its
/// speed 0.5 m/s per axis. Opponents 13 and 8.6 cm; time to the ball 0.13 s up to 16 s. A checksum of 16 bits
/// includes team (a word) and slot (the time slot of the message). So messages of another team, or repeated
/// later, are not accepted.
std::string encodeBelief(const TeamBelief& belief, std::string_view team, std::int64_t slot);

/// Nothing if it is not a message of this team in this slot.
std::optional<TeamBelief> decodeBelief(std::string_view text, std::string_view team, std::int64_t slot);

}  // namespace plumbline
