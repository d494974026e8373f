#include "dds/ByteTopic.h"

#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <stdexcept>

#include "dds/TopicQos.h"

namespace plumbline::dds {
namespace fast = eprosima::fastdds::dds;
namespace {

/// Content with the bytes of a given sample.
class SampleContent final : public Content {
public:
  explicit SampleContent(const Sample& sample) : bytes_(sample.bytes) { cycle = sample.cycle; }
  std::size_t size() const override { return bytes_.size(); }
  bool write(char* memory, std::size_t size) const override { return bytes_.copy(memory, size) == size; }
  void read(std::string_view) override {}

private:
  const std::string& bytes_;
};

}  // namespace

struct ByteWriter::Parts : public fast::DataWriterListener {
  void on_publication_matched(fast::DataWriter*, const fast::PublicationMatchedStatus& status) override {
    readers.store(status.current_count, std::memory_order_relaxed);
  }

  fast::Publisher* publisher = nullptr;
  fast::DataWriter* writer = nullptr;
  std::atomic<int> readers{0};
};

ByteWriter::ByteWriter(DdsParticipant& participant, const TopicName& name)
    : parts_(std::make_unique<Parts>()) {
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

bool ByteWriter::write(const Content& content) {
  // Fast DDS passes it to BytesType, which changes nothing.
  return parts_->writer->write(const_cast<Content*>(&content));
}

bool ByteWriter::write(const Sample& sample) {
  const SampleContent content(sample);
  return write(content);
}

int ByteWriter::readers() const { return parts_->readers.load(std::memory_order_relaxed); }

bool ByteReader::take(Sample& sample) {
  if (!newest_.take()) return false;
  sample.cycle = newest_.reading().cycle;
  std::swap(sample.bytes, newest_.reading().bytes);
  return true;
}

}  // namespace plumbline::dds
