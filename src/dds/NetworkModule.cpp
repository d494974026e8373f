#include "dds/NetworkModule.h"

#include "framework/ModuleGraph.h"
#include "framework/ModuleObjects.h"

namespace plumbline::dds {

MAKE_SPECIAL_MODULE(network, NetworkModule)

void NetworkModule::configure(const SpecialPlan& plan, ConfigStore& config, ModuleObjects& objects) {
  shows_ = plan.alone;
  hub_ = objects.find<NetworkHub>();
  hub_->open(config);
}

void NetworkModule::provide(const RepresentationLoader& loader, Representation& target) {
  received_.push_back(hub_->receive(loader, target));
}

void NetworkModule::offer(const RepresentationLoader& loader, const Representation& source) {
  if (!shows_) return;
  if (SentRepresentation* shown = hub_->show(loader, source)) shown_.push_back(shown);
}

void NetworkModule::beginCycle() {
  for (const auto& representation : received_) representation->receive(log_);
}

void NetworkModule::endCycle() {
  bool any = false;
  for (SentRepresentation* representation : shown_) {
    if (!representation->wanted()) continue;
    representation->publish();
    any = true;
  }
  if (any) hub_->wake();
}

}  // namespace plumbline::dds
