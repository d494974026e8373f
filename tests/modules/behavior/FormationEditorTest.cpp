#include "modules/behavior/FormationEditor.h"

#include <gtest/gtest.h>

#include <memory>

#include "inspect/Inspector.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"

namespace plumbline {
namespace {

constexpr const char* twoRows = R"(ballX: [-10, 10]
ballY: [0, 8]
places:
  - name: cover
    x:
      - [-12, -4]
      - [-12, -4.5]
    y:
      - [0, 0]
      - [6, 6]
)";

/// The editor as a page sees it over the debug port.
struct Editing {
  explicit Editing(const std::string& folder) : harness({folder}), agent(std::make_shared<AgentDebug>()) {
    harness.objects().set(agent);
    inspector.emplace(*agent);
    client = inspector->open([this](std::string_view line, bool) {
      said = line;
      return true;
    });
  }
  std::string ask(const std::string& command) {
    harness.module();
    inspector->command(client, command);
    harness.cycle();
    inspector->poll();
    return said;
  }
  test::ModuleHarness<FormationEditor> harness;
  std::shared_ptr<AgentDebug> agent;
  std::optional<inspect::Inspector> inspector;
  int client = 0;
  std::string said;
};

TEST(FormationEditor, aPlaceIsReadAndWritten) {
  test::ScratchFolder folder;
  folder.write("formation.yaml", twoRows);
  Editing editor(folder.path());
  EXPECT_EQ(editor.ask("get formation.places[0].x[0][1]"), "formation.places[0].x[0][1] -4.000000");
  EXPECT_EQ(editor.ask("set formation.places[0].x[0][1] -3.25"), "ok");
  std::string wanted = twoRows;
  EXPECT_EQ(folder.read("formation.yaml"), wanted.replace(wanted.find("-4]"), 2, "-3.25"));
}

TEST(FormationEditor, whatIsImpossibleIsRefusedAndTheFileStays) {
  test::ScratchFolder folder;
  folder.write("formation.yaml", twoRows);
  Editing editor(folder.path());
  EXPECT_EQ(editor.ask("set formation.places[0].x[0][1] 101"),
            "error: formation: " + folder / "formation.yaml" + ": cover: 101 is no number from -100 to 100");
  EXPECT_EQ(folder.read("formation.yaml"), twoRows);
}

TEST(FormationEditor, withoutAFileThereIsNothingToEdit) {
  test::ScratchFolder folder;
  Editing editor(folder.path());
  EXPECT_EQ(editor.ask("get formation"), "error: nothing is called formation");
}

TEST(FormationEditor, goesWithItsModule) {
  test::ScratchFolder folder;
  folder.write("formation.yaml", twoRows);
  const auto agent = std::make_shared<AgentDebug>();
  {
    test::ModuleHarness<FormationEditor> harness({folder.path()});
    harness.objects().set(agent);
    harness.cycle();
    EXPECT_TRUE(agent->points.find("formation").has_value());
  }
  EXPECT_FALSE(agent->points.find("formation").has_value());
}

}  // namespace
}  // namespace plumbline
