#include "gap/replay/Triple.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::gap {
namespace {

Mat3 someMatrix(double seed) {
  Mat3 m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = std::sin(seed + 2.0 * i);
  return m;
}

TEST(TripleTest, meansWhatEigenMeans) {
  const Vec3 a(0.3, -1.2, 0.7), b(2.1, 0.4, -0.9);
  const Mat3 m = someMatrix(1), n = someMatrix(2);
  const Triple s = tripleOf(a), t = tripleOf(b);
  EXPECT_EQ(vectorOf(s), a);
  EXPECT_EQ(vectorOf(s + t), a + b);
  EXPECT_EQ(vectorOf(s - t), a - b);
  EXPECT_EQ(vectorOf(0.5 * s), 0.5 * a);
  EXPECT_NEAR(dot(s, t), a.dot(b), 1e-15);
  EXPECT_LT((vectorOf(cross(s, t)) - a.cross(b)).norm(), 1e-15);
  EXPECT_EQ(matrixOf(tripleOf(m)), m);
  EXPECT_EQ(matrixOf(transposed(tripleOf(m))), m.transpose());
  EXPECT_EQ(matrixOf(tripleOf(m) + tripleOf(n)), m + n);
  EXPECT_LT((vectorOf(tripleOf(m) * s) - m * a).norm(), 1e-15);
  EXPECT_LT((matrixOf(tripleOf(m) * tripleOf(n)) - m * n).norm(), 1e-15);
}

TEST(TripleTest, aMatrixIsTheIdentityAtFirst) { EXPECT_EQ(matrixOf(TripleMatrix()), Mat3::Identity()); }

TEST(TripleTest, theLastRowOfAProductAddsFromItsEnd) {
  // What is left of 1 + 1e-16 - 1 depends on what is added first.
  const TripleMatrix m{{1, 1, 1}, {1e-16, 1e-16, 1e-16}, {-1, -1, -1}};
  const Triple ones{1, 1, 1};
  EXPECT_EQ((m * ones).x, 0);
  EXPECT_EQ((m * ones).y, 0);
  EXPECT_EQ((m * ones).z, 1 + (1e-16 - 1));
}

}  // namespace
}  // namespace plumbline::gap
