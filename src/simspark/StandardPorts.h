#pragma once

namespace plumbline::simspark {

/// Where a simulator listens unless it is asked to listen elsewhere; the first two are the league server's.
inline constexpr int standardAgentPort = 3100, standardMonitorPort = 3200;
/// Of bin/simulator's compact messages of the field (FieldMessage).
inline constexpr int standardFieldPort = 3201;

}  // namespace plumbline::simspark
