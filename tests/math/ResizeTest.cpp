#include "math/Resize.h"

#include <gtest/gtest.h>

#include <new>

namespace plumbline {
namespace {

TEST(Resize, sizesAreAsWanted) {
  Eigen::MatrixXd matrix(2, 3);
  resizeInUse(matrix, 3, 2);
  EXPECT_EQ(matrix.rows(), 3);
  EXPECT_EQ(matrix.cols(), 2);
  Eigen::VectorXd vector;
  resizeInUse(vector, 4);
  EXPECT_EQ(vector.size(), 4);
}

TEST(Resize, whatHasItsSizeKeepsItsValues) {
  Eigen::VectorXd vector(2);
  vector << 1, 2;
  resizeInUse(vector, 2);
  EXPECT_EQ(vector, Eigen::Vector2d(1, 2));
}

// With Eigen's own resize() the vector's memory is freed twice.
TEST(Resize, whereMemoryRunsOutAVectorIsEmpty) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers end a program that asks for as much memory";
#endif
  Eigen::VectorXd vector(10);
  EXPECT_THROW(resizeInUse(vector, Eigen::Index{1} << 50), std::bad_alloc);
  EXPECT_EQ(vector.size(), 0);
}

}  // namespace
}  // namespace plumbline
