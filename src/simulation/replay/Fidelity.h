#pragma once
#include <string>
#include <vector>

#include "simspark/LeagueTrace.h"

namespace plumbline::simulation {

/// A figure of a whole trace, of the league's and of ours.
struct TraceFigure {
  std::string name, unit;
  double league = 0, ours = 0;
};

/// How far ours is from the league's; -1 as a row means never.
struct TraceDeviation {
  double position2s = 0, position = 0;  ///< torso, largest in the first 2 s and in all [m]
  double rotation2s = 0, rotation = 0;  ///< torso [rad]
  double heading2s = 0, heading = 0;    ///< torso [rad]
  double positionAtEnd = 0;             ///< [m]
  double angle2s = 0, angle = 0;        ///< of the worst joint [rad]; the trace is rounded to 0.01 degrees
  double ball = 0;                      ///< horizontally, largest [m]
  double gyroRms = 0, accRms = 0;       ///< [rad/s], [m/s^2]; without the first two rows
  double footForceRms = 0;              ///< vertical, both feet and toes summed [N]
  int rowOff1mm = -1, rowOff1cm = -1;   ///< first row in which the torso is off by this
};

/// Figures of standing, falling, walking, turning and of the ball, as far as the trace shows them.
std::vector<TraceFigure> figures(const std::vector<simspark::TraceRow>& league,
                                 const std::vector<simspark::TraceRow>& ours);
/// Both must have the same number of rows.
TraceDeviation deviation(const std::vector<simspark::TraceRow>& league,
                         const std::vector<simspark::TraceRow>& ours);

/// Both as a table for people: name, league, ours, difference.
std::string fidelityReport(const simspark::LeagueTrace& trace, const std::vector<simspark::TraceRow>& ours,
                           int robotType);

}  // namespace plumbline::simulation
