#include "framework/Log.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <iomanip>
#include <memory>
#include <thread>

#include "framework/LogBuffer.h"
#include "framework/TestModules.h"

namespace plumbline {

MODULE(Talker)
END_MODULE
class Talker : public TalkerBase {
public:
  void execute() override { log << "hello"; }
};
MAKE_MODULE(Talker)

namespace {

/// Collects what is logged as `source|message`.
class LogTest : public testing::Test {
protected:
  LogTest() {
    LogBuffer::instance().setListener([this](std::string_view source, std::string_view message) {
      lines.push_back(std::string(source) + "|" + std::string(message));
    });
  }
  ~LogTest() override { LogBuffer::instance().setListener(nullptr); }
  std::vector<std::string> lines;
};

TEST_F(LogTest, aStatementIsAMessage) {
  Log log("Me");
  log << "ball at " << 1.5 << " m, " << true;
  log << Eigen::RowVector2d(1, 2) << "\n";
  log << "with end" << std::endl;
  log.warning() << "no ball for " << 3 << " s";
  log.error() << "broken";
  EXPECT_EQ(lines, (std::vector<std::string>{"Me|ball at 1.5 m, 1", "Me|1 2", "Me|with end",
                                             "Me|warning: no ball for 3 s", "Me|error: broken"}));
}

TEST_F(LogTest, formatsOfOneMessageDoNotReachTheNext) {
  Log log("Me");
  log << std::hex << std::setprecision(2) << 255 << " " << 3.14159;
  log << 255 << " " << 3.14159;
  EXPECT_EQ(lines, (std::vector<std::string>{"Me|ff 3.1", "Me|255 3.14159"}));
}

TEST_F(LogTest, messagesMayBeLoggedWhileOneIsUnderWay) {
  Log log("Me");
  const auto inner = [&] {
    log << "inner";
    return 5;
  };
  log << "outer " << inner() << " end";
  EXPECT_EQ(lines, (std::vector<std::string>{"Me|inner", "Me|outer 5 end"}));
}

TEST_F(LogTest, modulesLogUnderTheirName) {
  Controller controller = makeController("Talker\n");
  controller.runCycles(2);
  EXPECT_EQ(lines, (std::vector<std::string>{"Talker|hello", "Talker|hello"}));
}

TEST_F(LogTest, verbosePrintsStepsAndMessages) {
  testing::internal::CaptureStdout();
  LogBuffer::instance().setVerbose(true);
  Controller controller = makeController("Talker\nAlphaSource Alpha\n");
  controller.runCycles(1);
  LogBuffer::instance().setVerbose(false);
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "[default] Talker:execute\n"
            "[Talker] hello\n"
            "[default] AlphaSource:execute\n"
            "[default] AlphaSource:updateAlpha\n");
}

TEST(CrashRecordTest, keepsTheLastMessages) {
  const auto record = std::make_unique<CrashRecord>();
  EXPECT_EQ(record->lastMessages(), "");
  record->add("A", "first");
  record->add("B", "second");
  EXPECT_EQ(record->lastMessages(), "[A] first\n[B] second\n");
  for (std::size_t i = 0; i < CrashRecord::messages; ++i) record->add("C", std::to_string(i));
  const std::string text = record->lastMessages();
  EXPECT_EQ(text.substr(0, 12), "[C] 0\n[C] 1\n");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<long>(CrashRecord::messages));
}

TEST(CrashRecordTest, cutsLongMessages) {
  const auto record = std::make_unique<CrashRecord>();
  record->add("A", std::string(2000, 'x'));
  EXPECT_EQ(record->lastMessages(), "[A] " + std::string(CrashRecord::messageLength - 5, 'x') + "\n");
}

TEST(CrashRecordTest, manyThreadsMayAdd) {
  const auto record = std::make_unique<CrashRecord>();
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 100; ++i) record->add("T" + std::to_string(t), "message");
    });
  }
  for (auto& thread : threads) thread.join();
  const std::string text = record->lastMessages();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 300);
}

TEST(CrashRecordTest, knowsWhereThreadsAre) {
  const auto record = std::make_unique<CrashRecord>();
  const int first = record->addThread("cognition");
  const int second = record->addThread("motion");
  record->setStep(first, record->addStep("BallLocator:execute"));
  EXPECT_EQ(record->whereabouts(), "[cognition] BallLocator:execute\n[motion] between two steps\n");
  record->signalThread = second;
  EXPECT_EQ(record->whereabouts(),
            "[cognition] BallLocator:execute\n[motion] between two steps <- the signal struck here\n");
  record->removeThread(first);
  EXPECT_EQ(record->addThread("other"), first);
  EXPECT_EQ(record->addStep("BallLocator:execute"), 1u);
  for (std::size_t i = 0; i < 2 * CrashRecord::threads; ++i) record->addThread("many");
  EXPECT_EQ(record->addThread("too many"), -1);
  record->setStep(-1, 1);  // has no place: nothing happens
}

}  // namespace
}  // namespace plumbline
