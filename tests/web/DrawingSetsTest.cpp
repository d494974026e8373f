#include "web/DrawingSets.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumbline::web {
namespace {

using nlohmann::json;
using simspark::TeamSide;

Shape point(const std::string& set, double x = 0) { return {Point{Vec3(x, 0, 0), 5}, {1, 2, 3, 255}, set}; }

TEST(DrawingSets, shapesAppearWithTheSwapAndGoWithTheNext) {
  DrawingSets sets;
  EXPECT_FALSE(sets.apply(point("a")));
  EXPECT_EQ(sets.numShown(), 0u);
  EXPECT_TRUE(sets.apply(SwapSets{"a"}));
  EXPECT_EQ(sets.numShown(), 1u);
  EXPECT_FALSE(sets.apply(point("a")));
  EXPECT_FALSE(sets.apply(point("a")));
  EXPECT_EQ(sets.numShown(), 1u) << "what is being drawn is not shown yet";
  EXPECT_TRUE(sets.apply(SwapSets{"a"}));
  EXPECT_EQ(sets.numShown(), 2u);
  EXPECT_TRUE(sets.apply(SwapSets{"a"}));
  EXPECT_EQ(sets.numShown(), 0u);
  EXPECT_FALSE(sets.apply(SwapSets{"a"})) << "nothing changed";
}

TEST(DrawingSets, aSwapActsOnAllNamesThatBeginSo) {
  DrawingSets sets;
  for (const char* set : {"l_1", "l_10", "l_2", "r_1"}) sets.apply(point(set));
  sets.apply(SwapSets{"l_1"});
  EXPECT_EQ(sets.numShown(), 2u);
  sets.apply(SwapSets{""});
  EXPECT_EQ(sets.numShown(), 2u) << "the first two have nothing new, the others appear";
}

TEST(DrawingSets, textsOfAgentsNeedNoSwap) {
  DrawingSets sets;
  EXPECT_TRUE(sets.apply(AgentText{{TeamSide::left, 3}, {255, 0, 0, 255}, "hello"}));
  EXPECT_TRUE(sets.apply(AgentText{{TeamSide::right, 3}, {0, 0, 0, 255}, "x"}));
  EXPECT_TRUE(sets.apply(SelectAgent{{TeamSide::left, 9}}));
  json message = json::parse(sets.toJson());
  EXPECT_EQ(message["texts"], json::parse(R"([{"side":"left","unum":3,"colour":"#ff0000","text":"hello"},
                                              {"side":"right","unum":3,"colour":"#000000","text":"x"}])"));
  EXPECT_EQ(message["selected"], json::parse(R"({"side":"left","unum":9})"));
  EXPECT_TRUE(sets.apply(AgentText{{TeamSide::right, 3}, {}, ""}));
  EXPECT_FALSE(sets.apply(AgentText{{TeamSide::right, 4}, {}, ""}));
  EXPECT_EQ(json::parse(sets.toJson())["texts"].size(), 1u);
}

TEST(DrawingSets, everyShapeAsThePageReadsIt) {
  DrawingSets sets;
  const Colour red{255, 0, 0, 255};
  sets.apply(Shape{Circle{Vec2(1, 2), 3, 4}, red, "s"});
  sets.apply(Shape{Line{Vec3(1, 2, 3), Vec3(4, 5, 6), 7}, red, "s"});
  sets.apply(Shape{Point{Vec3(1, 2, 3), 4}, red, "s"});
  sets.apply(Shape{Sphere{Vec3(1, 2, 3), 0.25}, red, "s"});
  sets.apply(Shape{Polygon{{Vec3(1, 2, 3), Vec3(4, 5, 6)}}, {255, 0, 0, 128}, "s"});
  sets.apply(Shape{Annotation{Vec3(1, 2, 3.00004), "bad \xff text"}, red, "s"});
  sets.apply(SwapSets{"s"});
  const json message = json::parse(sets.toJson());
  EXPECT_EQ(message["kind"], "drawings");
  EXPECT_EQ(message["sets"], json::parse(R"([{"name":"s","shapes":[
    ["circle","#ff0000",1.0,2.0,3.0,4.0], ["line","#ff0000",1.0,2.0,3.0,4.0,5.0,6.0,7.0],
    ["point","#ff0000",1.0,2.0,3.0,4.0], ["sphere","#ff0000",1.0,2.0,3.0,0.25],
    ["polygon","#ff000080",1.0,2.0,3.0,4.0,5.0,6.0],
    ["text","#ff0000",1.0,2.0,3.0,"bad \ufffd text"]]}])"));
}

TEST(DrawingSets, memoryIsBounded) {
  DrawingSets sets;
  for (std::size_t i = 0; i < DrawingSets::maxShapesOfSet + 10; ++i) sets.apply(point("a"));
  sets.apply(SwapSets{"a"});
  EXPECT_EQ(sets.numShown(), DrawingSets::maxShapesOfSet);
  for (std::size_t i = 0; i < DrawingSets::maxSets + 10; ++i) sets.apply(point("b" + std::to_string(i)));
  sets.apply(SwapSets{"b"});
  EXPECT_EQ(sets.numShown(), DrawingSets::maxShapesOfSet + DrawingSets::maxSets - 1);
  for (int set = 0; set < 20; ++set)
    for (std::size_t i = 0; i < DrawingSets::maxShapesOfSet; ++i)
      sets.apply(point("b" + std::to_string(set)));
  sets.apply(SwapSets{""});
  EXPECT_LE(sets.numShown(), DrawingSets::maxShapes);
  sets.apply(SwapSets{""});
  EXPECT_EQ(sets.numShown(), 0u);
  sets.apply(point("new"));
  sets.apply(SwapSets{""});
  EXPECT_EQ(sets.numShown(), 1u) << "what went makes room";
}

}  // namespace
}  // namespace plumbline::web
