#include "framework/RepresentationProblem.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "framework/RepresentationLoader.h"
#include "framework/SharedBlock.h"

namespace plumbline {

struct CheckedPoint : public Streamable {
  double x = 0;
  std::vector<float> trail;
  void stream(InStream* in, OutStream* out) override {
    STREAM(x);
    STREAM(trail);
  }
};

REPRESENTATION(CheckedShares)
class CheckedShares : public CheckedSharesBase {
public:
  int count = 0;
  std::vector<double> shares;
  std::array<CheckedPoint, 2> points;
  SharedBlock<float> map;
  std::string problem() const {
    return count == static_cast<int>(shares.size()) ? "" : "shares: not as many as count says";
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(count);
    STREAM(shares);
    STREAM(points);
    STREAM(map);
  }
};

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(RepresentationProblemTest, namesTheFirstNumberThatIsNotFinite) {
  CheckedShares value;
  EXPECT_EQ(numberProblem(value), "");
  value.map = SharedBlock<float>(20, 1);
  value.map.edit()[19] = nan;
  EXPECT_EQ(numberProblem(value), "map: must be finite, not nan");
  value.points[1].trail = {1, nan};
  EXPECT_EQ(numberProblem(value), "points.trail: must be finite, not nan");
  value.points[1].x = -inf;
  EXPECT_EQ(numberProblem(value), "points.x: must be finite, not -inf");
  value.shares = {0, inf};
  EXPECT_EQ(numberProblem(value), "shares: must be finite, not inf");
}

TEST(RepresentationProblemTest, noPlaceInABlockIsLeftOut) {
  for (const double wrong : {inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t size = 1; size < 40; ++size) {
      CheckedShares value;
      for (std::size_t at = 0; at < size; ++at) {
        bool numbers = false;
        value.shares.assign(size, std::numeric_limits<double>::max());
        value.map = SharedBlock<float>(size, -std::numeric_limits<float>::max());
        ASSERT_TRUE(streamsFiniteNumbers(value, numbers));
        value.shares[at] = wrong;
        ASSERT_FALSE(streamsFiniteNumbers(value, numbers)) << at << " of " << size;
        value.shares[at] = 0;
        value.map.edit()[at] = static_cast<float>(wrong);
        ASSERT_FALSE(streamsFiniteNumbers(value, numbers)) << at << " of " << size;
      }
    }
  }
}

TEST(RepresentationProblemTest, aLoaderKnowsTheRepresentationsOwnCheck) {
  const RepresentationLoader& loader = representationLoader<CheckedShares>();
  CheckedShares value;
  EXPECT_TRUE(loader.hasOwnCheck());
  EXPECT_EQ(loader.problemOf(value), "");
  value.count = 2;
  EXPECT_EQ(loader.problemOf(value), "shares: not as many as count says");
  value.shares = {1, inf};
  EXPECT_EQ(loader.problemOf(value), "shares: must be finite, not inf");
}

}  // namespace
}  // namespace plumbline
