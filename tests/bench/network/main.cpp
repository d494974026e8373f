// Representations between two processes of this machine. How long they are under way, beside samples that
// Fast DDS carries by itself with the same qualities of service. What they cost the sender's cycle, and how
// soon a reader that was killed has them again. Writes build/bench/live_network.json.
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "ProcessPair.h"
#include "dds/NetworkHub.h"
#include "framework/SharedBlock.h"
#include "framework/SteadyClock.h"
#include "framework/WriteFile.h"

namespace plumbline {

/// A representation with the time at which it was made, of a size that is asked for.
REPRESENTATION(TimedBytes)
class TimedBytes : public TimedBytesBase {
public:
  double made = 0;
  SharedBlock<std::uint8_t> bytes;
  void stream(InStream* in, OutStream* out) override {
    STREAM(made);
    STREAM(bytes);
  }
};

namespace bench {
namespace {

using namespace std::chrono_literals;
namespace fast = eprosima::fastdds::dds;

dds::NetworkOptions options() {
  dds::NetworkOptions result;
  result.agent = result.from = "bench";
  result.domain = 90;
  return result;
}

/// The sender's part: what NetworkHub and its thread do with one representation.
struct Sender {
  explicit Sender(std::size_t size_) : size(size_) {
    while (!shown.wanted()) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(300ms);
  }
  /// A new picture, as raw Fast DDS gets one.
  void make(int number) { std::ranges::fill(value.bytes.renew(size), static_cast<std::uint8_t>(number)); }
  void send() {
    value.made = steadySeconds();
    shown.publish();
    thread.wake();
  }

  std::size_t size;
  dds::DdsParticipant participant{options().participant};
  TimedBytes value;
  dds::SentRepresentation shown{participant, options(), representationLoader<TimedBytes>(), value};
  dds::SendingThread thread{[this] { shown.send(); }};
};

void receive(Shared& shared) {
  dds::DdsParticipant participant(options().participant);
  TimedBytes value;
  Log log("bench");
  // Noted in the network's thread, as below; the agent's takes the newest in each of its cycles.
  dds::ReceivedRepresentation received(
      participant, options(), representationLoader<TimedBytes>(), value, [&](const Representation& arrived) {
        shared.add(steadySeconds() - static_cast<const TimedBytes&>(arrived).made);
      });
  for (;;) {
    received.receive(log);
    std::this_thread::sleep_for(20ms);
  }
}

const dds::TopicName rawTopic{"plumbline/bench/raw", "plumbline::Raw"};

void receiveRaw(Shared& shared) {
  struct Listener : fast::DataReaderListener {
    explicit Listener(Shared& shared_) : shared(shared_) {}
    void on_data_available(fast::DataReader* reader) override {
      fast::SampleInfo info;
      while (reader->take_next_sample(static_cast<dds::Content*>(&content), &info) ==
             ReturnCode_t::RETCODE_OK) {
        double made = 0;
        std::memcpy(&made, content.bytes.data(), sizeof made);
        shared.add(steadySeconds() - made);
      }
    }
    Shared& shared;
    dds::BytesContent content;
  } listener(shared);
  dds::DdsParticipant participant(options().participant);
  { const dds::ByteReader makesTheTopic(participant, rawTopic); }
  auto* topic = participant.get().lookup_topicdescription(rawTopic.topic);
  fast::DataReaderQos qos;
  participant.subscriber().get_default_datareader_qos(qos);
  qos.history().depth = 1;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
  auto* reader = participant.subscriber().create_datareader(topic, qos, &listener);
  for (;;) std::this_thread::sleep_for(1s);
  participant.subscriber().delete_datareader(reader);
}

struct Percentiles {
  double p50 = 0, p99 = 0;
};

std::vector<double> valuesOf(const Shared& shared) { return {shared.values, shared.values + shared.count}; }

Percentiles percentiles(std::vector<double> values) {
  if (values.empty()) return {-1, -1};
  std::ranges::sort(values);
  return {1e6 * values[values.size() / 2], 1e6 * values[values.size() * 99 / 100]};
}

/// What handing it over took of the sender's cycle [s]: by the clock, and of the processor.
struct Cost {
  std::vector<double> wall, cpu;
};

double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<double> measure(std::size_t size, int samples, std::chrono::microseconds pause, Cost& cost) {
  SharedMemory shared;
  const Child reader("receive", shared.descriptor());
  Sender sender(size);
  for (int i = 0; i < samples; ++i) {
    sender.make(i);
    const double before = steadySeconds(), cpuBefore = threadSeconds();
    sender.send();
    cost.cpu.push_back(threadSeconds() - cpuBefore);
    cost.wall.push_back(steadySeconds() - before);
    std::this_thread::sleep_for(pause);
  }
  std::this_thread::sleep_for(200ms);
  return valuesOf(*shared);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> measureRaw(std::size_t size, int samples, std::chrono::microseconds pause) {
  SharedMemory shared;
  const Child reader("receiveRaw", shared.descriptor());
  dds::DdsParticipant participant(options().participant);
  dds::ByteWriter writer(participant, rawTopic);
  while (writer.readers() < 1) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(300ms);
  dds::Sample sample{0, std::string(size, 7)};
  for (int i = 0; i < samples; ++i) {
    std::ranges::fill(sample.bytes, static_cast<char>(i));
    const double made = steadySeconds();
    std::memcpy(sample.bytes.data(), &made, sizeof made);
    writer.write(sample);
    std::this_thread::sleep_for(pause);
  }
  std::this_thread::sleep_for(200ms);
  return valuesOf(*shared);
}

/// How long a reader that was killed needs from its start to its first value; -1: longer than 10 s.
std::vector<double> returns(int times) {
  SharedMemory shared;
  auto reader = std::make_unique<Child>("receive", shared.descriptor());
  Sender sender(1000);
  std::vector<double> result;
  for (int i = 0; i < times; ++i) {
    reader->kill();
    const int before = shared->count = 0;
    const double start = steadySeconds();
    reader = std::make_unique<Child>("receive", shared.descriptor());
    while (shared->count == before && steadySeconds() - start < 10) {
      sender.make(i);
      sender.send();
      std::this_thread::sleep_for(5ms);
    }
    result.push_back(shared->count > before ? steadySeconds() - start : -1);
    std::fprintf(stderr, "\rreader killed and back %d of %d", i + 1, times);
  }
  std::fprintf(stderr, "\n");
  return result;
}

nlohmann::json figure(const std::string& name, double value, const char* unit) {
  return {{"name", "live.network." + name}, {"value", value}, {"unit", unit}, {"better", "lower"}};
}

/// `kills`: how often the reader is killed.
void run(int kills) {
  nlohmann::json figures = nlohmann::json::array();
  struct Size {
    const char* name;
    std::size_t bytes;
    int samples;
    std::chrono::microseconds pause;
  };
  for (const Size& size : {Size{"1kB", 1000, 3000, 1ms}, Size{"600kB", 600'000, 500, 10ms}}) {
    std::fprintf(stderr, "%s\n", size.name);
    // In turn, so that both have their share of what else this machine does.
    constexpr int rounds = 5;
    Cost cost;
    std::vector<double> rawTimes, ourTimes;
    for (int round = 0; round < rounds; ++round) {
      const auto raw = measureRaw(size.bytes, size.samples / rounds, size.pause);
      const auto ours = measure(size.bytes, size.samples / rounds, size.pause, cost);
      rawTimes.insert(rawTimes.end(), raw.begin(), raw.end());
      ourTimes.insert(ourTimes.end(), ours.begin(), ours.end());
    }
    const Percentiles raw = percentiles(rawTimes), ours = percentiles(ourTimes);
    const auto add = [&](const char* what, double value, double peer) {
      auto entry = figure(std::string(size.name) + "_" + what, value, "us");
      entry["target"] = 1.5 * peer;
      entry["peer"] = "Fast DDS alone";
      entry["peer_value"] = peer;
      figures.push_back(entry);
    };
    add("p50", ours.p50, raw.p50);
    add("p99", ours.p99, raw.p99);
    // The mean by the clock holds what other processes took meanwhile; the other two do not.
    const auto addCost = [&](const char* what, double value) {
      auto entry = figure(std::string(size.name) + "_of_the_sender's_cycle" + what, value, "us");
      entry["target"] = 20;
      figures.push_back(entry);
    };
    addCost("", 1e6 * mean(cost.wall));
    addCost("_p50", percentiles(cost.wall).p50);
    addCost("_cpu", 1e6 * mean(cost.cpu));
  }
  std::vector<double> back = returns(kills);
  const auto late = std::ranges::count_if(back, [](double t) { return t < 0 || t > 2; });
  auto entry = figure("killed_readers_of_" + std::to_string(kills) + "_not_back_in_2_s",
                      static_cast<double>(late), "");
  entry["target"] = 0;
  figures.push_back(entry);
  figures.push_back(figure("killed_reader_back_at_most", *std::ranges::max_element(back), "s"));
  std::filesystem::create_directories("build/bench");
  writeFile("build/bench/live_network.json", figures.dump(1) + "\n");
  for (const auto& each : figures)
    std::printf("%-50s %10.2f %s\n", each["name"].get<std::string>().c_str(), each["value"].get<double>(),
                each["unit"].get<std::string>().c_str());
}

}  // namespace
}  // namespace bench
}  // namespace plumbline

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  if (argc == 3) {
    Shared& shared = *static_cast<Shared*>(SharedMemory::map(std::stoi(argv[2])));
    if (std::string(argv[1]) == "receive") receive(shared);
    receiveRaw(shared);
  }
  run(argc == 2 ? std::stoi(argv[1]) : 100);
  return 0;
}
