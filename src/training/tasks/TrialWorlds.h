#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "simspark/LeagueRobots.h"
#include "training/MotionTrial.h"
#include "training/TaskOptions.h"

namespace plumbline::training {

/// The robot of a trial and what its world is.
struct RobotOptions {
  PARAMETERS(RobotOptions)
  PARAMETER(int, type, 0, "", Range(0, maxSimsparkTypes - 1), "the league's type of robot")
  PARAMETER(std::string, engine, "ode", "", Range(),
            "physics engine: ode (the league's), bullet or another one that there is")
  PARAMETER(std::string, effects, "", "", Range(),
            "file of effects that the worlds have, or an answer of bin/gap diagnose "
            "(doc/reference/effects-file.md)")
};

/// Options of all tasks that play motions.
struct WorldOptions {
  PARAMETERS(WorldOptions)
  PARAMETER_GROUP(RobotOptions, robot, "robot and what its worlds are")
  PARAMETER(int, draws, 0, "", Range(0, 64),
            "number of worlds, each with other effects of the file; 0: one with all of them")
  PARAMETER(int, firstDraw, 0, "", Range(0, 1e6),
            "draw to begin with; 1 and later ones are worlds that a search without this option has not seen")
};

/// Throws ConfigurationError if there is no robot of that type.
int checkedType(int type);

/// The worlds that the runs of a task take place in. Without draws there is one world, which has all the
/// effects. With N draws there are N, and a run's seed says which. The first is the nominal one; each other
/// one has each effect of the file with a chance of one half, always the same ones. What is good in all of
/// them leans on none of them (domain randomisation: Tobin et al. 2017).
class TrialWorlds {
public:
  /// Throws ConfigurationError for options that cannot be used.
  explicit TrialWorlds(const WorldOptions& options);

  /// Of the run with this seed.
  MotionTrial& of(std::uint64_t seed) { return *all_[static_cast<std::size_t>(seed % all_.size())]; }
  const MotionTrial& first() const { return *all_[0]; }
  std::size_t count() const { return all_.size(); }
  const std::string& engine() const { return engine_; }

private:
  std::string engine_;
  std::vector<std::unique_ptr<MotionTrial>> all_;
};

}  // namespace plumbline::training
