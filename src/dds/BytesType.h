#pragma once
#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <string>

#include "dds/Content.h"

namespace plumbline::dds {

/// A Content on the wire, in CDR: `struct Sample { unsigned long long cycle; sequence<octet> bytes; }`, or
/// the message's own CDR alone (`bare`: messages of ROS 2). A sample longer than `maxBytes`, or shorter than
/// its stated length, is dropped.
class BytesType final : public eprosima::fastdds::dds::TopicDataType {
public:
  static constexpr std::size_t maxBytes = 32u << 20;

  /// `name` is the type's on the wire: only readers and writers of one name connect.
  BytesType(const std::string& name, bool bare);

  // `data` is a Content.
  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override { return static_cast<Content*>(new BytesContent); }
  void deleteData(void* data) override { delete static_cast<Content*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }

private:
  bool bare_;
};

}  // namespace plumbline::dds
