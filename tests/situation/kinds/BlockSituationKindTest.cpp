#include "situation/kinds/BlockSituationKind.h"

#include <gtest/gtest.h>

#include "situation/SituationKinds.h"
#include "situation/SituationPicture.h"

namespace plumbline {
namespace {

BlockExpected blocksNine() {
  BlockExpected e;
  e.opponent = 9;
  e.place = {-9.9, -0.2};
  e.within = 0.5;
  return e;
}

TEST(BlockExpectedTest, wordsAreANumberAndAPlace) {
  EXPECT_EQ(blocksNine().words(0), "number 9 is blocked from (-9.9, -0.2) within 0.5 m");
  EXPECT_EQ(BlockExpected().words(0), "nobody is blocked");
}

TEST(BlockSituationKindTest, inItsPictureNobodyDecidesAlone) {
  Situation s;
  s.kind = &situationKind("block");
  s.others.resize(1);
  s.others[0].number = 9;
  s.others[0].position = {2, 2};
  s.expected = std::make_shared<BlockExpected>(blocksNine());
  const std::string svg = situationPicture(s, "x", FieldSize());
  EXPECT_EQ(svg.find("stroke=\"white\" stroke-width=\"3\""), std::string::npos);
  EXPECT_NE(svg.find(">blocks 9</text>"), std::string::npos);
}

}  // namespace
}  // namespace plumbline
