#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "record/ExampleLog.h"
#include "record/LogReader.h"
#include "record/LogWalk.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::record {
namespace {

namespace fs = std::filesystem;

/// The numbers of all cycles, each with its counter's value found right.
std::vector<std::uint64_t> numbersOf(const std::string& path) {
  LogReader log(path);
  LogWalk walk(log);
  LogWalk::Step step{};
  std::vector<std::uint64_t> numbers;
  while (walk.next(step)) {
    numbers.push_back(step.cycle->number);
    EXPECT_EQ(*step.messages, exampleMessages(static_cast<int>(numbers.back())));
  }
  return numbers;
}

TEST(LogTest, holdsEveryCycleThoughOnlyChangesAreWritten) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "game", 1, 600);
  const auto numbers = numbersOf(scratch / "game");
  ASSERT_EQ(numbers.size(), 600u);
  EXPECT_EQ(numbers.back(), 600u);
  EXPECT_EQ(numbersOf(scratch / "game/game_0.db3").size(), 600u);
  LogReader log(scratch / "game");
  const LogReader::Thread& thread = log.thread("");
  EXPECT_EQ(thread.recorded.name, "main");
  EXPECT_EQ(thread.recorded.steps, exampleThread().steps);
  EXPECT_EQ(thread.recorded.topics.at(1).schema, exampleThread().topics.at(1).schema);
  EXPECT_EQ(thread.cycles.at(49).timestamp, 1'000'000'000);
  // Of three cycles with the same shapes one has their message, and now and then one has all.
  std::size_t shapes = 0;
  for (const auto& cycle : thread.cycles)
    log.read(thread, cycle, [&](std::size_t topic, std::string_view) { shapes += topic == 1 ? 1 : 0; });
  EXPECT_EQ(shapes, 201u + 1);  // the 251st; the 1st and the 501st have new ones
  std::vector<std::string> whole;
  log.readWhole(thread, 299, whole);
  EXPECT_EQ(whole, exampleMessages(300));
}

TEST(LogTest, goesOnInANewFileAndForgetsTheOldest) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "all", 1, 3000, {100'000, 0});
  EXPECT_GT(LogReader(scratch / "all").files().size(), 3u);
  EXPECT_EQ(numbersOf(scratch / "all").size(), 3000u);
  writeExampleLog(scratch / "some", 1, 3000, {100'000, 2});
  EXPECT_EQ(LogReader(scratch / "some").files().size(), 2u);
  const auto numbers = numbersOf(scratch / "some");
  EXPECT_EQ(numbers.back(), 3000u);
  EXPECT_EQ(numbers.back() - numbers.front() + 1, numbers.size());
}

TEST(LogTest, whatIsMissingIsKnown) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "game", 1, 20, {}, {7, 8});
  EXPECT_EQ(LogReader(scratch / "game").thread("main").missing(), 2u);
  EXPECT_EQ(numbersOf(scratch / "game").size(), 18u);
}

TEST(LogTest, whatWasCommittedIsReadWhileItIsWritten) {
  test::ScratchFolder scratch;
  LogWriter writer(scratch / "game", {});
  writer.begin({exampleThread()});
  const auto messages = exampleMessages(1);
  const CycleView cycle{0, 1, 5, {messages.begin(), messages.end()}};
  writer.write(cycle);
  EXPECT_EQ(LogReader(scratch / "game").thread("main").cycles.size(), 0u);
  writer.commit();
  EXPECT_EQ(LogReader(scratch / "game").thread("main").cycles.size(), 1u);
}

TEST(LogTest, isNeverWrittenOverWhatIsThere) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "game", 1, 2);
  const std::string game = scratch / "game";
  EXPECT_EQ(thrownBy([&] { LogWriter(game + "/", {}); }),
            game + " exists already: a log is never overwritten; choose another name");
  EXPECT_EQ(thrownBy([] { LogWriter("..", {}); }), "..: a log needs a name of its own");
  { const LogWriter empty(scratch / "deep/empty", {}); }
  EXPECT_FALSE(fs::exists(scratch / "deep/empty"));
}

TEST(LogTest, whatIsNoLogIsSaid) {
  test::ScratchFolder scratch;
  const std::string path = scratch / "x";
  EXPECT_EQ(thrownBy([&] { LogReader log(path); }), path + ": there is no such log");
  fs::create_directory(path);
  EXPECT_EQ(thrownBy([&] { LogReader log(path); }), path + " is no log: no file NAME_0.db3 is in it");
  std::ofstream(path + "/x_0.db3") << "This is a text and no database at all, long enough to look like one.";
  EXPECT_EQ(thrownBy([&] { LogReader log(path); }), path + "/x_0.db3: file is not a database; it is no log");
  Database(scratch / "other.db3", Database::Mode::create).run("CREATE TABLE topics(id INTEGER)");
  EXPECT_EQ(thrownBy([&] { LogReader log(scratch / "other.db3"); }),
            (scratch / "other.db3") + " is no log of this program: it has no table plumbline_cycles");
}

TEST(LogTest, brokenFilesEndInAnErrorOrInLessAndInNothingWorse) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "game", 1, 50);
  std::ifstream file(scratch / "game/game_0.db3", std::ios::binary);
  std::stringstream whole;
  whole << file.rdbuf();
  const std::string good = whole.str();
  for (std::size_t i = 0; i < 60; ++i) {
    std::string bad = good;
    const std::size_t at = (i * 7919 + 16) * 37 % bad.size();
    for (std::size_t b = at; b < std::min(at + 40, bad.size()); ++b) bad[b] = static_cast<char>(i * 31 + b);
    const std::string path = scratch / ("bad" + std::to_string(i) + ".db3");
    std::ofstream(path, std::ios::binary) << bad;
    try {
      LogReader log(path);
      LogWalk walk(log);
      LogWalk::Step step{};
      while (walk.next(step)) {
      }
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}

TEST(LogTest, metadataNamesWhatRosToolsWant) {
  test::ScratchFolder scratch;
  writeExampleLog(scratch / "game", 1, 9);
  std::ifstream file(scratch / "game/metadata.yaml");
  std::stringstream text;
  text << file.rdbuf();
  for (const char* part :
       {"storage_identifier: sqlite3", "nanoseconds_since_epoch: 20000000", "nanoseconds: 160000000",
        "message_count: 13", "name: /main/Counter", "type: plumbline_msgs/msg/Shapes", "    - game_0.db3"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part << '\n' << text.str();
}

}  // namespace
}  // namespace plumbline::record
