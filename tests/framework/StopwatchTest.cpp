#include "framework/Stopwatch.h"

#include <gtest/gtest.h>

#include <ctime>
#include <sstream>
#include <thread>

#include "framework/AgentDebug.h"
#include "framework/TestModules.h"
#include "framework/TimingPlugin.h"

namespace plumbline {

MODULE(Measurer)
END_MODULE
class Measurer : public MeasurerBase {
public:
  void execute() override {
    const auto watch = debug.stopwatch("inner");
    volatile int sum = 0;
    for (int i = 0; i < 1000; ++i) sum = sum + i;
  }
};
MAKE_MODULE(Measurer)

namespace {

TEST(StopwatchTest, isZeroBeforeAnythingWasMeasured) {
  const Stopwatch watch;
  EXPECT_EQ(watch.count(), 0u);
  EXPECT_EQ(watch.mean(), 0);
  EXPECT_EQ(watch.max(), 0);
  EXPECT_EQ(watch.percentile(0.5), 0);
}

TEST(StopwatchTest, knowsMeanMaximumAndPercentiles) {
  Stopwatch watch;
  for (std::uint64_t i = 1; i <= 1000; ++i) watch.add(1000 * i);
  EXPECT_EQ(watch.count(), 1000u);
  EXPECT_NEAR(watch.total(), 500500e-6, 1e-12);
  EXPECT_NEAR(watch.mean(), 500.5e-6, 1e-12);
  EXPECT_NEAR(watch.max(), 1000e-6, 1e-12);
  for (const double part : {0.001, 0.01, 0.5, 0.95, 0.99}) {
    EXPECT_GE(watch.percentile(part), part * 1000e-6 * (1 - 1e-9));
    EXPECT_LE(watch.percentile(part), part * 1000e-6 * 1.125);
  }
  EXPECT_EQ(watch.percentile(1), watch.max());
}

TEST(StopwatchTest, smallAndHugeDurationsHaveTheirBins) {
  Stopwatch watch;
  watch.add(0);
  EXPECT_EQ(watch.percentile(1), 0);
  watch.add(7);
  EXPECT_NEAR(watch.percentile(1), 7e-9, 1e-18);
  watch.add(~std::uint64_t{0});
  EXPECT_NEAR(watch.percentile(1), 1.8446744073709552e10, 1e-3);
  EXPECT_NEAR(watch.percentile(0.6), 7e-9, 1e-18);
}

TEST(TimingPluginTest, measuresEveryStepAndCycle) {
  Controller controller = makeController("AlphaSource Alpha\nMeasurer\n");
  controller.runCycles(10);
  const TimingPlugin* timing = controller.timing();
  ASSERT_NE(timing, nullptr);
  EXPECT_EQ(timing->thread(), "default");
  ASSERT_EQ(timing->steps().size(), 3u);
  EXPECT_EQ(timing->steps()[0].name, "AlphaSource:execute");
  EXPECT_EQ(timing->steps()[1].name, "AlphaSource:updateAlpha");
  EXPECT_EQ(timing->steps()[2].name, "Measurer:execute");
  double steps = 0;
  for (const auto& step : timing->steps()) {
    EXPECT_EQ(step.stopwatch->count(), 10u);
    steps += step.stopwatch->total();
  }
  EXPECT_EQ(timing->cycle().count(), 10u);
  EXPECT_EQ(timing->cpu().count(), 10u);
  EXPECT_GE(timing->cycle().total(), steps);
  EXPECT_GT(timing->cpu().total(), 0);
}

TEST(TimingReportTest, isATableOfAllStopwatches) {
  Controller controller = makeController("AlphaSource Alpha\nMeasurer\n");
  controller.runCycles(10);
  std::vector<std::string> names;
  std::istringstream lines(controller.timingReport());
  for (std::string line; std::getline(lines, line);) {
    names.push_back(line.substr(0, line.find("   ")));
    if (names.size() > 1) {
      EXPECT_EQ(line.size(), 106u) << line;
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{names[0], "microseconds", "cycle", "cycle without waiting",
                                      "processor time per cycle", "AlphaSource:execute",
                                      "AlphaSource:updateAlpha", "Measurer:execute", "  Measurer:inner"}));
  EXPECT_EQ(names[0].substr(0, 15), "[default] load ");
}

MODULE(Computer)
END_MODULE
/// Computes for 25 ms in the first cycle and in every third one after it.
class Computer : public ComputerBase {
public:
  void execute() override {
    if (cycle_++ % 3 != 0) return;
    const auto spent = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    const double begin = spent();
    while (spent() - begin < 0.025) {
    }
  }

private:
  int cycle_ = 0;
};
MAKE_MODULE(Computer)

TEST(TimingPluginTest, countsCyclesThatComputeLongerThanOneOfTheLeagues) {
  Controller controller = makeController("AlphaSource Alpha\nComputer\n");
  controller.runCycles(6);
  const TimingPlugin& timing = *controller.timing();
  EXPECT_EQ(timing.deadline(), 0.02);
  EXPECT_EQ(timing.lateCpu(), 1u) << "the first cycle does not count";
  EXPECT_GE(timing.lateBusy(), 1u);
  EXPECT_GE(timing.firstCpu(), 0.024);
  EXPECT_GE(timing.largestCpu(), 0.024);
}

MODULE(SlowNow)
END_MODULE
/// Every other cycle takes 12 ms; in each it also waits for 30 ms, which does not count.
class SlowNow : public SlowNowBase {
public:
  void execute() override {
    {
      const Waiting waiting;
      const Waiting within;
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    if (cycle_++ % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(12));
  }

private:
  int cycle_ = 0;
};
MAKE_MODULE(SlowNow)

TEST(TimingPluginTest, countsAndNamesTheCyclesThatRunOver) {
  Controller controller = makeController("[main 4 100Hz]\nAlphaSource Alpha\nSlowNow\n");
  controller.runCycles(6);
  const TimingPlugin& timing = *controller.timing();
  EXPECT_EQ(timing.rate(), 100);
  EXPECT_GE(timing.overruns(), 3u);
  EXPECT_EQ(timing.deadline(), 0.01);
  EXPECT_GE(timing.lateBusy(), 2u);
  EXPECT_EQ(timing.lateCpu(), 0u) << "it slept, and took no processor time";
  EXPECT_EQ(timing.steps()[2].name, "SlowNow:execute");
  EXPECT_GE(timing.steps()[2].overruns, 3u);
  EXPECT_LT(timing.busy().mean(), timing.cycle().mean() - 0.029);
  const auto graph = controller.debug().graph();
  EXPECT_GE(graph.at(0).modules.at(1).overruns, 3u) << "of " << graph.at(0).modules.at(1).name;
  const std::string head = controller.timingReport().substr(0, controller.timingReport().find('\n'));
  EXPECT_NE(head.find("; at 100 Hz "), std::string::npos) << head;
  EXPECT_NE(head.find(" of 6 cycles ran over, longest in "), std::string::npos) << head;
}

}  // namespace
}  // namespace plumbline
