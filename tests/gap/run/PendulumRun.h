#pragma once
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

inline constexpr double degree = 180 / std::numbers::pi;  ///< of a radian

/// A run of the rig with one joint: its command and what was measured, as functions of the time [s].
inline Run pendulumRun(const std::function<double(double)>& command,
                       const std::function<double(double)>& position, double rate = 100,
                       double seconds = 10) {
  Run run;
  run.folder = "r";
  run.robot = "xl330_pendulum";
  run.rateHz = rate;
  const auto samples = static_cast<std::size_t>(seconds * rate);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / rate;
    run.t.push_back(t);
    run.channels["cmd.pendulum"].push_back(command(t));
    run.channels["pos.pendulum"].push_back(position(t));
  }
  return run;
}

/// All that checkRun says of a run, which it may change, one line each; "refused: ..." where it throws.
inline std::string checked(Run& run, const std::string& robot) {
  std::vector<RunWarning> warnings;
  run.folder = "r";
  std::string text;
  try {
    checkRun(run, findMechanism(robot), warnings);
  } catch (const RunError& error) {
    return std::string("refused: ") + error.what();
  }
  for (const RunWarning& warning : warnings) {
    text += warning.line("r") + "\n";
    EXPECT_TRUE(!warning.leftOut || !run.find(warning.channel)) << warning.channel;
  }
  return text;
}
inline std::string saidOf(Run run, const std::string& robot = "xl330_pendulum") {
  return checked(run, robot);
}

}  // namespace plumbline::gap
