#include "dds/TopicReader.h"

#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <stdexcept>

#include "dds/TopicQos.h"

namespace plumbline::dds {
namespace fast = eprosima::fastdds::dds;

struct TopicReader::Parts : public fast::DataReaderListener {
  explicit Parts(Arrivals& arrivals) : arrivals(arrivals) {}

  void on_subscription_matched(fast::DataReader*, const fast::SubscriptionMatchedStatus& status) override {
    writers.store(status.current_count, std::memory_order_relaxed);
  }

  void on_data_available(fast::DataReader* from) override {
    // Shared memory and UDP have a thread each. The second to come leaves its work to the first: a lock of
    // ours, held while Fast DDS takes its own and wanted while it holds them, could stop both for ever.
    if (calls.fetch_add(1, std::memory_order_acq_rel) > 0) return;
    for (unsigned served = 0;;) {
      served = calls.load(std::memory_order_acquire);
      takeAll(*from);
      if (calls.fetch_sub(served, std::memory_order_acq_rel) == served) return;
    }
  }

  void takeAll(fast::DataReader& from) {
    fast::SampleInfo info;
    while (from.take_next_sample(&arrivals.place(), &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) arrivals.arrived();
    }
  }

  Arrivals& arrivals;
  fast::Subscriber* subscriber = nullptr;
  fast::DataReader* reader = nullptr;
  std::atomic<int> writers{0};
  std::atomic<unsigned> calls{0};  ///< that were not served yet
};

TopicReader::TopicReader(DdsParticipant& participant, const TopicName& name, Arrivals& arrivals)
    : parts_(std::make_unique<Parts>(arrivals)) {
  fast::Topic& topic = topicOf(participant.get(), name);
  fast::DataReaderQos qos;
  participant.subscriber().get_default_datareader_qos(qos);
  keepNewest(qos, name);
  parts_->subscriber = &participant.subscriber();
  parts_->reader = participant.subscriber().create_datareader(&topic, qos, parts_.get());
  if (!parts_->reader) throw std::runtime_error("DDS gives no reader of topic " + name.topic);
}

TopicReader::~TopicReader() {
  parts_->reader->set_listener(nullptr);
  parts_->subscriber->delete_datareader(parts_->reader);
}

int TopicReader::writers() const { return parts_->writers.load(std::memory_order_relaxed); }

}  // namespace plumbline::dds
