#include "gap/inference/StoredParts.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class StoredPartsTest : public ::testing::Test {
protected:
  StoredPartsTest() { std::filesystem::remove(path); }
  ~StoredPartsTest() override { std::filesystem::remove(path); }

  BeamResult search() {
    replays += 10;
    ++runs;
    Scored none;
    none.gain = {0};
    none.without = {{}};
    none.fitted.density = 4;
    none.fitted.information.emplace_back(2, 2);
    return {{none}, {}, 5};
  }
  Explanation values() {
    replays += 3;
    ++runs;
    return {causeOfArm("viscous_friction", "elbow", 0.3)};
  }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-stored-parts";
  std::size_t replays = 0;
  int runs = 0;
};

TEST_F(StoredPartsTest, whatIsStoredIsNotRunAgainAndItsReplaysCount) {
  const auto play = [&] {
    replays = runs = 0;
    InferenceMemory memory(path, "mark", arm);
    StoredParts parts(&memory, [&] { return replays; });
    if (!parts.holdsSearch("sets", 1)) parts.uncounted([&] { replays += 100; });
    EXPECT_EQ(parts.search("sets", 1, [&] { return search(); }).kinds, 5u);
    EXPECT_EQ(parts.values("values", [&] { return values(); }),
              Explanation{causeOfArm("viscous_friction", "elbow", 0.3)});
    replays += 2;
    return parts.replays();
  };
  const std::size_t first = play();
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(first, 15u);
  EXPECT_EQ(play(), first);
  EXPECT_EQ(runs, 0);
}

TEST_F(StoredPartsTest, aSearchGivesTheSameWhetherItIsStoredOrNot) {
  StoredParts parts(nullptr, [&] { return replays; });
  EXPECT_FALSE(parts.holdsSearch("sets", 1));
  const BeamResult found = parts.search("sets", 1, [&] { return search(); });
  EXPECT_EQ(found.sets.front().fitted.density, 0);
  EXPECT_TRUE(found.sets.front().fitted.information.empty());
  EXPECT_EQ(parts.replays(), 10u);
}

TEST_F(StoredPartsTest, partsAreNamedByTheGroupThatIsLeftOut) {
  EXPECT_EQ(nameWithout(3), " without group 3");
}

}  // namespace
}  // namespace plumbline::gap
