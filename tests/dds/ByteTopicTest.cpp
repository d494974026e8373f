#include "dds/ByteTopic.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <thread>

#include "support/FarOff.h"

namespace plumbline::dds {
namespace {

using namespace std::chrono_literals;

/// Domains of the tests: nobody else's, and none twice, for tests run beside each other.
unsigned testDomain() { return 100 + static_cast<unsigned>(getpid()) % 100; }

ParticipantOptions options(const std::string& token = "") {
  ParticipantOptions result;
  result.domain = testDomain();
  result.token = token;
  return result;
}

template <typename Condition>
bool becomes(Condition condition,
             std::chrono::duration<double> limit = std::chrono::duration<double>(farOff)) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

const TopicName ball{"plumbline/test/Ball", "plumbline::Ball"};

TEST(ByteTopic, carriesTheNewestSample) {
  DdsParticipant here(options()), there(options());
  ByteWriter writer(here, ball);
  ByteReader reader(there, ball);
  Sample sample;
  EXPECT_FALSE(reader.take(sample));
  ASSERT_TRUE(becomes([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  for (std::uint64_t i = 1; i <= 20; ++i) {
    Sample sent{i, std::string(i * 50, static_cast<char>(i))};
    ASSERT_TRUE(writer.write(sent));
  }
  ASSERT_TRUE(becomes([&] { return reader.take(sample) && sample.cycle == 20; }));
  EXPECT_EQ(sample.bytes, std::string(1000, 20));
  EXPECT_FALSE(reader.take(sample)) << "a sample is taken once";
}

TEST(ByteTopic, carriesAPicture) {
  DdsParticipant here(options()), there(options());
  ByteWriter writer(here, ball);
  ByteReader reader(there, ball);
  ASSERT_TRUE(becomes([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  Sample sent{7, std::string(600'000, 'p')}, sample;
  ASSERT_TRUE(
      becomes([&] { return writer.write(sent) && becomes([&] { return reader.take(sample); }, 1s); }));
  EXPECT_EQ(sample.bytes, sent.bytes);
}

TEST(ByteTopic, isNotReadWithAnotherToken) {
  DdsParticipant here(options("red")), there(options("blue")), friendly(options("red"));
  ByteWriter writer(here, ball);
  ByteReader stranger(there, ball), reader(friendly, ball);
  ASSERT_TRUE(becomes([&] { return writer.readers() == 1; }));
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(writer.readers(), 1);
  EXPECT_EQ(stranger.writers(), 0);
}

TEST(ByteTopic, isForgottenWithItsReader) {
  DdsParticipant here(options()), there(options());
  ByteWriter writer(here, ball);
  {
    ByteReader reader(there, ball);
    ASSERT_TRUE(becomes([&] { return writer.readers() == 1; }));
  }
  EXPECT_TRUE(becomes([&] { return writer.readers() == 0; }));
  ByteReader again(there, ball);
  EXPECT_TRUE(becomes([&] { return writer.readers() == 1; }));
}

TEST(ByteTopic, ofOneNameCarriesOneType) {
  DdsParticipant here(options());
  ByteWriter writer(here, ball);
  try {
    ByteReader reader(here, {"plumbline/test/Ball", "plumbline::Other"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "topic plumbline/test/Ball carries plumbline::Ball, not plumbline::Other");
  }
}

void expectRefused(const ParticipantOptions& options, const std::string& text) {
  try {
    DdsParticipant participant(options);
    FAIL() << text;
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), text);
  }
}

TEST(DdsParticipant, saysWhatIsWrongWithItsOptions) {
  ParticipantOptions bad = options();
  bad.addresses = {"192.168.1.5"};
  expectRefused(bad, "address 192.168.1.5 shows the agent to others: set a token");
  bad.addresses = {"robot"};
  expectRefused(bad, "address \"robot\" is no IPv4 address, as 192.168.1.5 is");
  bad.addresses = {};
  expectRefused(bad, "addresses is empty; give 127.0.0.1 or one of this machine");
  bad = options();
  bad.domain = 233;
  expectRefused(bad, "domain 233 is not within 0 to 232");
  bad = options();
  bad.peers = {"10.0.0"};
  expectRefused(bad, "peer \"10.0.0\" is no IPv4 address, as 192.168.1.5 is");
}

}  // namespace
}  // namespace plumbline::dds
