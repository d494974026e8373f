#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/blind/Planting.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

struct PlantedSetOptions {
  std::vector<std::string> from;  ///< folders of runs, or folders with such folders
  std::string robot;              ///< name in config/robots, or a file; empty: the one that the runs name
  std::size_t cases = 27;
  std::uint64_t seed = 1;
  std::string output;  ///< a new folder
  int jobs = 1;
  std::function<void(std::size_t done)> progress = {};  ///< may throw to stop; called from any thread
};

/// Least and largest change that a plant makes to the nominal replay, as a share of the robot's own gap.
constexpr double leastPlant = 0.3, mostPlant = 3;

/// A set drawn from recordings, before anything is planted: kinds, names and seeds of the cases. The first
/// one made is the reference.
std::vector<BlindCase> drawPlantedCases(std::size_t cases, std::uint64_t seed);

/// Makes a benchmark of recordings of one robot: OUTPUT/<case>/robot.json, the nominal model that lacks the
/// planted causes, and OUTPUT/<case>/<run>, the recordings; OUTPUT/answers.sealed. A fifth of the cases has
/// nothing planted, a seventh two causes, the rest one. Sizes are drawn as a share of the robot's own gap. A
/// plant that is not exact in replay, or that brings the model nearer to the robot, is drawn anew. The same
/// options give the same bytes, whatever `jobs` is. Throws std::runtime_error (one line, nothing left
/// behind).
BlindSet makePlantedSet(const PlantedSetOptions& options, std::vector<RunWarning>& warnings);

}  // namespace plumbline::gap
