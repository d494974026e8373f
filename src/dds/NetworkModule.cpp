#include "dds/NetworkModule.h"

#include <algorithm>

#include "framework/ModuleGraph.h"
#include "framework/PluginModuleBase.h"

namespace plumbline::dds {

MAKE_SPECIAL_MODULE(network, NetworkModule)

NetworkModule::NetworkModule(const std::string&)
    : hub_(*ModuleContext::current().objects.find<NetworkHub>()) {
  hub_.open(ModuleContext::current().config);
}

void NetworkModule::provide(const RepresentationLoader& loader, Representation& target) {
  received_.push_back(hub_.receive(loader, target));
}

void NetworkModule::offer(const RepresentationLoader& loader, const Representation& source) {
  offered_.emplace_back(&loader, &source);
}

void NetworkModule::planned(const ThreadPlan& plan) {
  const auto self = std::ranges::find(plan.specials, "network", &SpecialPlan::name);
  if (!self->alone) return;
  for (const auto& [loader, source] : offered_) {
    if (SentRepresentation* shown = hub_.show(*loader, *source)) shown_.push_back(shown);
  }
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
  if (any) hub_.wake();
}

}  // namespace plumbline::dds
