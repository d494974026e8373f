#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/Module.h"
#include "optimization/farm/ParameterSource.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/optimization/OptimizationResult.h"
#include "representations/optimization/OptimizationTrial.h"
#include "trials/TaskOptions.h"

namespace plumbline {

MODULE(OptimizationClient)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  USES(OptimizationResult)
  PROVIDES(OptimizationTrial)
  PARAMETER(std::string, host, "127.0.0.1", "", Range(),
            "where bin/optserver runs with a study of the task kick or standUp; empty: the optimiser is in "
            "the agent")
  PARAMETER(int, port, 3400, "", Range(1, 65535), "its port")
  PARAMETER(std::string, token, "", "", Range(), "the server's token, if it needs one")
  PARAMETER(double, patience, 30, "s", Range(0, 1e6),
            "waits so long for a server that is not there, or went away")
  PARAMETER(std::string, motion, "kickRight", "", Range(), "optimiser in the agent: the kick to begin with")
  PARAMETER(std::string, optimizer, "cmaes", "", Range(), "the same: one of bin/optserver's")
  PARAMETER(int, population, 12, "", Range(4, 1000), "the same: candidates of a generation")
  PARAMETER(int, runs, 2, "", Range(1, 1000), "the same: tries of each")
  PARAMETER(int, generations, 100, "", Range(1, 1000000), "the same: then it is over")
  PARAMETER(int, seed, 1, "", Range(0, 1000000000), "the same")
  PARAMETER(std::string, found, "found.kick.yaml", "", Range(),
            "the same: file for the motion that was found")
END_MODULE

/// Gets a motion to try from an optimiser and sends it the costs of the tries (Seekircher 2015, A.6.7). The
/// optimiser is reached by TCP or runs in the agent; the interface is the same. Ends the agent when the
/// search is over. A try during which the server goes away is lost; the server gives it to another worker.
class OptimizationClient : public OptimizationClientBase {
public:
  OptimizationClient();
  ~OptimizationClient() override;
  void update(OptimizationTrial* theOptimizationTrial) override;

private:
  struct InAgent;
  void want(const std::string& task, const TaskOptions& options);
  void connect();
  void begin();
  /// False: there is no optimiser yet.
  bool reach();
  void drop();
  void lose(const std::string& why);
  void takeResult();
  void end();

  std::unique_ptr<InAgent> inAgent_;
  std::unique_ptr<farm::ParameterSource> source_;
  double asked_ = -1e9;       ///< when a server was last looked for [s]
  double lost_ = -1;          ///< since when there is none [s]; below 0: there is one
  OptimizationTrial wanted_;  ///< as of the search: all but the try's own
  std::optional<Trial> trial_;
  std::vector<double> costs_;
  std::map<std::string, double> figures_;  ///< sums over the tries
  std::int64_t tries_ = 0;
  bool ended_ = false;
};

}  // namespace plumbline
