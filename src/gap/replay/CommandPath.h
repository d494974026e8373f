#pragma once
#include <cstdint>
#include <vector>

#include "gap/replay/Plant.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// The commands of one joint's servo over time: the trial's commands at the times at which they arrive,
/// without lost cycles. A servo's filter of first order smooths them, then its profile if it has a speed or
/// acceleration limit. Query in ascending time.
class CommandPath {
public:
  /// lost: per cycle, whether its command was lost; null: unknown. Then a share of the plant's commands
  /// (shareLost) is lost by chance, and these are the mean commands: each takes 1 - shareLost of the way.
  CommandPath(const JointPlant& plant, const Trial& trial, std::size_t joint,
              const std::vector<std::uint8_t>* lost, double shareLost = 0);

  /// Mean command over (from, to] [rad]: a change within a step counts by its share, to second order in the
  /// step.
  double over(double from, double to);
  /// The command that the servo follows at the end of the last queried interval [rad].
  double atEnd() const { return end_; }
  /// Changes which cycles' commands are lost from now on; null: unknown.
  void lose(const std::vector<std::uint8_t>* lostCycles) { lost_ = lostCycles; }
  double stiffness() const { return stiff_; }        ///< at the end of the last queried interval
  double voltage() const { return volts_; }          ///< measured supply then; 0: not measured
  double speedSent() const { return sentSpeed_; }    ///< sent with the position, then [rad/s]
  double torqueSent() const { return sentTorque_; }  ///< likewise [N m]

private:
  double target(double from, double to);
  /// What acts after a cycle's command [rad].
  double after(std::size_t cycle) const;
  double line(double from, double to);
  double filtered(double value, double slope, double duration);
  void take(std::size_t cycle);
  double profileOver(double from, double to);

  const std::vector<double>*command_ = nullptr, *stiffnesses_ = nullptr, *voltages_ = nullptr;
  const std::vector<double>*speeds_ = nullptr, *torques_ = nullptr;
  const std::vector<double>& time_;
  const std::vector<std::uint8_t>* lost_;
  bool losable_ = true;  ///< it gets commands
  double shareLost_ = 0, shift_ = 0, lag_ = 0, acceleration_ = 0, fastest_ = 0;
  std::size_t next_ = 0;
  double current_ = 0, stiff_ = 1, volts_ = 0, sentSpeed_ = 0, sentTorque_ = 0;
  bool straight_ = false;  ///< linear from command to command
  double currentAt_ = 0;   ///< when the current one was sent [s]
  double behindLag_ = 0;   ///< what the filter gives
  double profile_ = 0, speed_ = 0, end_ = 0;
};

}  // namespace plumbline::gap
