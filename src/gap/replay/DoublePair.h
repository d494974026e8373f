#pragma once
#include <cstring>

namespace plumbline::gap {

/// Two doubles that are worked on at once, each as it would be alone: for rows and columns of matrices that
/// are too small for Eigen's loops. The compiler makes one operation of two on every machine we know.
using DoublePair = double __attribute__((vector_size(16)));

/// Eight of them, so that enough is under way at once.
struct DoubleEight {
  DoublePair a, b, c, d;
};

/// Reads and writes consecutive doubles, wherever they lie.
template <typename T>
T readDoubles(const double* from) {
  T result;
  std::memcpy(&result, from, sizeof result);
  return result;
}
template <typename T>
void writeDoubles(double* to, const T& values) {
  std::memcpy(to, &values, sizeof values);
}

inline double minusScaled(double from, double factor, double what) { return from - factor * what; }
inline DoublePair minusScaled(DoublePair from, double factor, DoublePair what) {
  return from - factor * what;
}
/// from - factor * what, each.
inline DoubleEight minusScaled(const DoubleEight& from, double factor, const DoubleEight& what) {
  return {minusScaled(from.a, factor, what.a), minusScaled(from.b, factor, what.b),
          minusScaled(from.c, factor, what.c), minusScaled(from.d, factor, what.d)};
}

inline double scaled(double value, double factor) { return value * factor; }
inline DoublePair scaled(DoublePair value, double factor) { return value * factor; }
inline DoubleEight scaled(const DoubleEight& value, double factor) {
  return {value.a * factor, value.b * factor, value.c * factor, value.d * factor};
}

/// to[i] += factor * from[i] for i in [0, n).
inline void addScaled(double* to, double factor, const double* from, long n) {
  long i = 0;
  for (; i + 1 < n; i += 2)
    writeDoubles(to + i, readDoubles<DoublePair>(to + i) + factor * readDoubles<DoublePair>(from + i));
  if (i < n) to[i] += factor * from[i];
}

/// The same for `count` columns of n rows that lie one after the other, the first of them first. factor(k):
/// of the k-th.
template <typename Factor>
void addColumns(double* to, const Factor& factor, const double* columns, long count, long n) {
  long i = 0;
  for (; i + 1 < n; i += 2) {
    auto sum = readDoubles<DoublePair>(to + i);
    for (long k = 0; k < count; ++k) sum = sum + factor(k) * readDoubles<DoublePair>(columns + i + k * n);
    writeDoubles(to + i, sum);
  }
  for (long k = 0; i < n && k < count; ++k) to[i] += factor(k) * columns[i + k * n];
}

}  // namespace plumbline::gap
