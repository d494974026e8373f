#include "record/Recorder.h"

#include <gtest/gtest.h>

#include "record/ExampleLog.h"
#include "record/LogReader.h"
#include "support/ScratchFolder.h"

namespace plumbline::record {
namespace {

struct RecorderTest : testing::Test {
  test::ScratchFolder scratch;
  Counter counter;
  std::vector<std::string> lines;

  RecordedThread thread() {
    return {"main", {}, {{"Counter", "Count", schemaOf(representationLoader<Counter>())}}};
  }
  void run(RecorderOptions options, int cycles, const std::string& folder) {
    Recorder recorder(folder, options, [this](const std::string& line) { lines.push_back(line); });
    ThreadRecorder& part = recorder.addThread(thread(), {&counter});
    for (int i = 1; i <= cycles; ++i) {
      counter.value = i;
      part.record(i);
    }
    recorder.finish();
  }
};

TEST_F(RecorderTest, writesAllThatIsThereBeforeItEnds) {
  run({}, 5000, scratch / "game");
  const LogReader log(scratch / "game");
  EXPECT_EQ(log.thread("").cycles.size(), 5000u);
  EXPECT_EQ(log.dropped(), 0u);
  EXPECT_TRUE(lines.empty());
}

TEST_F(RecorderTest, aFullBufferDropsCyclesWhichAreCountedAndSaid) {
  RecorderOptions options;
  options.bufferBytes = 4096;
  run(options, 20000, scratch / "game");
  const LogReader log(scratch / "game");
  const auto& cycles = log.thread("").cycles;
  EXPECT_GT(log.dropped(), 0u);
  EXPECT_EQ(cycles.size() + log.dropped(), 20000u);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.back(),
            "log: " + std::to_string(log.dropped()) + " cycles are missing in " + (scratch / "game"));
}

TEST_F(RecorderTest, aRecorderThatWaitsDropsNone) {
  RecorderOptions options;
  options.bufferBytes = 4096;
  options.waits = true;
  run(options, 3000, scratch / "game");
  EXPECT_EQ(LogReader(scratch / "game").thread("").cycles.size(), 3000u);
}

TEST_F(RecorderTest, whatCannotBeWrittenIsSaidOnceAndTheAgentGoesOn) {
  Recorder recorder(scratch / "game", {}, [this](const std::string& line) { lines.push_back(line); });
  ThreadRecorder& part = recorder.addThread(thread(), {&counter});
  std::filesystem::remove_all(scratch / "game");
  for (int i = 1; i <= 100; ++i) part.record(i);
  recorder.finish();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], "log: " + (scratch / "game/game_0.db3") +
                          ": unable to open database file; nothing more is recorded");
  EXPECT_EQ(lines[1], "log: 100 cycles are missing in " + (scratch / "game"));
}

TEST_F(RecorderTest, leavesNothingWhereNothingCame) {
  run({}, 0, scratch / "game");
  EXPECT_FALSE(std::filesystem::exists(scratch / "game"));
}

}  // namespace
}  // namespace plumbline::record
