#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "training/MotionTrial.h"
#include "trials/WorldOptions.h"

namespace plumbline::training {

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
