#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "training/MotionTrial.h"
#include "training/SearchTask.h"

namespace plumbline::training {

/// The worlds that the runs of a task take place in, and the options that say so: engine (of the physics,
/// "ode"), effects (a file, doc/reference/effects-file.md), draws (0), firstDraw (0). Without draws there is
/// one world, which has all the effects. With N draws there are N, and a run's seed says which. The first is
/// the nominal one; each other one has each effect of the file with a chance of one half, always the same
/// ones. firstDraw begins with a later draw than the nominal one, for worlds that no search has seen. What is
/// good in all of them leans on none of them (domain randomisation: Tobin et al. 2017).
class TrialWorlds {
public:
  static const std::vector<std::string> options;  ///< their names

  /// Throws ConfigurationError for options that cannot be used.
  TrialWorlds(const TaskOptions& options, int type);

  /// Of the run with this seed.
  motion::MotionTrial& of(std::uint64_t seed) { return *all_[static_cast<std::size_t>(seed % all_.size())]; }
  const motion::MotionTrial& first() const { return *all_[0]; }
  std::size_t count() const { return all_.size(); }
  const std::string& engine() const { return engine_; }

private:
  std::string engine_;
  std::vector<std::unique_ptr<motion::MotionTrial>> all_;
};

/// The robot type (option type) of a task of motions that takes `own` options besides it and those of
/// TrialWorlds; throws ConfigurationError for any other.
int robotTypeOf(const TaskOptions& options, std::vector<std::string> own);

}  // namespace plumbline::training
