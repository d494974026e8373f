#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "framework/Streamable.h"

namespace plumbline {

/// The example of the specification.
class Example : public Streamable {
public:
  int a = 0, b = 3;
  double v = 5.82;
  Eigen::Vector2d p{2, -1.5};
  void stream(InStream* in, OutStream* out) override {
    STREAM(a);
    STREAM(b);
    STREAM(v);
    STREAM("vec", p);
  }
};

enum class Colour : std::uint8_t { red, green, blue, count };

/// One of everything that can be streamed.
class Everything : public Streamable {
public:
  bool flag = true;
  char letter = 'x';
  std::int8_t small = -5;
  std::uint16_t medium = 65535;
  std::int64_t large = -9000000000;
  std::uint64_t huge = ~std::uint64_t{0};
  float real = 0.1f;
  Colour colour = Colour::blue;
  std::string text = "say \"hi\" \\ {now}\n\x01";
  std::array<int, 3> three{1, 2, 3};
  std::vector<Example> list{Example(), Example()};
  std::vector<bool> bits{true, false};
  std::optional<double> some = 1.0 / 3, none;
  std::pair<int, double> pair{7, 1e-9};
  Eigen::Matrix<double, 2, 3> matrix = Eigen::Matrix<double, 2, 3>::Constant(0.5);
  Eigen::Matrix<double, 6, 1> six = Eigen::Matrix<double, 6, 1>::LinSpaced(0, 1);
  Eigen::Isometry3d pose =
      Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  Eigen::Quaterniond turn{0.5, 0.5, -0.5, 0.5};
  void stream(InStream* in, OutStream* out) override {
    STREAM(flag);
    STREAM(letter);
    STREAM(small);
    STREAM(medium);
    STREAM(large);
    STREAM(huge);
    STREAM(real);
    STREAM(colour);
    STREAM(text);
    STREAM(three);
    STREAM(list);
    STREAM(bits);
    STREAM(some);
    STREAM(none);
    STREAM(pair);
    STREAM(matrix);
    STREAM(six);
    STREAM(pose);
    STREAM(turn);
  }
};

}  // namespace plumbline
