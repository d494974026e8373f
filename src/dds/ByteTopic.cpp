#include "dds/ByteTopic.h"

#include <array>
#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <mutex>
#include <stdexcept>

namespace plumbline::dds {
namespace fast = eprosima::fastdds::dds;
namespace {

/// The topic of that name in this participant, made when it is asked for first.
fast::Topic& topicOf(fast::DomainParticipant& participant, const TopicName& name) {
  if (fast::TypeSupport known = participant.find_type(name.type); known.empty())
    fast::TypeSupport(new BytesType(name.type, name.bare)).register_type(&participant);
  if (auto* known = participant.lookup_topicdescription(name.topic)) {
    if (known->get_type_name() != name.type)
      throw std::runtime_error("topic " + name.topic + " carries " + known->get_type_name() + ", not " +
                               name.type);
    return *static_cast<fast::Topic*>(known);
  }
  auto* topic = participant.create_topic(name.topic, name.type, fast::TOPIC_QOS_DEFAULT);
  if (!topic) throw std::runtime_error("DDS gives no topic " + name.topic);
  return *topic;
}

template <typename Qos>
void keepNewest(Qos& qos, const TopicName& name) {
  qos.reliability().kind = name.reliable ? fast::RELIABLE_RELIABILITY_QOS : fast::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = name.lasting ? fast::TRANSIENT_LOCAL_DURABILITY_QOS : fast::VOLATILE_DURABILITY_QOS;
  qos.history().kind = fast::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();  // holds samples of one size only
}

}  // namespace

struct ByteWriter::Parts : public fast::DataWriterListener {
  void on_publication_matched(fast::DataWriter*, const fast::PublicationMatchedStatus& status) override {
    readers.store(status.current_count, std::memory_order_relaxed);
  }

  fast::Publisher* publisher = nullptr;
  fast::DataWriter* writer = nullptr;
  std::atomic<int> readers{0};
};

ByteWriter::ByteWriter(Participant& participant, const TopicName& name) : parts_(std::make_unique<Parts>()) {
  fast::Topic& topic = topicOf(participant.get(), name);
  fast::DataWriterQos qos;
  participant.publisher().get_default_datawriter_qos(qos);
  keepNewest(qos, name);
  // Sent by a thread of Fast DDS where a sample is cut into pieces, which it does not do otherwise.
  qos.publish_mode().kind = fast::SYNCHRONOUS_PUBLISH_MODE;
  parts_->publisher = &participant.publisher();
  parts_->writer = participant.publisher().create_datawriter(&topic, qos, parts_.get());
  if (!parts_->writer) throw std::runtime_error("DDS gives no writer of topic " + name.topic);
}

ByteWriter::~ByteWriter() {
  parts_->writer->set_listener(nullptr);
  parts_->publisher->delete_datawriter(parts_->writer);
}

bool ByteWriter::write(Sample& sample) { return parts_->writer->write(&sample); }

int ByteWriter::readers() const { return parts_->readers.load(std::memory_order_relaxed); }

/// The newest of three samples changes hands by one exchange, as in framework/ThreadCopy.h.
struct ByteReader::Parts : public fast::DataReaderListener {
  static constexpr unsigned indexMask = 3, fresh = 4;

  void on_subscription_matched(fast::DataReader*, const fast::SubscriptionMatchedStatus& status) override {
    writers.store(status.current_count, std::memory_order_relaxed);
  }

  void on_data_available(fast::DataReader* from) override {
    const std::lock_guard lock(network);  // shared memory and UDP have a thread each
    fast::SampleInfo info;
    while (from->take_next_sample(&samples[writing], &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) writing = middle.exchange(writing | fresh, std::memory_order_acq_rel) & indexMask;
    }
  }

  fast::Subscriber* subscriber = nullptr;
  fast::DataReader* reader = nullptr;
  std::atomic<int> writers{0};
  std::array<Sample, 3> samples;
  std::mutex network;
  unsigned writing = 0, reading = 2;
  std::atomic<unsigned> middle{1};
};

ByteReader::ByteReader(Participant& participant, const TopicName& name) : parts_(std::make_unique<Parts>()) {
  fast::Topic& topic = topicOf(participant.get(), name);
  fast::DataReaderQos qos;
  participant.subscriber().get_default_datareader_qos(qos);
  keepNewest(qos, name);
  parts_->subscriber = &participant.subscriber();
  parts_->reader = participant.subscriber().create_datareader(&topic, qos, parts_.get());
  if (!parts_->reader) throw std::runtime_error("DDS gives no reader of topic " + name.topic);
}

ByteReader::~ByteReader() {
  parts_->reader->set_listener(nullptr);
  parts_->subscriber->delete_datareader(parts_->reader);
}

bool ByteReader::take(Sample& sample) {
  Parts& parts = *parts_;
  if (!(parts.middle.load(std::memory_order_relaxed) & Parts::fresh)) return false;
  parts.reading = parts.middle.exchange(parts.reading, std::memory_order_acq_rel) & Parts::indexMask;
  std::swap(sample, parts.samples[parts.reading]);
  return true;
}

int ByteReader::writers() const { return parts_->writers.load(std::memory_order_relaxed); }

}  // namespace plumbline::dds
