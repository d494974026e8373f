#pragma once

namespace plumbline::motion {

// Defaults of the agent's modules by which a search of motions moves and judges the robot, too.
inline constexpr double standFade = 0.14;    ///< from the motion before into the stand [s]
inline constexpr double walkFade = 0.06;     ///< from the motion before into the walk [s]
inline constexpr double uprightTilt = 0.45;  ///< a robot that is tilted less is up again [rad]
inline constexpr double lyingTilt = 1.05;    ///< a robot that is tilted more for lyingSeconds lies [rad]
inline constexpr double lyingSeconds = 0.1;  ///< see lyingTilt [s]

}  // namespace plumbline::motion
