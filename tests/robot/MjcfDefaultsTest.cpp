#include "robot/MjcfDefaults.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

/// The range of a joint with these attributes.
std::optional<Vec2> rangeOf(const std::string& attributes, bool rangesHoldByThemselves = true) {
  tinyxml2::XMLDocument document;
  document.Parse(("<joint " + attributes + "/>").c_str());
  const std::string file = "a.xml";
  MjcfDefaults defaults(file);
  defaults.rangesHoldByThemselves = rangesHoldByThemselves;
  return defaults.rangeOf(*document.RootElement(), "range", "limited");
}

TEST(MjcfDefaults, aRangeHoldsByItselfUnlessItsFlagOrTheCompilerSaysNo) {
  EXPECT_EQ(rangeOf("range=\"-1 2\""), Vec2(-1, 2));
  EXPECT_EQ(rangeOf("range=\"-1 2\" limited=\"auto\""), Vec2(-1, 2));
  EXPECT_FALSE(rangeOf("range=\"-1 2\" limited=\"false\""));
  EXPECT_FALSE(rangeOf("range=\"-1 2\"", false));
  EXPECT_EQ(rangeOf("range=\"-1 2\" limited=\"true\"", false), Vec2(-1, 2));
  EXPECT_FALSE(rangeOf("range=\"0 0\"")) << "not given";
  EXPECT_FALSE(rangeOf(""));
}

}  // namespace
}  // namespace plumbline
