#include "modules/infrastructure/LogModule.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "framework/ConfigurationError.h"
#include "framework/Controller.h"
#include "framework/Module.h"
#include "modules/infrastructure/AgentLog.h"
#include "record/LogCompare.h"
#include "record/ReplayConfig.h"
#include "support/Thrown.h"

namespace plumbline {

REPRESENTATION(LoggedInput)
class LoggedInput : public LoggedInputBase {
public:
  double value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};
REPRESENTATION(LoggedSum)
class LoggedSum : public LoggedSumBase {
public:
  double value = 0, before = -1;
  void stream(InStream* in, OutStream* out) override {
    STREAM(value);
    STREAM(before);
  }
};
REPRESENTATION(LoggedLater)
class LoggedLater : public LoggedLaterBase {
public:
  double value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};

/// What comes from outside: nobody knows the next one.
MODULE(LoggedSource)
  PROVIDES(LoggedInput)
END_MODULE
class LoggedSource : public LoggedSourceBase {
public:
  static inline double next = 0.1;
  void update(LoggedInput* theLoggedInput) override {
    theLoggedInput->value = next = 3.9 * next * (1 - next);
  }
};
MAKE_MODULE(LoggedSource)

/// Remembers, and looks at what is updated behind it.
MODULE(LoggedSummer)
  REQUIRES(LoggedInput)
  USES(LoggedLater)
  PROVIDES(LoggedSum)
END_MODULE
class LoggedSummer : public LoggedSummerBase {
public:
  void update(LoggedSum* theLoggedSum) override {
    theLoggedSum->value = sum_ += theLoggedInput->value;
    theLoggedSum->before = theLoggedLater ? theLoggedLater->value : -1;
  }

private:
  double sum_ = 0;
};
MAKE_MODULE(LoggedSummer)

MODULE(LoggedLast)
  REQUIRES(LoggedSum)
  PROVIDES(LoggedLater)
END_MODULE
class LoggedLast : public LoggedLastBase {
public:
  void update(LoggedLater* theLoggedLater) override { theLoggedLater->value = 2 * theLoggedSum->value; }
};
MAKE_MODULE(LoggedLast)

namespace {

namespace fs = std::filesystem;

constexpr const char* cfg = "LoggedLast LoggedLater\nLoggedSource LoggedInput\nLoggedSummer LoggedSum\nlog\n";

struct LogModuleTest : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("logmodule-" + std::to_string(getpid()));
  std::string game = (folder / "game").string(), again = (folder / "again").string();
  ControllerOptions setup{"modules.cfg", {"nowhere"}};
  std::vector<std::string> lines;

  LogModuleTest() { fs::create_directories(folder); }
  ~LogModuleTest() override { fs::remove_all(folder); }

  std::shared_ptr<LogOptions> optionsOf(const AgentLogOptions& options, const Controller& controller) {
    return makeLog(options, controller, setup.configDirectories,
                   [this](const std::string& line) { lines.push_back(line); });
  }
  void record(int cycles) {
    Controller controller(setup, cfg);
    AgentLogOptions options;
    options.folder = game;
    options.waits = true;
    controller.objects().set(optionsOf(options, controller));
    controller.runCycles(static_cast<std::size_t>(cycles));
  }
  /// Runs the modules on the log and records them as `again`.
  void replay(const std::vector<std::string>& compute) {
    AgentLogOptions options;
    options.folder = again;
    options.replay = game;
    options.compute = compute;
    Controller controller(setup, modulesOnLog(parseModulesConfig(cfg, "modules.cfg"), options, "none"));
    controller.objects().set(optionsOf(options, controller));
    EXPECT_EQ(controller.run(), 0);
  }
};

TEST_F(LogModuleTest, anyPartRunsOnTheLogWithTheSameBytes) {
  record(700);
  for (const std::vector<std::string>& part : std::initializer_list<std::vector<std::string>>{
           {"LoggedSummer"}, {"LoggedLast"}, {"LoggedSummer", "LoggedLast"}}) {
    replay(part);
    const record::LogComparison result = record::compareLogs(game, again, {}, 0);
    EXPECT_EQ(result.compared, 700u);
    EXPECT_TRUE(result.same()) << part.front();
    fs::remove_all(again);
  }
  replay({"LoggedSource"});  // goes on where it was, not as then
  EXPECT_FALSE(record::compareLogs(game, again, {}, 0).same());
}

TEST_F(LogModuleTest, backwardsIsExactBecauseAllIsPlayedAgain) {
  record(60);
  AgentLogOptions options;
  options.replay = game;
  options.compute = {"LoggedSummer"};
  options.replayed.paused = true;
  Controller controller(setup, modulesOnLog(parseModulesConfig(cfg, "modules.cfg"), options, "none"));
  const auto log = optionsOf(options, controller);
  controller.objects().set(log);
  controller.init();  // the players are there
  const auto at = [&](std::size_t cycle) {
    const std::size_t from = log->replay->position();
    log->replay->goTo(cycle);
    // Beginning anew counts as one, and at the end it rests once.
    controller.runCycles((cycle < from ? cycle + 1 : cycle - from) + 1);
    EXPECT_EQ(log->replay->position(), cycle);
    return controller.find<LoggedSum>()->value;
  };
  const double thirty = at(30), forty = at(40);
  EXPECT_NE(thirty, forty);
  EXPECT_EQ(at(30), thirty);
  EXPECT_EQ(at(40), forty);
}

TEST_F(LogModuleTest, whatIsWrongIsSaid) {
  record(5);
  AgentLogOptions options;
  options.replay = game;
  options.compute = {"LoggedSumer"};
  const ModulesConfig modules = parseModulesConfig(cfg, "modules.cfg");
  EXPECT_EQ(thrownBy([&] { modulesOnLog(modules, options, "none"); }),
            "--compute LoggedSumer: modules.cfg has no such module; did you mean \"LoggedSummer\"?");
  options.replay = (folder / "none").string();
  EXPECT_EQ(thrownBy([&] { modulesOnLog(modules, options, "none"); }),
            options.replay + ": there is no such log");
  Controller without(setup, "log LoggedInput\nLoggedSummer LoggedSum\n");
  EXPECT_EQ(thrownBy([&] { without.init(); }),
            "thread default wants LoggedInput from a log: start the agent with --replay LOG");
  AgentLogOptions only;
  only.folder = again;
  only.only = {"LoggedImput"};
  Controller controller(setup, cfg);
  EXPECT_EQ(thrownBy([&] { optionsOf(only, controller); }),
            "log: this agent has no representation LoggedImput; did you mean \"LoggedInput\"?");
  EXPECT_FALSE(fs::exists(again));
}

TEST_F(LogModuleTest, threadsAreReplayedEachFromItsOwnRecording) {
  const char* threads =
      "[one 1]\nLoggedSource LoggedInput\nLoggedSummer LoggedSum\nlog\n"
      "[two 1]\none LoggedSum\nLoggedLast LoggedLater\nlog\n";
  {
    Controller controller(setup, threads);
    AgentLogOptions options;
    options.folder = game;
    options.waits = true;
    controller.objects().set(optionsOf(options, controller));
    std::thread end([&] {
      const auto& recorder = *controller.objects().find<LogOptions>()->recorder;
      while (recorder.cycles() < 50) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      controller.stop().request(0, "");
    });
    controller.run();
    end.join();
  }
  AgentLogOptions options;
  options.folder = again;
  options.replay = game;
  options.compute = {"LoggedLast", "LoggedSummer"};
  Controller controller(setup, modulesOnLog(parseModulesConfig(threads, "modules.cfg"), options, "none"));
  controller.objects().set(optionsOf(options, controller));
  EXPECT_EQ(controller.run(), 0);
  controller.objects().find<LogOptions>()->recorder->finish();
  const record::LogComparison result = record::compareLogs(game, again, {}, 0);
  EXPECT_GT(result.compared, 10u);
  EXPECT_TRUE(result.missing.empty());
  EXPECT_EQ(result.onlyLeft + result.onlyRight, 0u);
  for (const record::LogDifference& d : result.differences)
    ADD_FAILURE() << d.thread << ' ' << d.representation << d.field << " in cycle " << d.cycle << ": "
                  << d.left << ", " << d.right;
}

TEST_F(LogModuleTest, onlyWhatIsNamedIsRecorded) {
  Controller controller(setup, cfg);
  AgentLogOptions options;
  options.folder = game;
  options.only = {"LoggedSum"};
  controller.objects().set(optionsOf(options, controller));
  controller.runCycles(3);
  controller.objects().find<LogOptions>()->recorder->finish();
  const record::LogReader log(game);
  ASSERT_EQ(log.thread("").recorded.topics.size(), 1u);
  EXPECT_EQ(log.thread("").recorded.topics[0].provider, "LoggedSummer");
  EXPECT_EQ(log.thread("").recorded.steps.size(), 6u);
}

}  // namespace
}  // namespace plumbline
