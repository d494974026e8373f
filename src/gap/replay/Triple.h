#pragma once
#include "math/Types.h"

namespace plumbline::gap {

// Vectors and matrices of three for innermost loops. Eigen's mean the same, but in a long function its
// products become calls. These are always inlined. Their products add in the order of Eigen's, the last row
// from its end. For the last bit of a product can decide what sticks or slips in a replay, and by it which of
// two answers that are equally good is found.
#define PLUMBLINE_TRIPLE [[gnu::always_inline]] inline

/// A vector. It is copied number by number: copies of the whole by way of the stack would wait for its
/// numbers to be written.
struct Triple {
  double x = 0, y = 0, z = 0;

  Triple() = default;
  PLUMBLINE_TRIPLE Triple(double first, double second, double third) : x(first), y(second), z(third) {}
  // NOLINTBEGIN(modernize-use-equals-default): copied number by number
  PLUMBLINE_TRIPLE Triple(const Triple& a) : x(a.x), y(a.y), z(a.z) {}
  PLUMBLINE_TRIPLE Triple& operator=(const Triple& a) {
    x = a.x;
    y = a.y;
    z = a.z;
    return *this;
  }
  // NOLINTEND(modernize-use-equals-default)
};

PLUMBLINE_TRIPLE Triple tripleOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
PLUMBLINE_TRIPLE Vec3 vectorOf(const Triple& a) { return {a.x, a.y, a.z}; }
PLUMBLINE_TRIPLE Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PLUMBLINE_TRIPLE Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PLUMBLINE_TRIPLE Triple operator*(double factor, const Triple& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
PLUMBLINE_TRIPLE double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
PLUMBLINE_TRIPLE Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A matrix by its columns.
struct TripleMatrix {
  Triple x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

PLUMBLINE_TRIPLE TripleMatrix tripleOf(const Mat3& m) {
  return {tripleOf(Vec3(m.col(0))), tripleOf(Vec3(m.col(1))), tripleOf(Vec3(m.col(2)))};
}
inline Mat3 matrixOf(const TripleMatrix& m) {
  Mat3 result;
  result << vectorOf(m.x), vectorOf(m.y), vectorOf(m.z);
  return result;
}
PLUMBLINE_TRIPLE Triple operator*(const TripleMatrix& m, const Triple& a) {
  return {(m.x.x * a.x + m.y.x * a.y) + m.z.x * a.z, (m.x.y * a.x + m.y.y * a.y) + m.z.y * a.z,
          m.x.z * a.x + (m.y.z * a.y + m.z.z * a.z)};
}
PLUMBLINE_TRIPLE TripleMatrix operator*(const TripleMatrix& m, const TripleMatrix& n) {
  return {m * n.x, m * n.y, m * n.z};
}
PLUMBLINE_TRIPLE TripleMatrix operator+(const TripleMatrix& m, const TripleMatrix& n) {
  return {m.x + n.x, m.y + n.y, m.z + n.z};
}
PLUMBLINE_TRIPLE TripleMatrix transposed(const TripleMatrix& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}

#undef PLUMBLINE_TRIPLE

}  // namespace plumbline::gap
