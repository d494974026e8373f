#pragma once

namespace plumbline {

struct StrikerSituation;

inline constexpr double flyingShare = 0.6;  ///< of its way over which a kick flies

/// The probability that a kick which rises so high [m] is below the goal's bar at a share of its flight. The
/// height is normally distributed about a parabola.
double shareUnderBar(const StrikerSituation& situation, double share, double rise);

}  // namespace plumbline
