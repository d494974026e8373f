#include "web/Geometry.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "simspark/SceneState.h"

namespace plumbline::web {
namespace {

using nlohmann::json;

json part(const json& geometry, std::size_t type, const std::string& name) {
  for (const json& part : geometry["types"][type]["parts"])
    if (part["name"] == name) return part;
  return {};
}

TEST(Geometry, sizesAreTheRobots) {
  const json geometry = json::parse(geometryMessage({}));
  EXPECT_EQ(geometry["kind"], "geometry");
  ASSERT_EQ(geometry["types"].size(), 5u);
  const auto shape = [&](std::size_t type, const std::string& name) {
    json found = part(geometry, type, name);
    found.erase("joints");
    return found;
  };
  EXPECT_EQ(shape(0, "torso"), json::parse(R"({"name":"torso","shape":"box","size":[0.1,0.1,0.18]})"));
  EXPECT_EQ(shape(3, "neck"), json::parse(R"({"name":"neck","shape":"capsule","size":[0.015,0.08]})"));
  EXPECT_EQ(shape(1, "head"), json::parse(R"({"name":"head","shape":"sphere","size":[0.065]})"));
  EXPECT_EQ(part(geometry, 0, "lFoot")["size"], json::parse("[0.16,0.08,0.02]"));
  EXPECT_EQ(part(geometry, 4, "lFoot")["size"], json::parse("[0.124482344,0.08,0.02]"));
  EXPECT_EQ(part(geometry, 4, "rToe")["size"], json::parse("[0.035517656,0.08,0.01]"));
}

TEST(Geometry, partsComeInTheOrderOfTheFrames) {
  const json geometry = json::parse(geometryMessage({}));
  for (int type = 0; type < 5; ++type) {
    std::vector<std::string> names;
    for (const json& part : geometry["types"][static_cast<std::size_t>(type)]["parts"])
      names.push_back(part["name"]);
    EXPECT_EQ(names, simspark::sceneBodies(type));
  }
}

TEST(Geometry, jointsJoinABodyWithWhatItHangsOnAndWhatHangsOnIt) {
  const json geometry = json::parse(geometryMessage({}));
  // A shoulder and the far longer way to the elbow.
  EXPECT_EQ(part(geometry, 1, "lUpperArm")["joints"],
            json::parse("[[-0.02,-0.01,0.0],[0.10664,-0.01,0.009]]"));
  EXPECT_EQ(part(geometry, 0, "torso")["joints"].size(), 5u);
  EXPECT_EQ(part(geometry, 0, "rFoot")["joints"].size(), 1u);
  EXPECT_EQ(part(geometry, 4, "rFoot")["joints"].size(), 2u);
}

TEST(Geometry, theField) {
  const json field = json::parse(geometryMessage({}))["field"];
  EXPECT_EQ(field["length"], 30);
  EXPECT_EQ(field["width"], 20);
  EXPECT_EQ(field["goalWidth"], 2.1);
  EXPECT_EQ(field["ballRadius"], 0.042);
  FieldSize small;
  small.length = 9;
  EXPECT_EQ(json::parse(geometryMessage(small))["field"]["length"], 9);
  ASSERT_EQ(field["lines"].size(), 11u);
  EXPECT_EQ(field["circle"], json::parse("[0,0,2.0]"));
  EXPECT_EQ(field["lines"][0], json::parse("[0.0,-10.0,0.0,10.0]"));
}

}  // namespace
}  // namespace plumbline::web
