#include "dds/TopicQos.h"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <stdexcept>

#include "dds/BytesType.h"

namespace plumbline::dds {
namespace fast = eprosima::fastdds::dds;

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

}  // namespace plumbline::dds
