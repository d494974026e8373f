#include "dds/NetworkHub.h"

#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/ModuleObjects.h"

namespace plumbline::dds {

MAKE_MODULE_OBJECT(NetworkHub, NetworkHub)

namespace {

TopicName topicName(const std::string& agent, const RepresentationLoader& loader) {
  return {"plumbline/" + agent + "/" + loader.name(), "plumbline::" + loader.name(), false};
}

}  // namespace

SentRepresentation::SentRepresentation(DdsParticipant& participant, const NetworkOptions& options,
                                       const RepresentationLoader& loader, const Representation& source)
    : sent_(loader), writer_(participant, topicName(options.agent, loader)) {
  copy_.add(loader, source, sent_.value());
}

void SentRepresentation::send() {
  if (!copy_.fetch()) return;
  sent_.cycle++;
  writer_.write(sent_);
}

ReceivedRepresentation::ReceivedRepresentation(DdsParticipant& participant, const NetworkOptions& options,
                                               const RepresentationLoader& loader, Representation& target,
                                               std::function<void(const Representation&)> whenArrived)
    : loader_(loader),
      target_(target),
      from_(options.from),
      whenArrived_(std::move(whenArrived)),
      newest_(loader),
      reader_(participant, topicName(options.from, loader), *this) {}

void ReceivedRepresentation::arrived() noexcept {
  RepresentationContent& content = newest_.writing();
  if (content.problem().empty()) {
    if (whenArrived_) whenArrived_(content.value());
    return newest_.publish();
  }
  const std::lock_guard lock(mutex_);
  problem_ = content.problem();
  wrong_.store(true, std::memory_order_release);
}

void ReceivedRepresentation::receive(Log& log) {
  if (const int now = reader_.writers(); (now > 0) != (writers_ > 0)) {
    log << from_ << (now > 0 ? " sends " : " no longer sends ") << loader_.name();
    writers_ = now;
  }
  if (wrong_.load(std::memory_order_relaxed) && wrong_.exchange(false, std::memory_order_acquire)) {
    const std::unique_lock lock(mutex_, std::try_to_lock);  // no cycle waits for the network
    log.warning() << "what " << from_ << " sends as " << loader_.name()
                  << " is left out: " << (lock ? problem_ : "more than one is wrong");
  }
  if (newest_.take()) loader_.copy(newest_.reading().value(), target_);
}

void NetworkHub::open(ConfigStore& config) {
  if (participant_) return;
  options_ = readNetworkOptions(config);
  try {
    participant_ = std::make_unique<DdsParticipant>(options_.participant());
  } catch (const std::runtime_error& error) {
    throw ConfigurationError("NetworkModule: " + std::string(error.what()));
  }
}

SentRepresentation* NetworkHub::show(const RepresentationLoader& loader, const Representation& source) {
  auto& sent = sent_[loader.name()];
  if (sent) return nullptr;
  sent = std::make_unique<SentRepresentation>(*participant_, options_, loader, source);
  return sent.get();
}

std::unique_ptr<ReceivedRepresentation> NetworkHub::receive(const RepresentationLoader& loader,
                                                            Representation& target) {
  if (options_.from.empty())
    throw ConfigurationError("modules.cfg wants " + loader.name() +
                             " from the network; say in NetworkModule.yaml from: which agent");
  return std::make_unique<ReceivedRepresentation>(*participant_, options_, loader, target);
}

void NetworkHub::send() {
  for (const auto& [name, representation] : sent_) representation->send();
}

}  // namespace plumbline::dds
