#include "inspect/Inspector.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "framework/Controller.h"
#include "framework/DebugSite.h"
#include "framework/Module.h"
#include "support/FarOff.h"

namespace plumbline {

REPRESENTATION(InspectedPlace)
class InspectedPlace : public InspectedPlaceBase {
public:
  double x = 0, y = 0;
  std::vector<int> list{1, 2, 3};
  std::string problem() const { return list.size() < 5 ? "" : "list: has more than 4"; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(x);
    STREAM(y);
    STREAM(list);
  }
};

MODULE(InspectedModule)
  PROVIDES(InspectedPlace)
  PARAMETER(double, speed, 0.5, "m/s", Range(0, 1), "added to x in each cycle")
  PARAMETER(int, notMore, 5, "", Range(0, 100), "refused where it is 13")
END_MODULE
class InspectedModule : public InspectedModuleBase {
public:
  void parametersChanged() override {
    if (notMore == 13) refuse("notMore", "must not be 13");
  }
  void execute() override {
    const auto watch = debug.stopwatch("own");
    DEBUG_RESPONSE("module:InspectedModule:talk", DEBUG_RESPONSE_OUTPUT("x is " + std::to_string(x_)));
    DEBUG_RESPONSE_ONCE("module:InspectedModule:jump", x_ = 1000; DEBUG_RESPONSE_OUTPUT("jumped"));
    OUTPUT("module:InspectedModule:x", x_);
  }
  void update(InspectedPlace* theInspectedPlace) override {
    x_ += speed;
    theInspectedPlace->x = x_;
    theInspectedPlace->y = -1;
    theInspectedPlace->list = {1, 2, 3};
  }

private:
  double x_ = 0;
};
MAKE_MODULE(InspectedModule)

namespace inspect {
namespace {

struct InspectorTest : testing::Test {
  Controller controller{{"modules.cfg", {"nowhere"}}, "InspectedModule InspectedPlace\n"};
  std::vector<std::string> lines;
  std::optional<Inspector> inspector;
  int client = 0;

  InspectorTest() {
    controller.runCycles(1);
    inspector.emplace(controller.debug());
    client = inspector->open([this](std::string_view line, bool droppable) { return take(line, droppable); });
  }

  bool reads = true;  ///< false: the client takes nothing that it may miss
  int offered = 0;    ///< lines that it might miss
  bool take(std::string_view line, bool droppable) {
    offered += droppable ? 1 : 0;
    if (droppable && !reads) return false;
    lines.emplace_back(line);
    return true;
  }

  using Lines = std::vector<std::string>;
  /// What came after the command and so many cycles.
  Lines ask(const std::string& command, int cycles = 1) {
    lines.clear();
    inspector->command(client, command);
    go(cycles);
    return lines;
  }
  void go(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      controller.runCycles(1);
      inspector->poll();
    }
  }
  const InspectedPlace& place() { return *controller.find<InspectedPlace>(); }
};

TEST_F(InspectorTest, getsValuesAndParts) {
  EXPECT_EQ(ask("get representation:InspectedPlace"),
            Lines{"representation:InspectedPlace {[x] 1.000000 [y] -1.000000 [list] {1 2 3}}"});
  EXPECT_EQ(ask("get representation:InspectedPlace.list[1]"),
            Lines{"representation:InspectedPlace.list[1] 2"});
  EXPECT_EQ(ask("get config:InspectedModule.speed"), Lines{"config:InspectedModule.speed 0.500000"});
  EXPECT_EQ(ask("get module:InspectedModule:x", 5), Lines{"module:InspectedModule:x 2.000000"});
  EXPECT_EQ(ask("get timing:InspectedModule:execute.count", 0),
            Lines{"timing:InspectedModule:execute.count 9"});
  EXPECT_FALSE(inspector->busy());
}

TEST_F(InspectorTest, saysWhatIsWrong) {
  EXPECT_EQ(ask("get representation:InspectedPlac"),
            Lines{"error: nothing is called representation:InspectedPlac; did you mean "
                  "\"representation:InspectedPlace\"?"});
  EXPECT_EQ(ask("get representation:InspectedPlace.z"),
            Lines{"error: representation:InspectedPlace has no part z; it has x, y, list"});
  EXPECT_EQ(ask("gte x"), Lines{"error: no command \"gte\"; did you mean \"get\"? (help lists them)"});
  EXPECT_EQ(ask("get"), Lines{"error: get NAME: the name is missing"});
  EXPECT_EQ(ask("watch"), Lines{"error: watch NAME [every N | every SECONDSs]: the name is missing"});
  EXPECT_EQ(ask("setOnce"), Lines{"error: setOnce NAME VALUE: the name is missing"});
  EXPECT_EQ(ask("unset"), Lines{"error: unset NAME: the name is missing"});
  EXPECT_EQ(ask("dr"), Lines{"error: dr NAME [once | off]: the name is missing"});
  EXPECT_EQ(ask("reset"), Lines{"error: reset MODULE: the name is missing"});
  EXPECT_EQ(ask("reload"), Lines{"error: reload FILE: the name is missing"});
  EXPECT_EQ(ask("format"), Lines{"error: format text|json: the name is missing"});
  EXPECT_EQ(ask("get a b"), Lines{"error: too much: \"b\""});
  EXPECT_EQ(ask("set a"), Lines{"error: set NAME VALUE: the value is missing"});
  EXPECT_EQ(ask("set representation:InspectedPlace {1 2"), Lines{"error: the value: a } is missing"});
  EXPECT_EQ(ask("set module:InspectedModule:x 1"),
            Lines{"error: module:InspectedModule:x cannot be set: its kind is output"});
  EXPECT_EQ(ask("set timing:InspectedModule:execute 1"),
            Lines{"error: timing:InspectedModule:execute cannot be set: its kind is timing"});
  EXPECT_EQ(ask("dr representation:InspectedPlace"),
            Lines{"error: representation:InspectedPlace is a value, not a block of code: get "
                  "representation:InspectedPlace"});
  EXPECT_EQ(ask("watch x every 0"),
            Lines{"error: watch NAME every N cycles or every SECONDSs, as 10 or 0.5s, not \"every 0\""});
  EXPECT_EQ(ask("format xml"), Lines{"error: format text|json, not \"xml\""});
  EXPECT_EQ(ask("get " + std::string(400, 'a')), Lines{"error: a name is longer than 300 characters"});
  EXPECT_EQ(ask("unset representation:InspectedPlace"),
            Lines{"error: representation:InspectedPlace is not set"});
  EXPECT_EQ(ask("#7"), Lines{});
  EXPECT_EQ(ask("# get x"), Lines{"error: a tag is missing behind #"});
}

TEST_F(InspectorTest, watchesUntilUnwatch) {
  EXPECT_EQ(ask("watch representation:InspectedPlace.x", 3),
            (Lines{"representation:InspectedPlace.x 1.000000", "representation:InspectedPlace.x 1.500000",
                   "representation:InspectedPlace.x 2.000000"}));
  EXPECT_EQ(ask("unwatch representation:InspectedPlace.x", 3), Lines{"ok"});
  EXPECT_EQ(ask("watch representation:InspectedPlace.x every 3", 4).size(), 2u);
  EXPECT_EQ(ask("unwatch"), Lines{"ok"});
  EXPECT_EQ(ask("unwatch representation:InspectedPlace.x"),
            Lines{"error: representation:InspectedPlace.x is not watched"});
}

TEST_F(InspectorTest, whatNobodyReadsIsNotMadeAnyMore) {
  using Clock = Inspector::Clock;
  reads = false;
  const auto begin = Clock::now();
  ask("watch module:InspectedModule:x", 500);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  EXPECT_GE(offered, 1);
  EXPECT_LE(offered, 2 + seconds / Inspector::slowPause) << "it rests after each value that was left out";
  reads = true;
  ASSERT_TRUE(comesTrue([&] {
    go(1);
    return !lines.empty();
  })) << "it goes on by itself";
  EXPECT_EQ(lines.back().substr(0, 24), "module:InspectedModule:x");
}

TEST_F(InspectorTest, modulesAreResetAndTheirProvisionsNamed) {
  EXPECT_EQ(ask("providers"), (Lines{"InspectedPlace  InspectedModule  [default]", "ok"}));
  ask("set representation:InspectedPlace.y 3");
  EXPECT_EQ(ask("providers Ins"),
            (Lines{"InspectedPlace  InspectedModule  [default], set from outside", "ok"}));
  EXPECT_EQ(ask("reset InspectedModule"), (Lines{"reset:InspectedModule InspectedModule began anew", "ok"}));
  go(1);
  EXPECT_EQ(place().x, 0.5);
  EXPECT_EQ(ask("reload InspectedModule"),
            (Lines{"reload:InspectedModule InspectedModule goes on with it", "ok"}));
  EXPECT_EQ(ask("reset"), Lines{"error: reset MODULE: the name is missing"});
  EXPECT_EQ(ask("reset A b"), Lines{"error: too much: \"b\""});
}

TEST_F(InspectorTest, tagsTellAnswersApart) {
  EXPECT_EQ(ask("#7 get representation:InspectedPlace.x"),
            (Lines{"#7 representation:InspectedPlace.x 1.000000", "#7 ."}));
  EXPECT_EQ(ask("#a set config:InspectedModule.speed 0.25"), (Lines{"#a ok", "#a ."}));
  EXPECT_EQ(ask("#8 get nothing"), (Lines{"#8 error: nothing is called nothing", "#8 ."}));
  EXPECT_EQ(ask("#9 watch representation:InspectedPlace.y"),
            Lines{"#9 representation:InspectedPlace.y -1.000000"});
  EXPECT_EQ(ask("#10 unwatch", 0), (Lines{"#9 .", "#10 ok", "#10 ."}));
}

TEST_F(InspectorTest, setsAPartInEveryCycleUntilUnset) {
  EXPECT_EQ(ask("set representation:InspectedPlace.y 5", 3), Lines{"ok"});
  EXPECT_EQ(place().y, 5);
  EXPECT_EQ(place().x, 2);
  EXPECT_EQ(ask("set representation:InspectedPlace.list[0] 7"), Lines{"ok"});
  EXPECT_EQ(place().list, (std::vector{7, 2, 3}));
  EXPECT_EQ(ask("list representation:", 0), (Lines{"representation:InspectedPlace  modify, set", "ok"}));
  inspector->close(client);
  go(2);
  EXPECT_EQ(place().y, 5);  // it stays when the client goes
  client = inspector->open([this](std::string_view line, bool droppable) { return take(line, droppable); });
  EXPECT_EQ(ask("unset representation:InspectedPlace"), Lines{"ok"});
  EXPECT_EQ(place().y, -1);
  EXPECT_EQ(place().list, (std::vector{1, 2, 3}));
}

TEST_F(InspectorTest, setsOnce) {
  EXPECT_EQ(ask("setOnce representation:InspectedPlace.y 5"), Lines{"ok"});
  EXPECT_EQ(place().y, 5);
  go(1);
  EXPECT_EQ(place().y, -1);
  EXPECT_FALSE(inspector->busy());
}

TEST_F(InspectorTest, aWrongValueLeavesEverythingAsItWas) {
  EXPECT_EQ(ask("set representation:InspectedPlace {1 far {}}"),
            Lines{"error: representation:InspectedPlace.y: expected a number, found \"far\""});
  EXPECT_EQ(place().x, 1);
  EXPECT_EQ(ask("set representation:InspectedPlace.x inf"),
            Lines{"error: representation:InspectedPlace.x: must be finite, not inf"});
  EXPECT_EQ(ask("set representation:InspectedPlace.list {1 2 3 4 5}"),
            Lines{"error: representation:InspectedPlace: list: has more than 4"});
  EXPECT_EQ(place().list.size(), 3u);
}

TEST_F(InspectorTest, parametersGoTheWayOfTheirFile) {
  EXPECT_EQ(ask("set config:InspectedModule.speed 0.25"), Lines{"ok"});
  const double before = place().x;
  go(2);
  EXPECT_EQ(place().x, before + 0.5);
  EXPECT_EQ(ask("set config:InspectedModule.speed 7"),
            Lines{"error: config:InspectedModule.speed: InspectedModule.speed must be within [0, 1], not 7"});
  EXPECT_EQ(ask("get config:InspectedModule.speed"), Lines{"config:InspectedModule.speed 0.250000"});
  EXPECT_EQ(ask("set config:InspectedModule.speed 0.75"), Lines{"ok"});
  EXPECT_EQ(ask("set config:InspectedModule.notMore 13"),
            Lines{"error: config:InspectedModule.notMore: InspectedModule.notMore must not be 13"});
}

TEST_F(InspectorTest, unsetGivesAParameterItsFirstValueBack) {
  ask("set config:InspectedModule.speed 0.25");
  ask("set config:InspectedModule.speed 1");
  EXPECT_EQ(ask("unset config:InspectedModule.speed"), Lines{"ok"});
  EXPECT_EQ(ask("get config:InspectedModule.speed"), Lines{"config:InspectedModule.speed 0.500000"});
  EXPECT_FALSE(inspector->busy());
}

TEST_F(InspectorTest, switchesBlocksOfCode) {
  EXPECT_EQ(ask("dr module:InspectedModule:talk once", 3),
            (Lines{"module:InspectedModule:talk x is 0.500000", "ok"}));
  EXPECT_EQ(ask("dr module:InspectedModule:talk", 2).size(), 3u);
  EXPECT_EQ(ask("dr module:InspectedModule:talk off", 2), Lines{"ok"});
  EXPECT_EQ(ask("dr module:InspectedModule:talk off"), Lines{"error: module:InspectedModule:talk is not on"});
  EXPECT_EQ(ask("dr module:InspectedModule:jump", 3), (Lines{"module:InspectedModule:jump jumped", "ok"}));
  EXPECT_EQ(ask("get module:InspectedModule:talk"),
            Lines{"error: module:InspectedModule:talk is a block of code, not a value: dr "
                  "module:InspectedModule:talk"});
}

TEST_F(InspectorTest, completesNamesAndParts) {
  EXPECT_EQ(ask("complete config:Ins"),
            (Lines{"config:InspectedModule.notMore", "config:InspectedModule.speed"}));
  EXPECT_EQ(ask("complete representation:InspectedPlace."),
            (Lines{"representation:InspectedPlace.x", "representation:InspectedPlace.y",
                   "representation:InspectedPlace.list"}));
  EXPECT_EQ(ask("complete representation:InspectedPlace.list["),
            (Lines{"representation:InspectedPlace.list[0]", "representation:InspectedPlace.list[1]",
                   "representation:InspectedPlace.list[2]"}));
}

TEST_F(InspectorTest, completesWhatACommandTakes) {
  EXPECT_EQ(ask("complete set config:"),
            (Lines{"config:InspectedModule.notMore", "config:InspectedModule.speed"}));
  go(1);  // its sites are known from the first passage on
  EXPECT_EQ(ask("complete set module:InspectedModule"), Lines{}) << "none of them can be set";
  EXPECT_EQ(ask("complete dr module:InspectedModule:j"), Lines{"module:InspectedModule:jump"});
  EXPECT_EQ(ask("complete get module:InspectedModule:j"), Lines{}) << "a block of code has no value";
  EXPECT_EQ(ask("complete get representation:InspectedPlace.l"), Lines{"representation:InspectedPlace.list"});
  EXPECT_EQ(ask("complete reset"), Lines{"InspectedModule"});
  EXPECT_EQ(ask("complete reload Insp"), Lines{"InspectedModule"});
  EXPECT_EQ(ask("complete providers I"), Lines{"InspectedPlace"});
  EXPECT_EQ(ask("complete format j"), Lines{"json"});
  EXPECT_EQ(ask("complete timing default:"), (Lines{"default:busy", "default:cycle", "default:processor"}));
  EXPECT_EQ(ask("complete unset"), Lines{});
  ask("set representation:InspectedPlace.y 3");
  EXPECT_EQ(ask("complete unset"), Lines{"representation:InspectedPlace.y"});
  ask("#1 watch config:InspectedModule.speed every 1000");
  EXPECT_EQ(ask("complete unwatch"), Lines{"config:InspectedModule.speed"});
  EXPECT_EQ(ask("complete gte x"), Lines{"error: complete [COMMAND] [PREFIX]: no command \"gte\""});
}

TEST_F(InspectorTest, tellsItsCommands) {
  const Lines commands = ask("commands");
  EXPECT_EQ(commands.size(), 18u);
  EXPECT_EQ(commands.at(0), "get NAME");
  EXPECT_EQ(commands.at(1), "watch NAME [every N | every SECONDSs]");
  EXPECT_EQ(
      ask("help reset"),
      Lines{"reset MODULE                restarts a module; parameters that were set keep their values"});
  EXPECT_EQ(ask("help rest"), Lines{"error: no command \"rest\"; did you mean \"reset\"?"});
  EXPECT_EQ(ask("commands now"), Lines{"error: commands has nothing behind it"});
  for (const std::string& usage : commands) {
    const std::string word = usage.substr(0, usage.find(' '));
    EXPECT_NE(ask("help " + word).at(0).substr(0, 6), "error:") << word;
  }
}

TEST_F(InspectorTest, answersInJson) {
  EXPECT_EQ(ask("format json"), Lines{R"({"ok":true})"});
  EXPECT_EQ(ask("get representation:InspectedPlace"),
            Lines{R"({"id":"representation:InspectedPlace","value":{"list":[1,2,3],"x":1.5,"y":-1.0}})"});
  EXPECT_EQ(ask("get nothing"), Lines{R"({"error":"nothing is called nothing"})"});
  EXPECT_EQ(ask("list module:InspectedModule:x")[0],
            R"({"id":"module:InspectedModule:x","kind":"output","held":false})");
}

TEST_F(InspectorTest, theModulesOwnStopwatchesComeWithTheirFirstUse) {
  go(1);
  EXPECT_EQ(ask("get timing:InspectedModule:own.count", 0), Lines{"timing:InspectedModule:own.count 2"});
  const Lines table = ask("timing", 0);
  EXPECT_EQ(table[0].substr(0, 15), "[default] load ");
  const Lines part = ask("timing InspectedModule:own", 0);
  ASSERT_EQ(part.size(), 3u) << "the thread, the heading, and what was asked for";
  EXPECT_EQ(part[2].substr(0, 25), "  InspectedModule:own    ");
  EXPECT_EQ(ask("timing timing:InspectedModule:own", 0).size(), 3u);
  EXPECT_EQ(ask("timing Nobody", 0), Lines{"error: no time has a name that begins with Nobody"});
}

TEST_F(InspectorTest, aThreadsCyclesAreStopwatchesToo) {
  EXPECT_EQ(ask("get timing:default:cycle.count", 0), Lines{"timing:default:cycle.count 1"});
  go(3);
  EXPECT_EQ(ask("get timing:default:busy.count", 0), Lines{"timing:default:busy.count 4"});
  EXPECT_EQ(ask("get timing:default:processor.count", 0), Lines{"timing:default:processor.count 4"});
}

TEST_F(InspectorTest, saysWhenNoCycleComesBy) {
  inspector->command(client, "get representation:InspectedPlace");
  lines.clear();
  inspector->poll(Inspector::Clock::now() + std::chrono::seconds(3));
  EXPECT_EQ(lines, Lines{"error: representation:InspectedPlace: the code did not reach this point within 2 "
                         "s; does the agent wait for its simulator?"});
}

TEST_F(InspectorTest, whatAClientAsksForIsBounded) {
  for (std::size_t i = 0; i < Inspector::maxPerClient; ++i)
    inspector->command(client, "watch representation:InspectedPlace every 3600s");
  EXPECT_EQ(ask("get representation:InspectedPlace", 0), Lines{"error: too many requests at once"});
  inspector->close(client);
  EXPECT_FALSE(inspector->busy());
  EXPECT_FALSE(controller.debug().watched());
}

}  // namespace
}  // namespace inspect
}  // namespace plumbline
