#pragma once
#include <string>

#include "record/LogReader.h"
#include "situation/Situation.h"

namespace plumbline {

/// What a player believed at a time of its log (the cycle at that time of the log or the last before it [s]),
/// as a situation of that kind. What people expect is not in it. Throws std::runtime_error, one line, for
/// a time outside the log, a representation that is missing or had other members, and a player that does not
/// know its own place or the ball.
Situation situationOfLog(record::LogReader& log, const record::LogReader::Thread& thread, double time,
                         const SituationKind& kind);

}  // namespace plumbline
