#include "dds/NetworkHub.h"

#include <cstring>
#include <stdexcept>

#include "dds/Shape.h"
#include "framework/BinaryStream.h"
#include "framework/ConfigurationError.h"
#include "framework/ModuleObjects.h"
#include "framework/OutputGuard.h"

namespace plumbline::dds {

MAKE_MODULE_OBJECT(NetworkHub, NetworkHub)

namespace {

TopicName topicName(const std::string& agent, const RepresentationLoader& loader) {
  return {"plumbline/" + agent + "/" + loader.name(), "plumbline::" + loader.name(), false};
}

}  // namespace

SentRepresentation::SentRepresentation(Participant& participant, const NetworkOptions& options,
                                       const RepresentationLoader& loader, const Representation& source)
    : sent_(loader.create()),
      shape_(shapeOf(sent_->get())),
      writer_(participant, topicName(options.agent, loader)) {
  copy_.add(loader, source, sent_->get());
}

void SentRepresentation::send() {
  if (!copy_.fetch()) return;
  sample_.cycle++;
  sample_.bytes.assign(reinterpret_cast<const char*>(&shape_), sizeof shape_);
  BinaryOutStream out(sample_.bytes);
  sent_->get().stream(nullptr, &out);
  writer_.write(sample_);
}

ReceivedRepresentation::ReceivedRepresentation(Participant& participant, const NetworkOptions& options,
                                               const RepresentationLoader& loader, Representation& target)
    : loader_(loader),
      target_(target),
      from_(options.from),
      scratch_(loader.create()),
      shape_(shapeOf(scratch_->get())),
      reader_(participant, topicName(options.from, loader)) {}

bool ReceivedRepresentation::read() {
  std::uint64_t shape = 0;
  if (sample_.bytes.size() < sizeof shape) return false;
  std::memcpy(&shape, sample_.bytes.data(), sizeof shape);
  if (shape != shape_) return false;
  BinaryInStream in(std::string_view(sample_.bytes).substr(sizeof shape));
  scratch_->get().stream(&in, nullptr);
  bool numbers = false;
  return in.ok() && in.atEnd() && streamsFiniteNumbers(scratch_->get(), numbers);
}

void ReceivedRepresentation::receive(Log& log) {
  if (const int now = reader_.writers(); (now > 0) != (writers_ > 0)) {
    log << from_ << (now > 0 ? " sends " : " no longer sends ") << loader_.name();
    writers_ = now;
  }
  if (!reader_.take(sample_)) return;
  if (read())
    loader_.copy(scratch_->get(), target_);
  else
    log.warning() << "what " << from_ << " sends as " << loader_.name()
                  << " is not what this program takes for it: are both of one version?";
}

void NetworkHub::open(ConfigStore& config) {
  if (participant_) return;
  options_ = readNetworkOptions(config);
  try {
    participant_ = std::make_unique<Participant>(options_.participant);
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
