#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "gap/record/Excitation.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

struct SimsparkRecordingOptions {
  std::string host = "127.0.0.1";
  int port = 3100;
  int type = 0;  ///< of the robot, 0..4
  std::string team = "Plumbline";
  int number = 0;      ///< of the player; 0: the next free one
  double timeout = 5;  ///< the server must send its next message within [s]
  /// Asked between cycles; true ends the recording with an error.
  std::function<bool()> stop = {};
};

/// What came beside the run.
struct SimsparkRecording {
  Run run;
  std::size_t lostCycles = 0;  ///< whose message never came; the run has gaps in its times there
  bool fell = false;           ///< the torso leaned by more than 60 degrees
};

/// How many cycles lie between two of the server's clock's times [s]. The league's counts in single precision
/// and prints hundredths: after hours a cycle is 0.01 to 0.03 s long there, and still one. 0: the clock stood
/// still.
std::size_t cyclesBetween(double before, double now);

/// Plays a program on a robot of a SimSpark server, the league's or bin/simulator, through its agent port:
/// asks for the robot, has it put on its feet, takes it to the first posture in 3 s, then plays. The server's
/// joints are turned by speed, one cycle after it was told: so that in a cycle they get as far as the servo
/// law of the robot's file takes them, dq/dt = kp/kd (cmd - q). The run says that commands come into force a
/// cycle late (timing). The resultant force on a foot is given as forces on four corners that have the same
/// sum and point. Channels: cmd, pos, gyro, acc, fsr. Errors: std::runtime_error, one line, for a server that
/// is not there, goes away or stays silent; std::invalid_argument for a program on a held base (a robot of
/// the server's cannot be hung up), or a robot with a joint that SimSpark's have not.
SimsparkRecording recordSimspark(const Mechanism& robot, const Excitation& program,
                                 const SimsparkRecordingOptions& options);

}  // namespace plumbline::gap
