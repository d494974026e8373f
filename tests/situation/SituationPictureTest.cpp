#include "situation/SituationPicture.h"

#include <gtest/gtest.h>

#include "situation/SituationFile.h"
#include "situation/SituationKinds.h"
#include "situation/SituationPage.h"
#include "situation/kinds/StrikerSituationKind.h"

namespace plumbline {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// A striker at the middle of the field with a mate and two opponents.
Situation strikersSituation() {
  Situation s;
  s.about = "An opponent <waits>.";
  s.kind = &situationKind("striker");
  s.robot = Pose2(-0.5, 0, 0);
  s.player = 10;
  s.others.resize(3);
  s.others[0].mate = true;
  s.others[0].position = {-3, 2};
  s.others[0].number = 7;
  s.others[1].position = {3, 0};
  s.others[2].position = {4, -2};
  s.others[2].number = 5;
  auto known = std::make_shared<StrikerKnowledge>();
  known->kicks = {{.distance = 3}};
  s.known = known;
  auto expected = std::make_shared<StrikerExpected>();
  expected->action = StrikerExpected::Action::kick;
  expected->direction = {0.2, 0.8};
  s.expected = expected;
  return s;
}

TEST(SituationPicture, showsEverybodyWithNumbers) {
  const std::string svg = situationPicture(strikersSituation(), "waiting", FieldSize());
  EXPECT_EQ(count(svg, "r=\"10.0\" fill=\"#2f6fe8\""), 2u) << "the own team";
  EXPECT_EQ(count(svg, "r=\"10.0\" fill=\"#d63a2f\""), 2u) << "opponents";
  EXPECT_EQ(count(svg, "r=\"6.0\" fill=\"#ff8c1a\""), 1u) << "the ball";
  EXPECT_EQ(count(svg, "r=\"13.0\" fill=\"none\" stroke=\"white\""), 1u) << "who decides";
  for (const char* number : {">10</text>", ">7</text>", ">5</text>"})
    EXPECT_EQ(count(svg, number), 1u) << number;
}

TEST(SituationPicture, showsWhatIsExpected) {
  const std::string svg = situationPicture(strikersSituation(), "waiting", FieldSize());
  EXPECT_EQ(count(svg, "<polygon"), 1u) << "the directions";
  EXPECT_EQ(count(svg, ">kick</text>"), 1u);
  EXPECT_EQ(count(svg, ">An opponent &lt;waits&gt;.</text>"), 1u);
  EXPECT_EQ(count(svg, ">expected: kicks between 11 degrees left and 46 degrees left</text>"), 1u);
  Situation open = strikersSituation();
  open.expected = {};
  const std::string unwritten = situationPicture(open, "waiting", FieldSize());
  EXPECT_EQ(count(unwritten, "<polygon"), 0u);
  EXPECT_EQ(count(unwritten, ">expected: not written yet</text>"), 1u);
}

TEST(SituationPicture, isOfThePartOfTheFieldWhereTheyAre) {
  Situation s = strikersSituation();
  // From -3 to 4 m ahead with 1.3 m around: 9.6 m on 640 pixels. The middle is at 0.5 m, the ball at 0.
  EXPECT_NE(situationPicture(s, "x", FieldSize()).find("<circle cx=\"286.7\" cy=\"220.0\" r=\"6.0\""),
            std::string::npos);
  s.others[1].position = {14, 0};
  const std::string wide = situationPicture(s, "x", FieldSize());
  EXPECT_EQ(wide.find("cx=\"286.7\""), std::string::npos);
  EXPECT_NE(wide.find("width=\"640\""), std::string::npos) << "pictures are all so wide";
}

TEST(SituationPicture, allOfTheTestsAreDrawnWithinThePicture) {
  for (const SituationEntry& entry : situationsIn("tests/data/situations")) {
    const std::string svg = situationPicture(entry.situation, entry.name, FieldSize());
    EXPECT_EQ(svg.find("nan"), std::string::npos) << entry.file;
    EXPECT_EQ(svg, situationPicture(entry.situation, entry.name, FieldSize()));
    double height = 0;
    ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("<svg width"), "<svg width=\"640\" height=\"%lf\"", &height),
              1);
    for (auto at = svg.find("<circle cx"); at != std::string::npos; at = svg.find("<circle cx", at + 1)) {
      double x = 0, y = 0, r = 0;
      ASSERT_EQ(std::sscanf(svg.c_str() + at, "<circle cx=\"%lf\" cy=\"%lf\" r=\"%lf\"", &x, &y, &r), 3);
      if (r > 13) continue;  // the centre circle, and where something shall be
      EXPECT_TRUE(x > 0 && x < 640 && y > 0 && y < height) << entry.file << " " << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace plumbline
