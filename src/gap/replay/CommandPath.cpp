#include "gap/replay/CommandPath.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double profileStep = 0.00025;  // [s]: servos run their profiles far faster than a replay's steps

double firstFinite(const std::vector<double>& values) {
  for (const double value : values)
    if (std::isfinite(value)) return value;
  return 0;
}

}  // namespace

CommandPath::CommandPath(const JointPlant& plant, const Trial& trial, std::size_t joint,
                         const std::vector<std::uint8_t>* lostCycles, double shareLost)
    : command_(&trial.targets(joint)),
      time_(trial.time),
      lost_(lostCycles),
      losable_(!trial.command[joint].empty()),
      shareLost_(losable_ ? shareLost : 0),
      shift_(trial.commandAt[joint] + plant.commandDelay),
      lag_(plant.commandLag),
      acceleration_(plant.accelerationLimit),
      fastest_(plant.profileSpeed) {
  if (!trial.stiffness[joint].empty()) stiffnesses_ = &trial.stiffness[joint];
  if (!trial.voltage[joint].empty()) voltages_ = &trial.voltage[joint];
  const auto sent = [&](const auto& of) {
    return joint < of.size() && !of[joint].empty() ? &of[joint] : nullptr;
  };
  speeds_ = sent(trial.commandSpeed);
  torques_ = sent(trial.commandTorque);
  straight_ = trial.linearCommands;
  currentAt_ = time_.empty() ? 0 : time_.front() + shift_;
  current_ = behindLag_ = profile_ = end_ = firstFinite(*command_);
  if (stiffnesses_) stiff_ = firstFinite(*stiffnesses_);
  if (voltages_) volts_ = firstFinite(*voltages_);
}

/// What is sent with a cycle's command.
void CommandPath::take(std::size_t cycle) {
  const auto read = [cycle](const std::vector<double>* values, double& into) {
    if (values && std::isfinite((*values)[cycle])) into = (*values)[cycle];
  };
  read(stiffnesses_, stiff_);
  read(voltages_, volts_);
  read(speeds_, sentSpeed_);
  read(torques_, sentTorque_);
}

double CommandPath::after(std::size_t cycle) const {
  const double sent = (*command_)[cycle];
  return lost_ || shareLost_ <= 0 ? sent : sent + shareLost_ * (current_ - sent);
}

/// Integral [rad s] of what the filter gives while its input goes on from a value [rad] at a slope [rad/s],
/// exactly.
double CommandPath::filtered(double value, double slope, double duration) {
  // Behind a ramp it ends up by what the ramp makes in one time constant.
  const double follows = value - slope * lag_, away = behindLag_ - follows;
  const double fades = std::expm1(-duration / lag_);
  behindLag_ = follows + slope * duration + away * (1 + fades);
  return (follows + slope * duration / 2) * duration - away * lag_ * fades;
}

/// Mean of the straight lines from each command that came to the next.
double CommandPath::line(double from, double to) {
  const auto came = [&](std::size_t cycle) {
    return !(losable_ && lost_ && (*lost_)[cycle]) && cycle < command_->size() &&
           std::isfinite((*command_)[cycle]);
  };
  double sum = 0, since = from;
  while (true) {
    std::size_t ahead = next_;
    while (ahead < time_.size() && !came(ahead)) ++ahead;
    const bool last = ahead == time_.size();
    const double reached = last ? to : std::min(to, time_[ahead] + shift_);
    const double slope = last || time_[ahead] + shift_ <= currentAt_
                             ? 0
                             : (after(ahead) - current_) / (time_[ahead] + shift_ - currentAt_);
    end_ = current_ + slope * (reached - currentAt_);
    if (reached > since) {
      sum += lag_ > 0 ? filtered(current_ + slope * (since - currentAt_), slope, reached - since)
                      : (current_ + slope * ((since + reached) / 2 - currentAt_)) * (reached - since);
      since = reached;
    }
    if (last || time_[ahead] + shift_ >= to) break;
    current_ = after(ahead);
    currentAt_ = time_[ahead] + shift_;
    take(ahead);
    next_ = ahead + 1;
  }
  if (lag_ > 0) end_ = behindLag_;
  return to > from ? sum / (to - from) : lag_ > 0 ? behindLag_ : current_;
}

double CommandPath::target(double from, double to) {
  if (straight_) return line(from, to);
  const auto held = [this](double duration) {
    return lag_ > 0 ? filtered(current_, 0, duration) : current_ * duration;
  };
  double sum = 0, since = from;
  while (next_ < time_.size() && time_[next_] + shift_ < to) {
    const double when = std::max(time_[next_] + shift_, from);
    if (!(losable_ && lost_ && (*lost_)[next_])) {
      if (next_ < command_->size() && std::isfinite((*command_)[next_])) {
        sum += held(when - since);
        since = when;
        current_ = after(next_);
      }
      take(next_);
    }
    ++next_;
  }
  const double mean = to > since ? (sum + held(to - since)) / (to - from) : lag_ > 0 ? behindLag_ : current_;
  end_ = lag_ > 0 ? behindLag_ : current_;
  return mean;
}

double CommandPath::profileOver(double from, double to) {
  // The fastest approach that still can stop at the target (time-optimal, bang-bang).
  const double h = to - from, before = profile_, error = target(from, to) - profile_;
  if (acceleration_ <= 0) {
    const double way = std::clamp(error, -fastest_ * h, fastest_ * h);
    profile_ += way;
    // It moves for a part of the step, then it is there.
    return profile_ - way / 2 * std::abs(way) / (fastest_ * h);
  }
  double best = std::copysign(std::sqrt(2 * acceleration_ * std::abs(error)), error);
  if (fastest_ > 0) best = std::clamp(best, -fastest_, fastest_);
  const double limited = std::clamp(best, speed_ - acceleration_ * h, speed_ + acceleration_ * h);
  speed_ =
      std::abs(limited * h) > std::abs(error) && limited * error > 0 && std::abs(limited) <= acceleration_ * h
          ? error / h
          : limited;
  profile_ += speed_ * h;
  return (before + profile_) / 2;
}

double CommandPath::over(double from, double to) {
  if (acceleration_ <= 0 && fastest_ <= 0) return target(from, to);
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / profileStep - 1e-9)));
  const double h = (to - from) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += profileOver(from + i * h, i + 1 == steps ? to : from + (i + 1) * h);
  end_ = profile_;
  return sum / steps;
}

}  // namespace plumbline::gap
