#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dds/NetworkHub.h"
#include "framework/SpecialModule.h"

namespace plumbline::dds {

/// The special module `network`: a line `network` in a thread of modules.cfg shows all representations of the
/// thread to other agents; a line `network BallPos` has another agent provide BallPos. NetworkModule.yaml
/// says which.
class NetworkModule final : public SpecialModule {
public:
  /// Throws ConfigurationError.
  explicit NetworkModule(const std::string& thread);

  void provide(const RepresentationLoader& loader, Representation& target) override;
  void offer(const RepresentationLoader& loader, const Representation& source) override;
  void planned(const ThreadPlan& plan) override;
  void beginCycle() override;
  void endCycle() override;

private:
  Log log_{"network"};
  NetworkHub& hub_;
  std::vector<std::pair<const RepresentationLoader*, const Representation*>> offered_;
  std::vector<SentRepresentation*> shown_;
  std::vector<std::unique_ptr<ReceivedRepresentation>> received_;
};

}  // namespace plumbline::dds
