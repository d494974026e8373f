#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gap/run/Channel.h"
#include "gap/run/Run.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

struct Place;

/// A robot's nominal model and recordings of the real robot.
struct ModelAndRuns {
  Mechanism& robot;
  std::vector<Run>& runs;
};

/// How an effect is planted in recordings of a real robot (gap/blind/Planting.h): it is taken out of the
/// nominal model, or the data is changed where that is equivalent. Only what a nominal model has can be taken
/// out of it: no frictions, play or compliance.
struct TakeOut {
  int rank = 0;        ///< from 1, the order in which effects are drawn; 0: it cannot be planted
  bool ofAll = false;  ///< also in all joints at once
  /// Whether a recorded joint or link can have it. Null: yes.
  std::function<bool(const Mechanism&, const Place&)> possible = {};
  /// Throws std::runtime_error if the model cannot lack so much.
  std::function<void(const ModelAndRuns&, const Place&, double value)> apply = {};
};

/// Changes the joint of a place, and what runs say of its servo instead of the model.
void changeServo(const ModelAndRuns& data, const Place& place,
                 const std::function<void(Mechanism::Joint&)>& model,
                 const std::function<void(ServoOverride&)>& run);
/// Divides a value that a run states.
void divide(std::optional<double>& value, double by);
/// Adds to all values of a channel, if the run has it.
void shiftChannel(Run& run, ChannelKind kind, const std::string& joint, double by);
/// The run says that commands reached a joint's servo earlier by so much [s].
void hastenCommands(Run& run, const std::string& joint, double by);
/// The servo has the linear law, without a motor's voltage.
bool hasLinearServo(const Mechanism& robot, const Place& place);

}  // namespace plumbline::gap
