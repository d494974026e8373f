#pragma once
#include <memory>

#include "framework/Platform.h"
#include "modules/simspark/AgentOptions.h"

namespace plumbline {

/// A robot of the 3D league on a SimSpark server, the league's or bin/simulator.
class SimSparkPlatform : public Platform {
public:
  void declareOptions(CommandLine& app) override;
  void check() const override;
  std::vector<std::string> configFolders(const std::string& config) const override;
  void addObjects(ModuleObjects& objects, std::function<void(const std::string&)> notify) const override;
  std::vector<NeededModule> neededModules() const override;
  std::string examples() const override;

private:
  const std::shared_ptr<AgentOptions> options_ = std::make_shared<AgentOptions>();
};

}  // namespace plumbline
