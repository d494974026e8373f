#include "framework/DebugSite.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

#include "framework/AgentDebug.h"
#include "framework/DebugPoints.h"
#include "framework/TestModules.h"
#include "framework/TextStream.h"

namespace plumbline {
namespace {

/// Notes what is passed, and may set it.
class Note final : public DebugRequest {
public:
  void serve(DebugValue& value) noexcept override {
    std::string text;
    TextOutStream out(text);
    value.write(out);
    values.push_back(text);
    if (wanted.empty()) return;
    TextInStream in(wanted);
    value.read(in);
  }
  bool run() noexcept override { return runs; }
  void output(std::string_view text) noexcept override { values.emplace_back(text); }
  void finished() noexcept override { finishes++; }

  std::vector<std::string> values;
  std::string wanted;
  bool runs = true;
  int finishes = 0;
};

struct Attached {
  Attached(DebugPoints& points, std::string name) : points(points), id(std::move(name)) {
    known = points.attach(id, note);
  }
  ~Attached() { points.detach(id, note); }
  DebugPoints& points;
  std::string id;
  std::shared_ptr<Note> note = std::make_shared<Note>();
  bool known;
};

int visit(int value) {
  OUTPUT("test:output", value);
  MODIFY("test:modify", value);
  return value;
}

TEST(DebugSiteTest, isKnownFromTheFirstPassageOn) {
  auto pass = [] { OUTPUT_BY_VALUE("test:first", 1); };
  EXPECT_FALSE(DebugPoints::sites().find("test:first"));
  pass();
  EXPECT_EQ(DebugPoints::sites().find("test:first"), DebugKind::output);
}

TEST(DebugSiteTest, isReadAndSetOnlyWhileSomebodyWantsThat) {
  EXPECT_EQ(visit(1), 1);
  {
    const Attached output(DebugPoints::sites(), "test:output"), modify(DebugPoints::sites(), "test:modify");
    output.note->wanted = "70";
    modify.note->wanted = "7";
    EXPECT_EQ(visit(2), 7);  // an OUTPUT is not set
    EXPECT_EQ(output.note->values, std::vector<std::string>{"2 "});
    EXPECT_EQ(modify.note->values, std::vector<std::string>{"2 "});
  }
  EXPECT_EQ(visit(3), 3);
}

TEST(DebugSiteTest, evaluatesAValueOnlyWhenSomebodyLooks) {
  int calls = 0;
  auto pass = [&] { OUTPUT_BY_VALUE("test:value", std::pair<int, int>(++calls, 2)); };
  pass();  // registers
  const int before = calls;
  pass();
  EXPECT_EQ(calls, before);
  const Attached attached(DebugPoints::sites(), "test:value");
  pass();
  EXPECT_EQ(calls, before + 1);
}

TEST(DebugSiteTest, aResponseRunsWhileItIsOn) {
  int runs = 0;
  auto pass = [&] {
    DEBUG_RESPONSE("test:response", {
      int a = 1, b = 2;
      runs += a * b;
      DEBUG_RESPONSE_OUTPUT("ran");
    });
  };
  pass();
  EXPECT_EQ(runs, 0);
  {
    const Attached attached(DebugPoints::sites(), "test:response");
    pass();
    attached.note->runs = false;
    pass();
    EXPECT_EQ(runs, 2);
    EXPECT_EQ(attached.note->values, std::vector<std::string>{"ran"});
    EXPECT_EQ(attached.note->finishes, 1);
  }
  pass();
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(DebugPoints::sites().find("test:response"), DebugKind::code);
}

TEST(DebugSiteTest, severalPlacesMayHaveOneId) {
  auto first = [] { OUTPUT_BY_VALUE("test:shared", 1); };
  auto second = [] { OUTPUT_BY_VALUE("test:shared", 2); };
  first();
  const Attached attached(DebugPoints::sites(), "test:shared");
  second();  // known only now, and wanted at once
  first();
  EXPECT_EQ(attached.note->values, (std::vector<std::string>{"2 ", "1 "}));
}

/// Counts how often it is served.
class Count final : public DebugRequest {
public:
  void serve(DebugValue&) noexcept override { served++; }
  static inline std::atomic<int> served = 0;
};

TEST(DebugSiteTest, requestsComeAndGoWhileThreadsPass) {
  std::atomic<bool> stop = false;
  std::atomic<int> sum = 0;
  const auto work = [&] {
    while (!stop) sum += visit(0);
  };
  visit(0);
  std::thread one(work), two(work);
  for (int i = 0; i < 2000; ++i) {
    const auto request = std::make_shared<Count>();
    DebugPoints::sites().attach("test:output", request);
    DebugPoints::sites().detach("test:output", request);
  }
  while (Count::served < 1) {
    const auto request = std::make_shared<Count>();
    DebugPoints::sites().attach("test:output", request);
    std::this_thread::yield();
    DebugPoints::sites().detach("test:output", request);
  }
  stop = true;
  one.join();
  two.join();
  EXPECT_EQ(sum, 0);
}

TEST(AgentDebugTest, everyRepresentationParameterAndStopwatchIsThere) {
  Controller controller = makeController("AlphaSource Alpha\nBetaFromAlpha Beta\n");
  controller.init();
  EXPECT_EQ(controller.debug().points.find("representation:Alpha"), DebugKind::modify);
  EXPECT_EQ(controller.debug().points.find("representation:Beta"), DebugKind::modify);
  EXPECT_TRUE(controller.debug().stopwatches().contains("timing:BetaFromAlpha:updateBeta"));
}

TEST(AgentDebugTest, aRepresentationIsSetBehindItsUpdateAndTheNextModuleSeesIt) {
  Controller controller = makeController("AlphaSource Alpha\nBetaFromAlpha Beta\n");
  controller.runCycles(1);
  {
    const Attached attached(controller.debug().points, "representation:Alpha");
    attached.note->wanted = "{[value] 50}";
    controller.runCycles(1);
    EXPECT_EQ(controller.find<Beta>()->value, 20);  // nobody watches: nothing is looked for
    controller.debug().setWatched(true);
    controller.runCycles(2);
    EXPECT_EQ(controller.find<Alpha>()->value, 50);
    EXPECT_EQ(controller.find<Beta>()->value, 500);
    EXPECT_EQ(attached.note->values, (std::vector<std::string>{"{[value] 3 }", "{[value] 4 }"}));
  }
  controller.runCycles(1);
  EXPECT_EQ(controller.find<Beta>()->value, 50);
}

TEST(DebugPointsTest, requestsWaitForAPointThatIsExpected) {
  DebugPoints points;
  points.expect("draw:later", DebugKind::drawing);
  EXPECT_EQ(points.find("draw:later"), DebugKind::drawing);
  const Attached early(points, "draw:later");
  EXPECT_TRUE(early.known);
  DebugPoint point("draw:later", DebugKind::output);
  points.add(point);
  EXPECT_EQ(points.find("draw:later"), DebugKind::output) << "what it really is";
  int value = 7;
  debugging::output(point, value);
  EXPECT_EQ(early.note->values, std::vector<std::string>{"7 "});
  // An id that is known stays what it is.
  points.expect("draw:later", DebugKind::drawing);
  EXPECT_EQ(points.find("draw:later"), DebugKind::output);
  points.remove(point);
}

}  // namespace
}  // namespace plumbline
