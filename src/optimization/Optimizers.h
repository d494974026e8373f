#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "optimization/Optimizer.h"

namespace plumbline {

/// Settings of every optimiser.
struct OptimizerOptions {
  int population = 0;  ///< candidates per generation; 0: its own default
  std::uint64_t seed = 1;
  StopCriteria stop;
  int ahead = 1;  ///< generations evaluated at a time; those that cannot have more keep to 1
};

/// An optimiser that can be chosen by name. Its own file makes it known by MAKE_OPTIMIZER.
struct OptimizerKind {
  const char* name;
  int order;  ///< its place in lists; those of the same order by name
  std::unique_ptr<Optimizer> (*make)(const SearchSpace& space, const OptimizerOptions& options);
};

/// Takes an optimiser in before main. A second one of the same name ends the program start: that is a mistake
/// of the build.
class OptimizerLoader {
public:
  explicit OptimizerLoader(const OptimizerKind& kind);
};

/// MAKE_OPTIMIZER(cmaes, {"cmaes", 10, makeCmaes}): in the optimiser's .cpp.
#define MAKE_OPTIMIZER(id, ...) \
  static const ::plumbline::OptimizerLoader id##OptimizerLoader(::plumbline::OptimizerKind __VA_ARGS__)

/// Names of the optimisers linked into the program. Complete once main runs.
const std::vector<std::string>& optimizerNames();

/// Makes one by name. Throws std::invalid_argument that names those there are, or what it makes of the space
/// and the options.
std::unique_ptr<Optimizer> makeOptimizer(std::string_view name, const SearchSpace& space,
                                         const OptimizerOptions& options = {});

}  // namespace plumbline
