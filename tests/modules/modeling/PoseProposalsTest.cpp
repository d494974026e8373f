#include "modules/modeling/selflocator/PoseProposals.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "support/SyntheticImage.h"

using namespace plumbline;
using namespace plumbline::test;

namespace {

double apart(const Pose2& a, const Pose2& b) { return (a.position - b.position).norm(); }
double turned(const Pose2& a, const Pose2& b) { return std::abs(normalizeAngle(a.heading - b.heading)); }

Pose2 somewhere(Random& random) {
  const double x = random.uniform(-14, 14), y = random.uniform(-9, 9), heading = random.uniform(-pi, pi);
  return Pose2(x, y, heading);
}

TEST(PoseProposals, twoLandmarksGiveTheExactPose) {
  for (const bool leftSide : {true, false}) {
    const FieldMap map(FieldSize{}, leftSide);
    PoseProposals proposals(map);
    SyntheticImage image;
    Random random(3);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
      const Pose2 truth = somewhere(random);
      const Pose2 onServer = leftSide ? truth : Pose2(0, 0, pi) * truth;
      const Pose3 head = headOverGround(random.uniform(-1, 1), 0.1);
      const FieldView view = fieldView(image.see(onField(onServer) * head), head);
      if (view.landmarks.size() < 2) continue;
      ++found;
      const auto& poses = proposals.find(view);
      ASSERT_EQ(poses.size(), 1u);
      EXPECT_LT(apart(poses[0].pose, truth), 1e-6);
      EXPECT_LT(turned(poses[0].pose, truth), 1e-6);
    }
    EXPECT_GT(found, 100);
  }
}

TEST(PoseProposals, oneLandmarkAndLinesGiveThePoseAmongFew) {
  const FieldMap map(FieldSize{}, true);
  PoseProposals proposals(map);
  SyntheticImage image(5);
  Random random(6);
  int tried = 0, first = 0, among = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose2 truth = somewhere(random);
    const Pose3 head = headOverGround(0, 0.2);
    FieldView view = fieldView(image.see(onField(truth) * head), head);
    if (view.landmarks.empty() || view.lines.size() < 3) continue;
    view.landmarks.resize(1);
    ++tried;
    const auto& poses = proposals.find(view);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (apart(poses[k].pose, truth) > 0.3 || turned(poses[k].pose, truth) > 0.05) continue;
      ++among;
      if (k == 0) ++first;
    }
  }
  EXPECT_GT(tried, 200);
  EXPECT_GT(among, 0.95 * tried);
  EXPECT_GT(first, 0.9 * tried);
}

TEST(PoseProposals, linesAloneGiveNothing) {
  const FieldMap map(FieldSize{}, true);
  PoseProposals proposals(map);
  SyntheticImage image;
  const Pose3 head = headOverGround(0, 0.5);
  FieldView view = fieldView(image.see(onField(Pose2(0, -6, 1.6)) * head), head);
  view.landmarks.clear();
  EXPECT_TRUE(proposals.find(view).empty());
  EXPECT_TRUE(proposals.find(FieldView{}).empty());
}

}  // namespace
