#pragma once
#include <memory>
#include <string>
#include <vector>

#include "dds/NetworkHub.h"
#include "framework/SpecialModule.h"

namespace plumbline::dds {

/// The special module `network`: a line `network` in a thread of modules.cfg shows all representations of the
/// thread to other agents; a line `network BallPos` has another agent provide BallPos. NetworkModule.yaml
/// says which.
class NetworkModule final : public SpecialModule {
public:
  explicit NetworkModule(const std::string& thread) : log_("network"), thread_(thread) {}

  void configure(const SpecialPlan& plan, ConfigStore& config, ModuleObjects& objects) override;
  void provide(const RepresentationLoader& loader, Representation& target) override;
  void offer(const RepresentationLoader& loader, const Representation& source) override;
  void beginCycle() override;
  void endCycle() override;

private:
  Log log_;
  std::string thread_;
  NetworkHub* hub_ = nullptr;
  bool shows_ = false;
  std::vector<SentRepresentation*> shown_;
  std::vector<std::unique_ptr<ReceivedRepresentation>> received_;
};

}  // namespace plumbline::dds
