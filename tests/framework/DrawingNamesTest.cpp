#include "framework/DrawingNames.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "framework/DrawingSite.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

using Names = std::vector<std::string>;

/// Never called: its drawings are known all the same.
[[maybe_unused]] void drawNames() {
  DEBUG_DRAWING("draw:NamesTest:first", drawing.point(Vec2(0, 0), colours::red));
  DEBUG_DRAWING("draw:NamesTest:second", drawing.point(Vec2(0, 0), colours::red));
  DEBUG_DRAWING("draw:NamesTestAlone", drawing.point(Vec2(0, 0), colours::red));
}

TEST(DrawingNamesTest, drawingsAreKnownBeforeTheCodeGetsThere) {
  const Names names = drawingNames();
  EXPECT_TRUE(std::ranges::is_sorted(names));
  for (const char* id : {"draw:NamesTest:first", "draw:NamesTest:second", "draw:NamesTestAlone"})
    EXPECT_EQ(std::ranges::count(names, id), 1) << id;
}

TEST(DrawingNamesTest, aNameChoosesADrawingOrAllThatBeginWithItBeforeAColon) {
  EXPECT_EQ(chosenDrawings({"NamesTest:second"}), Names{"draw:NamesTest:second"});
  EXPECT_EQ(chosenDrawings({"draw:NamesTestAlone"}), Names{"draw:NamesTestAlone"});
  EXPECT_EQ(chosenDrawings({"NamesTest"}), (Names{"draw:NamesTest:first", "draw:NamesTest:second"}));
  EXPECT_EQ(chosenDrawings({"NamesTest:second", "NamesTest", "NamesTestAlone"}),
            (Names{"draw:NamesTest:first", "draw:NamesTest:second", "draw:NamesTestAlone"}))
      << "each once";
  EXPECT_EQ(chosenDrawings({}), Names());
}

TEST(DrawingNamesTest, anUnknownNameIsAnErrorWithTheNearestOne) {
  const auto problem = [](const std::string& name) { return thrownBy([&] { chosenDrawings({name}); }); };
  EXPECT_EQ(problem("NamesTest:secnod"),
            "no drawing is called \"NamesTest:secnod\"; did you mean \"NamesTest:second\"?");
  EXPECT_EQ(problem("nameTest"), "no drawing is called \"nameTest\"; did you mean \"NamesTest\"?");
  EXPECT_EQ(problem("NamesTest:"), "no drawing is called \"NamesTest:\"; did you mean \"NamesTest\"?");
  EXPECT_EQ(problem("zzzzzzzzzz"), "no drawing is called \"zzzzzzzzzz\"");
  EXPECT_EQ(problem("draw:"), "no drawing is called \"\"");
  EXPECT_EQ(problem(std::string(1000, 'q')).size(), std::string("no drawing is called \"\"").size() + 60);
}

}  // namespace
}  // namespace plumbline
