#pragma once
#include <Eigen/Core>

namespace plumbline {

/// Eigen's resize(), but for memory that runs out: an object that is already in use is empty then. Eigen 3.4
/// itself has freed the object's memory when it finds that there is no more, and frees it once more in the
/// destructor.
template <class Matrix>
void resizeInUse(Matrix& matrix, Eigen::Index rows, Eigen::Index columns = 1) {
  if (matrix.rows() == rows && matrix.cols() == columns) return;
  matrix = Matrix();
  matrix.resize(rows, columns);
}

}  // namespace plumbline
