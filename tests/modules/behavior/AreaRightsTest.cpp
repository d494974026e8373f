#include "modules/behavior/formation/AreaRights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "math/Random.h"

using namespace plumbline;

namespace {

// The area begins at -13.2 m and is 6 m wide.
struct AreaRightsTest : testing::Test {
  static TeamMember memberAt(int number, double x, double y, double time, bool fallen = false) {
    return {number, Pose2(x, y, 0), fallen, PlayerRole::supporter, time};
  }
  /// The numbers of those with the right.
  std::set<int> rights(const std::vector<TeamMember>& members, int goalie = 1) const {
    const std::vector<bool> has = areaRights(members, area, goalie, 0.8, parameters);
    std::set<int> numbers;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (has[i]) numbers.insert(members[i].number);
    return numbers;
  }
  OwnArea area{FieldSize()};
  AreaRightsParameters parameters;
};

using Numbers = std::set<int>;

TEST_F(AreaRightsTest, theGoalieAndTheTwoThatAreFirstAtTheBall) {
  EXPECT_EQ(rights({memberAt(1, -14, 0, 16), memberAt(2, -10, 0, 4), memberAt(3, -10, 1, 2),
                    memberAt(4, -10, 2, 3), memberAt(5, 0, 0, 9)}),
            (Numbers{1, 3, 4}));
}

TEST_F(AreaRightsTest, aPlaceIsKeptForAGoalieThatIsOutOrUnheard) {
  EXPECT_EQ(
      rights({memberAt(1, -9, 0, 5), memberAt(2, -14, 0, 4), memberAt(3, -14, 1, 2), memberAt(4, -14, 2, 3)}),
      (Numbers{1, 3, 4}));
  EXPECT_EQ(rights({memberAt(2, -14, 0, 4), memberAt(3, -14, 1, 2), memberAt(4, -14, 2, 3)}),
            (Numbers{3, 4}));
  EXPECT_EQ(rights({memberAt(2, -14, 0, 4), memberAt(3, -14, 1, 2), memberAt(4, -14, 2, 3)}, 0),
            (Numbers{2, 3, 4}))
      << "a team without a goalie";
}

TEST_F(AreaRightsTest, whoIsThereStaysWhereTheDifferenceIsSmall) {
  EXPECT_EQ(rights({memberAt(2, -14, 0, 3), memberAt(3, -14, 1, 3), memberAt(4, -12, 0, 2.5)}),
            (Numbers{2, 3}));
}

TEST_F(AreaRightsTest, nobodyComesBeforeTheOtherHasLeft) {
  EXPECT_EQ(rights({memberAt(2, -14, 0, 6), memberAt(3, -14, 1, 3), memberAt(4, -12, 0, 1)}), (Numbers{3}))
      << "number 2 must go, number 4 waits";
  EXPECT_EQ(rights({memberAt(2, -13, 0, 6), memberAt(3, -14, 1, 3), memberAt(4, -12, 0, 1)}), (Numbers{3}))
      << "it may have been on its way in";
  EXPECT_EQ(rights({memberAt(2, -12.8, 0, 6), memberAt(3, -14, 1, 3), memberAt(4, -12, 0, 1)}),
            (Numbers{3, 4}));
}

TEST_F(AreaRightsTest, whoLiesThereKeepsItsRight) {
  EXPECT_EQ(rights({memberAt(2, -14, 0, 12, true), memberAt(3, -14, 1, 3), memberAt(4, -14, 2, 2)}),
            (Numbers{2, 4}));
}

TEST_F(AreaRightsTest, neverMoreThanTheRulesAllowAndWhateverOrderTheyWereHeardIn) {
  Random random(5);
  for (int run = 0; run < 2000; ++run) {
    std::vector<TeamMember> members;
    for (int number = 1; number <= 11; ++number) {
      TeamMember member = memberAt(number, random.uniform(-15, -11), random.uniform(-5, 5),
                                   random.uniform(0, 5), random.next() % 4 == 0);
      member.role = static_cast<int>(random.next() % 13);
      members.push_back(member);
    }
    const Numbers all = rights(members);
    std::ranges::rotate(members, members.begin() + run % 11);
    EXPECT_EQ(rights(members), all);
    // Those that are there without the right leave; until then they count.
    const auto there = [&](const TeamMember& m) {
      return m.number != 1 && area.distance(m.pose.position) < parameters.there;
    };
    int come = 0, are = 0;
    for (const TeamMember& member : members) {
      if (there(member)) ++are;
      if (!there(member) && member.number != 1 && all.contains(member.number)) ++come;
    }
    EXPECT_LE(static_cast<int>(all.size()), parameters.most);
    EXPECT_LE(come == 0 ? 0 : come + are, parameters.most - 1);
  }
}

}  // namespace
