#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "dds/ByteTopic.h"
#include "framework/BinaryStream.h"
#include "framework/ConfigurationError.h"
#include "framework/Controller.h"
#include "framework/LogBuffer.h"
#include "framework/Module.h"
#include "support/FarOff.h"

namespace plumbline {

REPRESENTATION(ShownBall)
class ShownBall : public ShownBallBase {
public:
  double x = 0;
  std::vector<int> seen;
  void stream(InStream* in, OutStream* out) override {
    STREAM(x);
    STREAM(seen);
  }
};

MODULE(ShownBallSource)
  PROVIDES(ShownBall)
END_MODULE
class ShownBallSource : public ShownBallSourceBase {
public:
  void update(ShownBall* theShownBall) override {
    theShownBall->x += 1;
    theShownBall->seen.assign(3, static_cast<int>(theShownBall->x));
  }
};
MAKE_MODULE(ShownBallSource)

MODULE(ShownBallReader)
  REQUIRES(ShownBall)
END_MODULE
class ShownBallReader : public ShownBallReaderBase {};
MAKE_MODULE(ShownBallReader)

namespace {

using namespace std::chrono_literals;

unsigned networkDomain() { return 100 + static_cast<unsigned>(getpid()) % 100; }

/// An agent whose config folder holds a NetworkModule.yaml of this text, domain added.
class Agent {
public:
  Agent(const std::string& name, const std::string& modules, const std::string& config)
      : folder(std::filesystem::path(testing::TempDir()) / ("network-" + name + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "NetworkModule.yaml") << config << "domain: " << networkDomain() << '\n';
    controller = std::make_unique<Controller>(ControllerOptions{"modules.cfg", {folder.string()}}, modules);
    controller->init();
  }
  ~Agent() {
    controller.reset();
    std::filesystem::remove_all(folder);
  }

  std::filesystem::path folder;
  std::unique_ptr<Controller> controller;
};

std::string configOf(const std::string& agent, const std::string& from) {
  return "agent: " + agent + "\nfrom: " + from + "\naddresses: [127.0.0.1]\npeers: []\ntoken: \"\"\n";
}

const char* const source = "ShownBallSource ShownBall\nnetwork\n";
const char* const reader = "network ShownBall\nShownBallReader\n";

double ballOf(const Agent& agent) { return agent.controller->find<ShownBall>()->x; }

/// Runs both until the second has a value of the first that is greater than `above`.
bool arrives(Agent& from, Agent& to, double above = 0) {
  return comesTrue([&] {
    from.controller->runCycles(1);
    to.controller->runCycles(1);
    return ballOf(to) > above;
  });
}

TEST(NetworkModule, providesWhatAnotherAgentShows) {
  Agent red("red", source, configOf("red", "\"\"")), blue("blue", reader, configOf("blue", "red"));
  ASSERT_TRUE(arrives(red, blue));
  ASSERT_TRUE(arrives(red, blue, ballOf(red)));
  const auto* ball = blue.controller->find<ShownBall>();
  EXPECT_EQ(ball->seen, std::vector<int>(3, static_cast<int>(ball->x)));
  EXPECT_LE(ball->x, ballOf(red));
}

TEST(NetworkModule, findsAnAgentThatCameBack) {
  Agent blue("blue", reader, configOf("blue", "red"));
  {
    Agent red("red", source, configOf("red", "\"\""));
    ASSERT_TRUE(arrives(red, blue));
  }
  std::this_thread::sleep_for(50ms);
  blue.controller->runCycles(1);
  const double last = ballOf(blue);
  blue.controller->runCycles(3);
  EXPECT_EQ(ballOf(blue), last) << "the newest value stays";
  Agent again("again", source, configOf("red", "\"\""));
  again.controller->runCycles(static_cast<std::size_t>(last) + 10);
  EXPECT_TRUE(arrives(again, blue, last));
}

/// What a program of another version, a broken or a wicked one may send.
TEST(NetworkModule, takesNothingThatItCannotRead) {
  Agent red("red", source, configOf("red", "\"\"")), blue("blue", reader, configOf("blue", "red"));
  ASSERT_TRUE(arrives(red, blue));
  // The bytes of a good sample, of which the first eight are the shape.
  dds::ParticipantOptions options;
  options.domain = networkDomain();
  dds::DdsParticipant participant(options);
  const dds::TopicName topic{"plumbline/red/ShownBall", "plumbline::ShownBall"};
  dds::ByteReader tap(participant, topic);
  dds::Sample good;
  ASSERT_TRUE(comesTrue([&] {
    red.controller->runCycles(1);
    tap.take(good);
    return !good.bytes.empty();
  }));
  ASSERT_GT(good.bytes.size(), 8u);
  std::this_thread::sleep_for(50ms);
  blue.controller->runCycles(1);
  const double before = ballOf(blue);

  dds::ByteWriter writer(participant, topic);
  while (writer.readers() == 0) std::this_thread::sleep_for(1ms);
  const std::string head = good.bytes.substr(0, 8);
  ShownBall infinite, fine;
  infinite.x = std::numeric_limits<double>::infinity();
  fine.x = 1e6;
  const auto bytesOf = [](ShownBall& ball) {
    std::string bytes;
    BinaryOutStream out(bytes);
    ball.stream(nullptr, &out);
    return bytes;
  };
  const std::string whole = bytesOf(fine);
  std::string said;
  LogBuffer::instance().setListener(
      [&](std::string_view, std::string_view message) { said += std::string(message) + '\n'; });
  for (const std::string& bytes :
       {std::string(), std::string("\1\2\3"), head, head + whole.substr(0, whole.size() - 1),
        head + whole + "x", std::string(8, 'x') + whole, head + bytesOf(infinite),
        head + std::string(5000, '\xff')}) {
    dds::Sample sample{1, bytes};
    ASSERT_TRUE(writer.write(sample));
    std::this_thread::sleep_for(10ms);
    blue.controller->runCycles(1);
    EXPECT_EQ(ballOf(blue), before) << bytes.size() << " bytes";
  }
  // The infinite one once more: the log says what is wrong with it.
  const std::string wanted = "what red sends as ShownBall is left out: x: must be finite, not inf";
  EXPECT_TRUE(comesTrue([&] {
    writer.write(dds::Sample{1, head + bytesOf(infinite)});
    blue.controller->runCycles(1);
    return said.find(wanted) != std::string::npos;
  })) << said;
  LogBuffer::instance().setListener(nullptr);
  dds::Sample sample{1, head + whole};
  ASSERT_TRUE(writer.write(sample));
  EXPECT_TRUE(comesTrue([&] {
    blue.controller->runCycles(1);
    return ballOf(blue) == 1e6;
  })) << "a good one after bad ones is taken";
}

void expectRefused(const std::string& modules, const std::string& config, const std::string& text) {
  try {
    Agent agent("bad", modules, config);
    FAIL() << text;
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(NetworkModule, saysWhatIsWrongWithItsConfiguration) {
  expectRefused(source, configOf("r d", "\"\""),
                "agent is no name of an agent: up to 64 letters, digits, _ and -");
  expectRefused(source, configOf("\"\"", "\"\""),
                "agent is empty; give the name under which others find this agent");
  expectRefused(reader, configOf("blue", "\"\""),
                "modules.cfg wants ShownBall from the network; say in NetworkModule.yaml from: which agent");
  expectRefused(source, "agent: red\nfrom: \"\"\naddresses: [0.0.0.0]\npeers: []\ntoken: \"\"\n",
                "NetworkModule: address 0.0.0.0 shows the agent to others: set a token");
}

}  // namespace
}  // namespace plumbline
