#pragma once
#include <fastdds/dds/topic/Topic.hpp>

#include "dds/TopicReader.h"

namespace plumbline::dds {

/// The topic of that name in this participant, made when it is asked for first. Throws std::runtime_error.
eprosima::fastdds::dds::Topic& topicOf(eprosima::fastdds::dds::DomainParticipant& participant,
                                       const TopicName& name);

/// The qualities of service of readers and writers: the newest sample alone is kept.
template <typename Qos>
void keepNewest(Qos& qos, const TopicName& name) {
  namespace fast = eprosima::fastdds::dds;
  qos.reliability().kind = name.reliable ? fast::RELIABLE_RELIABILITY_QOS : fast::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = name.lasting ? fast::TRANSIENT_LOCAL_DURABILITY_QOS : fast::VOLATILE_DURABILITY_QOS;
  qos.history().kind = fast::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();  // holds samples of one size only
}

}  // namespace plumbline::dds
