#include <gtest/gtest.h>

#include "framework/Controller.h"
#include "framework/DrawingSite.h"
#include "framework/Module.h"
#include "inspect/Inspector.h"

namespace plumbline {

REPRESENTATION(DrawnPlace)
class DrawnPlace : public DrawnPlaceBase {
public:
  int cycle = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(cycle); }
};

MODULE(DrawnModule)
  PROVIDES(DrawnPlace)
  PARAMETER(double, size, 4, "m", Range(0, 10), "of the point")
  PARAMETER_CHOICE(colour, "red", "of the point", "red", "blue")
END_MODULE
class DrawnModule : public DrawnModuleBase {
public:
  void update(DrawnPlace* theDrawnPlace) override {
    theDrawnPlace->cycle++;
    DEBUG_DRAWING("draw:DrawnModule:place", {
      drawing.point(Vec2(theDrawnPlace->cycle, 0), colours::red, size);
      drawing.text(Vec2(0, 0), "here", colours::white);
    });
  }
};
MAKE_MODULE(DrawnModule)

namespace inspect {
namespace {

struct DrawingsTest : testing::Test {
  Controller controller{{"modules.cfg", {"nowhere"}}, "DrawnModule DrawnPlace\n"};
  std::vector<std::string> lines;
  std::vector<std::pair<std::string, std::size_t>> shown;  ///< name and number of shapes
  std::optional<Inspector> inspector;
  int client = 0;

  DrawingsTest() {
    controller.runCycles(1);
    inspector.emplace(controller.debug());
    client = inspector->open([this](std::string_view line, bool) {
      lines.emplace_back(line);
      return true;
    });
  }
  void showing() {
    inspector->showDrawings([this](const std::string& id, const Drawing& drawing) {
      shown.emplace_back(id, drawing.shapes().size());
    });
  }
  using Lines = std::vector<std::string>;
  Lines ask(const std::string& command, int cycles = 1) {
    lines.clear();
    inspector->command(client, command);
    for (int i = 0; i < cycles; ++i) {
      controller.runCycles(1);
      inspector->poll();
    }
    return lines;
  }
};

TEST_F(DrawingsTest, aDrawingIsReadAsAnyValue) {
  EXPECT_EQ(ask("get draw:DrawnModule:place"),
            Lines{"draw:DrawnModule:place {{\"point\" \"#eb4034\" 2.000000 0.000000 0.000000 4.000000} "
                  "{\"text\" \"#ffffff\" 0.000000 0.000000 0.000000 \"here\"}}"});
  EXPECT_EQ(ask("get draw:DrawnModule:place[0][2]"), Lines{"draw:DrawnModule:place[0][2] 3.000000"});
  ask("format json", 0);
  EXPECT_EQ(ask("get draw:DrawnModule:place"),
            Lines{R"({"id":"draw:DrawnModule:place","value":[["point","#eb4034",4.0,0.0,0.0,4.0],)"
                  R"(["text","#ffffff",0.0,0.0,0.0,"here"]]})"});
  EXPECT_EQ(ask("complete draw:D"), Lines{R"({"completion":"draw:DrawnModule:place"})"});
}

TEST_F(DrawingsTest, isShownFromOnToOff) {
  showing();
  EXPECT_EQ(ask("#5 dr draw:DrawnModule:place", 3), (Lines{"#5 ok", "#5 ."}));
  ASSERT_EQ(shown.size(), 1u) << "viewers look 25 times a second, not in each cycle";
  EXPECT_EQ(shown[0], std::pair(std::string("draw:DrawnModule:place"), std::size_t{2}));
  EXPECT_EQ(ask("list draw:Drawn", 0), (Lines{"draw:DrawnModule:place  drawing, on", "ok"}));
  EXPECT_EQ(ask("dr draw:DrawnModule:place off"), Lines{"ok"});
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[1].second, 0u) << "what was shown is taken away";
  EXPECT_EQ(ask("dr draw:DrawnModule:place off"), Lines{"error: draw:DrawnModule:place is not on"});
  EXPECT_EQ(ask("dr draw:DrawnModule:place once", 2), Lines{"ok"});
  EXPECT_EQ(shown.size(), 3u);
  EXPECT_FALSE(inspector->busy());
}

TEST_F(DrawingsTest, withoutAViewerItCanOnlyBeWatched) {
  EXPECT_EQ(ask("dr draw:DrawnModule:place"),
            Lines{"error: draw:DrawnModule:place has no viewer here; it can be watched"});
  EXPECT_EQ(ask("set draw:DrawnModule:place {}"),
            Lines{"error: draw:DrawnModule:place cannot be set: its kind is drawing"});
}

TEST_F(DrawingsTest, tellsModulesAndParameters) {
  const Lines graph = ask("graph", 0);
  ASSERT_EQ(graph.size(), 2u);
  EXPECT_EQ(graph[0].substr(0, 15), "[default] load ");
  EXPECT_EQ(graph[1].substr(0, 15), "  DrawnModule (");
  EXPECT_EQ(graph[1].substr(graph[1].find(')')), "): DrawnPlace");
  EXPECT_EQ(ask("graph now", 0), Lines{"error: graph has nothing behind it"});
  EXPECT_EQ(ask("about config:DrawnModule", 0),
            (Lines{"config:DrawnModule.colour  text, one of red, blue: of the point",
                   "config:DrawnModule.size  double, m, 0 .. 10: of the point"}));
  ask("format json", 0);
  EXPECT_EQ(ask("about config:DrawnModule.size", 0),
            Lines{R"({"id":"config:DrawnModule.size","type":"double","unit":"m","min":0.0,"max":10.0,)"
                  R"("words":[],"default":"4","comment":"of the point"})"});
}

}  // namespace
}  // namespace inspect
}  // namespace plumbline
