#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "gap/record/Excitation.h"
#include "gap/run/Run.h"
#include "simspark/StandardPorts.h"

namespace plumbline::gap {

struct SimsparkRecordingOptions {
  std::string host = "127.0.0.1";
  int port = simspark::standardAgentPort;
  int type = 0;  ///< of the robot, as simsparkRobots
  std::string team = "Plumbline";
  int number = 0;      ///< of the player; 0: the next free one
  double timeout = 5;  ///< the server must send its next message within [s]
  /// Asked between cycles; true ends the recording with an error.
  std::function<bool()> stop = {};
};

/// A recorded run and what happened during it.
struct SimsparkRecording {
  Run run;
  std::size_t lostCycles = 0;  ///< whose message never came; the run has gaps in its times there
  bool fell = false;           ///< the torso leaned by more than 60 degrees
};

/// Number of cycles between two times of the server's clock [s]. The league's server counts in single
/// precision and prints hundredths: after hours, 0.01 to 0.03 s there are one cycle. 0: the clock stood
/// still.
std::size_t cyclesBetween(double before, double now);

/// Plays a program on a robot of a SimSpark server, the league's or bin/simulator, through its agent port. It
/// creates the robot, has it put on its feet, moves it to the first posture in 3 s, then plays. The server's
/// joints turn at a commanded speed, one cycle after the command. The speeds are chosen so that each cycle
/// ends where the servo law of the robot's file would move the joint, dq/dt = kp/kd (cmd - q). The run says
/// that commands act a cycle late (timing). The resultant force on a foot is recorded as forces on four
/// corners with the same sum and point. Channels: cmd, pos, gyro, acc, fsr. Errors: std::runtime_error, one
/// line, if the server is missing, disconnects or stays silent. std::invalid_argument for a program with a
/// fixed base (the server cannot hang up a robot), or a robot with a joint that SimSpark's robots do not
/// have.
SimsparkRecording recordSimspark(const Mechanism& robot, const Excitation& program,
                                 const SimsparkRecordingOptions& options);

}  // namespace plumbline::gap
